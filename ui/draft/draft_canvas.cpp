#include "ui/draft/draft_canvas.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/base/modulo.h"
#include "ui/draft/draft_commands.h"
#include "ui/draft/draft_drawing.h"
#include "ui/draft/draft_parts.h"
#include "ui/draft/float_row.h"
#include "ui/draft/weave_menu.h"
#include "ui/widgets/field_row.h"
#include "ui/widgets/keys.h"
#include "ui/words/draft_words.h"

namespace loomlight {
namespace {

/// The crossings from a to b, both included.
std::vector<CrossingIndex> strokeBetween(CrossingIndex a, CrossingIndex b) {
  std::vector<CrossingIndex> cells;
  const int steps = std::max(std::abs(b.pick - a.pick), std::abs(b.end - a.end));
  for (int i = 0; i <= steps; ++i) {
    const double t = steps == 0 ? 0 : static_cast<double>(i) / steps;
    cells.push_back({a.pick + static_cast<int>(std::lround(t * (b.pick - a.pick))),
                     a.end + static_cast<int>(std::lround(t * (b.end - a.end)))});
  }
  return cells;
}

CrossingIndex constrained(CrossingIndex start, CrossingIndex now) {
  if (!ImGui::GetIO().KeyShift) return now;
  if (std::abs(now.pick - start.pick) > std::abs(now.end - start.end)) return {now.pick, start.end};
  return {start.pick, now.end};
}

/// The weave after the stroke; nothing where that changes nothing.
std::optional<Weave> paintCells(const Weave& weave, const std::vector<CrossingIndex>& cells, bool warpOver) {
  std::optional<Weave> edited;
  for (const CrossingIndex& cell : cells) {
    const CrossingIndex c = inRepeat(cell, weave);
    if ((edited ? *edited : weave).at(c.pick, c.end) == warpOver) continue;
    edited = (edited ? *edited : weave).with(c.pick, c.end, warpOver);
  }
  return edited;
}

std::optional<Fabric> paintBar(const Fabric& fabric, System system, int from, int to, int yarn) {
  std::optional<Fabric> edited;
  for (int i = std::min(from, to); i <= std::max(from, to); ++i) {
    const std::vector<int>& sequence = system == System::warp ? fabric.warpSequence : fabric.weftSequence;
    const size_t at = static_cast<size_t>(wrap(i, static_cast<int>(sequence.size())));
    if ((edited ? (system == System::warp ? edited->warpSequence : edited->weftSequence) : sequence)[at] == yarn)
      continue;
    if (!edited) edited = fabric;
    (system == System::warp ? edited->warpSequence : edited->weftSequence)[at] = yarn;
  }
  return edited;
}

/// Pan with the middle button or with Space held, zoom with the wheel. True while it has the mouse.
bool navigate(DraftView& view, const DraftFrame& frame) {
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsItemHovered() && io.MouseWheel != 0) zoomDraft(view, frame, io.MousePos, io.MouseWheel);
  const bool space = keyHeld(ImGuiKey_Space);
  if (!ImGui::IsItemActive() || !(ImGui::IsMouseDown(ImGuiMouseButton_Middle) || space)) return false;
  view.origin.x += (frame.fromRight ? 1.0f : -1.0f) * io.MouseDelta.x / view.cell;
  view.origin.y += (frame.fromTop ? -1.0f : 1.0f) * io.MouseDelta.y / frame.cellHeight();
  return true;
}

/// A stroke of the brush, or the pull of a selection.
std::optional<Weave> stroke(const Weave& weave, DraftView& view, const DraftFrame& frame) {
  using Stroke = DraftView::Stroke;
  const bool left = ImGui::IsMouseDown(ImGuiMouseButton_Left);
  const bool right = view.tool == DraftView::Tool::draw && ImGui::IsMouseDown(ImGuiMouseButton_Right);
  if (!ImGui::IsItemActive() || (!left && !right)) {
    if (view.stroke == Stroke::cells || view.stroke == Stroke::selection) view.stroke = Stroke::none;
    return std::nullopt;
  }
  const CrossingIndex under = frame.at(ImGui::GetIO().MousePos);
  if (view.stroke != Stroke::cells && view.stroke != Stroke::selection) {
    const bool selects = left && (view.tool == DraftView::Tool::select || ImGui::GetIO().KeyCtrl);
    view.stroke = selects ? Stroke::selection : Stroke::cells;
    view.strokeValue = left ? !weave.warpOver(under.pick, under.end) : frame.back;
    view.strokeStart = view.strokeLast = under;
  }
  if (view.stroke == Stroke::selection) {
    view.selection = selectionBetween(view.strokeStart, under, weave);
    return std::nullopt;
  }
  const CrossingIndex now = constrained(view.strokeStart, under);
  auto edited = paintCells(weave, strokeBetween(view.strokeLast, now), view.strokeValue);
  view.strokeLast = now;
  return edited;
}

/// While selecting, the right button asks what to do: with the selection it is in, or else with the crossing there.
std::optional<Fabric> askWhatToDo(Ui& ui, const Fabric& fabric, const DraftPreferences& preferences, DraftView& view,
                                  const DraftFrame& frame) {
  if (view.tool == DraftView::Tool::select && ImGui::IsItemClicked(ImGuiMouseButton_Right)) {
    const CrossingIndex here = frame.at(ImGui::GetIO().MousePos);
    if (!view.selection || !isSelected(*view.selection, here, fabric.weave))
      view.selection = selectionBetween(here, here, fabric.weave);
    openSelectionMenu();
  }
  const auto command = selectionMenu(ui, view.selection.has_value());
  return command ? runDraftCommand(*command, fabric, preferences, view) : std::nullopt;
}

std::optional<Fabric> barStroke(Ui& ui, const Fabric& fabric, DraftView& view, const DraftFrame& frame, System system,
                                const Box& bar, int brushYarn) {
  const bool warp = system == System::warp;
  const char* id = warp ? "draft.warp_bar" : "draft.weft_bar";
  ImGui::SetCursorScreenPos(bar.min);
  ImGui::InvisibleButton(id, ImVec2(bar.width(), bar.height()));
  ui.probe.recordItem(id);
  const auto mine = warp ? DraftView::Stroke::warpBar : DraftView::Stroke::weftBar;
  if (!ImGui::IsItemActive()) {
    if (view.stroke == mine) view.stroke = DraftView::Stroke::none;
    return std::nullopt;
  }
  const CrossingIndex under = frame.at(ImGui::GetIO().MousePos);
  if (view.stroke != mine) view.strokeLast = under;
  view.stroke = mine;
  const int from = warp ? view.strokeLast.end : view.strokeLast.pick, to = warp ? under.end : under.pick;
  view.strokeLast = under;
  return paintBar(fabric, system, from, to, brushYarn);
}

/// What a bar of colours shows under the mouse: said in the line below, as nothing may cover what is drawn at.
std::string barUnderMouse(const Fabric& fabric, const std::vector<std::string>& yarnNames, const DraftFrame& frame,
                          const DraftLayout& layout) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const auto under = [](const Box& box) { return ImGui::IsMouseHoveringRect(box.min, box.max); };
  const CrossingIndex at = frame.at(mouse);
  const auto nameOf = [&](int yarn) -> const std::string& { return yarnNames[static_cast<size_t>(yarn)]; };
  if (under(layout.warpBar)) return fmt::format(words::draft::endOfBar, at.end + 1, nameOf(fabric.warpYarn(at.end)));
  if (under(layout.weftBar)) return fmt::format(words::draft::pickOfBar, at.pick + 1, nameOf(fabric.weftYarn(at.pick)));
  return {};
}

