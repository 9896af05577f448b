#include "ui/draft/draft_commands.h"

#include <algorithm>

#include "ui/widgets/keys.h"

namespace loomlight {
namespace {

CellRect wholeRepeat(const Weave& weave) {
  return {0, 0, weave.picks(), weave.ends()};
}

std::optional<Weave> weaveOnClipboard() {
  const char* const text = ImGui::GetClipboardText();
  return text ? weaveFromText(text) : std::nullopt;
}

/// A part that is edited, put back where it was.
template <class Edit>
Weave edited(const Weave& weave, const std::optional<CellRect>& selection, const Edit& edit) {
  if (!selection) return edit(weave);
  return withPart(weave, selection->pick, selection->end, edit(partOf(weave, *selection)));
}

/// Moves towards a side of the screen.
Weave shiftedOnScreen(const Weave& weave, const DraftView& view, const DraftPreferences& preferences, int right,
                      int up) {
  const DraftFrame frame = frameOf(view, preferences, {});
  return edited(weave, view.selection, [&](const Weave& part) {
    return shifted(part, frame.fromRight ? -right : right, frame.fromTop ? -up : up);
  });
}

Weave pasted(const Weave& weave, const Weave& part, DraftView& view) {
  const CrossingIndex corner = view.selection ? CrossingIndex{view.selection->pick, view.selection->end}
                               : view.hovered ? inRepeat(*view.hovered, weave)
                                              : CrossingIndex{};
  view.selection =
      CellRect{corner.pick, corner.end, std::min(part.picks(), weave.picks()), std::min(part.ends(), weave.ends())};
  return withPart(weave, corner.pick, corner.end, part);
}

Weave turned(const Weave& weave, DraftView& view) {
  if (!view.selection) return quarterTurned(weave);
  CellRect& rect = *view.selection;
  const Weave part = quarterTurned(partOf(weave, rect));
  rect.picks = std::min(part.picks(), weave.picks());
  rect.ends = std::min(part.ends(), weave.ends());
  return withPart(weave, rect.pick, rect.end, part);
}

/// The weave after the command; nothing where it is none that edits, or has nothing to work with.
std::optional<Weave> weaveAfter(DraftCommand command, const Weave& weave, const DraftPreferences& preferences,
                                DraftView& view) {
  const CellRect rect = view.selection.value_or(wholeRepeat(weave));
  const Weave weftOver(std::vector<Weave::Row>{{0}});
  switch (command) {
    case DraftCommand::copy:
    case DraftCommand::cut:
      ImGui::SetClipboardText(weaveText(partOf(weave, rect)).c_str());
      if (command == DraftCommand::copy) return std::nullopt;
      return withPattern(weave, rect, weftOver);
    case DraftCommand::paste:
      if (const auto part = weaveOnClipboard()) return pasted(weave, *part, view);
      return std::nullopt;
    case DraftCommand::fillWithCopy:
      if (const auto part = weaveOnClipboard()) return withPattern(weave, rect, *part);
      return std::nullopt;
    case DraftCommand::clear:
      return withPattern(weave, rect, weftOver);
    case DraftCommand::invert:
      return edited(weave, view.selection, inverted);
    case DraftCommand::mirrorEnds:
      return edited(weave, view.selection, mirroredEnds);
    case DraftCommand::mirrorPicks:
      return edited(weave, view.selection, mirroredPicks);
    case DraftCommand::quarterTurn:
      return turned(weave, view);
    case DraftCommand::shiftLeft:
      return shiftedOnScreen(weave, view, preferences, -1, 0);
    case DraftCommand::shiftRight:
      return shiftedOnScreen(weave, view, preferences, 1, 0);
    case DraftCommand::shiftUp:
      return shiftedOnScreen(weave, view, preferences, 0, 1);
    case DraftCommand::shiftDown:
      return shiftedOnScreen(weave, view, preferences, 0, -1);
    case DraftCommand::repeatSelection:
      view.selection.reset();
      view.cell = 0;
      return partOf(weave, rect);
    case DraftCommand::selectAll:
      view.selection = wholeRepeat(weave);
      return std::nullopt;
    case DraftCommand::selectNothing:
      view.selection.reset();
      return std::nullopt;
    case DraftCommand::showBack:
      view.back = !view.back;
      return std::nullopt;
    case DraftCommand::markFloats:
      view.marksFloats = !view.marksFloats;
      return std::nullopt;
    case DraftCommand::structures:
    case DraftCommand::fromPicture:
    case DraftCommand::exportWif:
    case DraftCommand::exportBitmap:
    case DraftCommand::exportDraft:
    case DraftCommand::exportTile:
      break;
  }
  return std::nullopt;
}

}  // namespace

std::optional<DraftCommand> draftKey(const DraftView& view) {
  const ImGuiIO& io = ImGui::GetIO();
  if (io.WantTextInput) return std::nullopt;
  const auto named = [](ImGuiKey key) { return keyPressed(key, true); };
  if (io.KeyCtrl) {
    if (letterPressed('A')) return DraftCommand::selectAll;
    if (letterPressed('C')) return DraftCommand::copy;
    if (letterPressed('X')) return DraftCommand::cut;
    if (letterPressed('V')) return io.KeyShift ? DraftCommand::fillWithCopy : DraftCommand::paste;
    if (letterPressed('I')) return DraftCommand::invert;
    if (letterPressed('D')) return DraftCommand::selectNothing;
    return std::nullopt;
  }
  if (!view.selection) return std::nullopt;
  if (named(ImGuiKey_Delete)) return DraftCommand::clear;
  if (named(ImGuiKey_Escape)) return DraftCommand::selectNothing;
  if (named(ImGuiKey_LeftArrow)) return DraftCommand::shiftLeft;
  if (named(ImGuiKey_RightArrow)) return DraftCommand::shiftRight;
  if (named(ImGuiKey_UpArrow)) return DraftCommand::shiftUp;
  if (named(ImGuiKey_DownArrow)) return DraftCommand::shiftDown;
  return std::nullopt;
}

std::optional<Fabric> runDraftCommand(DraftCommand command, const Fabric& fabric, const DraftPreferences& preferences,
                                      DraftView& view) {
  std::optional<Weave> weave = weaveAfter(command, fabric.weave, preferences, view);
  if (!weave || *weave == fabric.weave) return std::nullopt;
  Rewoven result = rewoven(fabric, std::move(*weave), preferences.loom);
  view.remark = std::move(result.remark);
  return std::move(result.fabric);
}

}  // namespace loomlight