/// Room for the parts; it does not change under the brush.
DraftLayout layOut(Ui& ui, const Draft* draft, const DraftPreferences& preferences, DraftView& view, ImVec2 size) {
  if (view.stroke == DraftView::Stroke::none) {
    view.laidShafts = draft ? draft->shafts : 0;
    view.laidColumns = !draft ? 0 : draft->liftplan.empty() ? draft->treadles : draft->shafts;
  }
  return layOutDraft(ImGui::GetCursorScreenPos(), size, view.laidShafts, view.laidColumns, preferences.rulers,
                     ui.scale);
}

/// What is under the mouse, or what became of the draft; the line is always there, so nothing moves.
void sayLine(Ui& ui, DraftView& view, const std::string& place, const std::string& remark) {
  ImGui::PushFont(ui.fonts.small);
  const bool warns = place.empty() && !remark.empty();
  const std::string& said = place.empty() ? remark : place;
  ImGui::PushStyleColor(ImGuiCol_Text, warns ? ui.theme.warning : ui.theme.textQuiet);
  ImGui::TextUnformatted(said.empty() ? " " : shortened(said, ImGui::GetContentRegionAvail().x).c_str());
  ImGui::PopStyleColor();
  ImGui::PopFont();
  ui.probe.recordItem("draft.line");
  if (warns) tellIfClipped(ui, "draft.line", said.c_str(), ImGui::GetContentRegionAvail().x + ui.px(1));
  if (!said.empty())
    tooltipFor(ui, "draft.line", ImGui::GetItemRectMin(), ImGui::GetItemRectMax(),
               warns ? fmt::format(words::draft::setUnderLoom, remark).c_str() : said.c_str());
  if (warns && ImGui::IsItemClicked()) view.page = DraftView::Page::loom;
  ui.probe.fact("draft.remark", remark);
  ui.probe.fact("draft.said", said);
}

void tellProbe(Ui& ui, const DraftView& view, const Draft* draft, const DraftFrame& frame) {
  if (!ui.probe.watching()) return;
  const Box first = frame.cells(0, 0);
  ui.probe.record("draft.cell_0_0", first.min, first.max);
  ui.probe.fact("draft.kind", !draft ? "jacquard" : draft->liftplan.empty() ? "treadles" : "liftplan");
  ui.probe.fact("draft.side", frame.back ? "back" : "face");
  ui.probe.fact("draft.shafts", std::to_string(draft ? draft->shafts : 0));
  ui.probe.fact("draft.treadles", std::to_string(draft ? draft->treadles : 0));
  const auto& s = view.selection;
  ui.probe.fact("draft.selection", s ? fmt::format("{} {} {} {}", s->pick, s->end, s->picks, s->ends) : "none");
}

/// What is under the mouse, in words: a crossing, a yarn of a bar, or a part of the draft.
std::string underMouse(const Fabric& fabric, const Draft* draft, const DraftView& view, const DraftFrame& frame,
                       const DraftLayout& layout) {
  if (view.hovered) {
    const CrossingIndex c = inRepeat(*view.hovered, fabric.weave);
    return fmt::format(words::draft::crossing, c.end + 1, c.pick + 1);
  }
  std::string under = barUnderMouse(fabric, view.yarnNames, frame, layout);
  return under.empty() && draft ? partUnderMouse(*draft, frame, layout) : under;
}

/// The drawdown with its bars and rulers, and what is marked in it. `lit`: the crossing that is seen in the picture.
void drawCanvas(Ui& ui, const Fabric& shown, const std::vector<ImVec4>& yarnColours,
                const DraftPreferences& preferences, const DraftView& view, const DraftFrame& frame,
                const DraftLayout& layout, std::optional<CrossingIndex> lit) {
  drawWeave(ui, shown, yarnColours, frame, view.inColour, view.marksFloats ? preferences.longFloat_mm : 0);
  drawBar(ui, shown, yarnColours, frame, System::warp, layout.warpBar);
  drawBar(ui, shown, yarnColours, frame, System::weft, layout.weftBar);
  if (preferences.rulers) {
    drawRuler(ui, shown, frame, System::weft, preferences.inches, layout.endRuler);
    drawRuler(ui, shown, frame, System::warp, preferences.inches, layout.pickRuler);
  }
  ImGui::GetWindowDrawList()->PushClipRect(layout.cloth.min, layout.cloth.max, true);
  if (view.selection) drawSelection(ui, frame, *view.selection);
  if (view.marksFloats && view.chosenFloat) ringFloat(ui, frame, *view.chosenFloat);
  if (view.hovered && view.stroke == DraftView::Stroke::none) ringCrossing(ui, frame, *view.hovered);
  if (lit) ringCrossing(ui, frame, *lit);
  ImGui::GetWindowDrawList()->PopClipRect();
}

}  // namespace

std::optional<Fabric> draftCanvas(Ui& ui, const Fabric& fabric, const std::vector<ImVec4>& yarnColours, int brushYarn,
                                  const DraftPreferences& preferences, DraftView& view,
                                  std::optional<CrossingIndex> lit, ImVec2 size) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  std::string remark;
  const Draft* draft = draftBeside(fabric, preferences, view, &remark);
  const DraftLayout layout = layOut(ui, draft, preferences, view, size);
  const Box& cloth = layout.cloth;
  view.aspect = cellAspect(fabric);
  if (view.cell <= 0) fitDraft(view, fabric.weave, ImVec2(cloth.width(), cloth.height()), ui.scale);

  ImGui::SetCursorScreenPos(cloth.min);
  ImGui::InvisibleButton(
      "draft.canvas", ImVec2(cloth.width(), cloth.height()),
      ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight | ImGuiButtonFlags_MouseButtonMiddle);
  ui.probe.recordItem("draft.canvas");
  const bool hovered = ImGui::IsItemHovered() || ImGui::IsItemActive();
  const bool navigating = navigate(view, frameOf(view, preferences, cloth));
  const DraftFrame frame = frameOf(view, preferences, cloth);
  view.seen = ImVec2(cloth.width() / frame.cell, cloth.height() / frame.cellHeight());
  std::optional<Fabric> edited = askWhatToDo(ui, fabric, preferences, view, frame);
  if (auto weave = navigating || edited ? std::nullopt : stroke(fabric.weave, view, frame)) {
    Rewoven result = rewoven(fabric, std::move(*weave), preferences.loom);
    edited = std::move(result.fabric);
    view.remark = std::move(result.remark);
  }
  view.hovered.reset();
  if (hovered) view.hovered = frame.at(ImGui::GetIO().MousePos);
  std::string under = underMouse(fabric, draft, view, frame, layout);

  if (!edited) edited = barStroke(ui, fabric, view, frame, System::warp, layout.warpBar, brushYarn);
  if (!edited) edited = barStroke(ui, fabric, view, frame, System::weft, layout.weftBar, brushYarn);
  const Draft* shownDraft = !edited ? draft : draftBeside(*edited, preferences, view);
  if (shownDraft && layout.lift > 0)
    if (auto made = draftParts(ui, *shownDraft, view, frame, layout)) {
      edited = withDraft(fabric, std::move(*made));
      view.remark.clear();
    }

  const Fabric& shown = edited ? *edited : fabric;
  if (lit) lit = inRepeat(*lit, fabric.weave);
  drawCanvas(ui, shown, yarnColours, preferences, view, frame, layout, lit);
  tellProbe(ui, view, draftBeside(shown, preferences, view), frame);

  ImGui::SetCursorScreenPos(ImVec2(corner.x, corner.y + size.y));
  const std::string& became = remark.empty() ? view.remark : remark;
  if (under.empty() && became.empty() && view.marksFloats)
    under =
        view.chosenFloat ? floatText(*view.chosenFloat) : fmt::format(words::floats::marked, preferences.longFloat_mm);
  sayLine(ui, view, under, became);
  return edited;
}

}  // namespace loomlight
