#include "ui/draft_panel.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/fabric/validate.h"
#include "ui/fields.h"
#include "ui/thread_order.h"

namespace loomlight {
namespace {

/// Paper or colour, beside the heading.
void panelHead(Ui& ui, DraftView& view) {
  static constexpr const char* kNames[] = {"Paper", "Colour"};
  int chosen = view.inColour ? 1 : 0;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  segmentField(ui, {"draft.look", "", "Point paper: dark is warp over. Colour: the yarn that lies on top."}, kNames,
               chosen);
  view.inColour = chosen == 1;
  ImGui::PushFont(ui.fonts.strong);
  const float y = corner.y + 0.5f * (ImGui::GetFrameHeight() - ImGui::GetFontSize());
  ImGui::GetWindowDrawList()->AddText(ImVec2(corner.x, y), packed(ui.theme.text), "Draft");
  ImGui::PopFont();
}

std::optional<Fabric> repeatRows(Ui& ui, const Fabric& fabric, DraftView& view) {
  int ends = fabric.weave.ends(), picks = fabric.weave.picks();
  bool changed = wholeNumberField(
      ui,
      {"draft.ends", "Repeat, ends", "Warp threads until the weave repeats. A larger repeat goes on as the old one."},
      "", 1, Weave::kMaxSide, ends);
  changed |= wholeNumberField(
      ui,
      {"draft.picks", "Repeat, picks", "Weft threads until the weave repeats. A larger repeat goes on as the old one."},
      "", 1, Weave::kMaxSide, picks);
  if (!changed) return std::nullopt;
  Fabric edited = fabric;
  edited.weave = fabric.weave.resized(ends, picks);
  edited.draft.reset();
  view.cell = 0;
  return edited;
}

/// A text such as "4A 2B"; while it is being typed it may say nothing sensible yet.
std::optional<std::vector<int>> orderRow(Ui& ui, const RowText& text, const Fabric& fabric,
                                         const std::vector<int>& sequence, DraftView::OrderText& typing) {
  // A jacquard's sequence could be sixteen thousand letters long: it is shown, but only the bars edit it.
  constexpr size_t kLongest = 512;
  std::string shown = typing.open ? typing.text : threadOrderText(sequence);
  if (shown.size() > kLongest) shown = fmt::format("{} threads", sequence.size());
  const bool changed = textField(ui, text, shown);
  const bool active = ImGui::IsItemActive();
  if (changed) typing.text = shown;
  if (active && !typing.problem.empty())
    problemBelow(ui, ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), typing.problem);
  typing.open = active && (typing.open || changed);
  if (!changed) return std::nullopt;
  try {
    typing.problem.clear();
    return threadOrderFromText(shown, static_cast<int>(fabric.yarns.size()), kMaxSequence);
  } catch (const InputError& error) {
    typing.problem = error.what();
    return std::nullopt;
  }
}

std::optional<Fabric> orderRows(Ui& ui, const Fabric& fabric, DraftView& view) {
  std::optional<Fabric> edited;
  const RowText warp{"draft.warp_order", "Warp order",
                     "Which yarns the ends use, repeating: 4A 2B is four of the first yarn, then two of the second."};
  if (auto sequence = orderRow(ui, warp, fabric, fabric.warpSequence, view.warpOrder)) {
    edited = fabric;
    edited->warpSequence = std::move(*sequence);
  }
  const RowText weft{"draft.weft_order", "Weft order",
                     "Which yarns the picks use, repeating: 4A 2B is four of the first yarn, then two of the second."};
  if (auto sequence = orderRow(ui, weft, fabric, fabric.weftSequence, view.weftOrder)) {
    edited = fabric;
    edited->weftSequence = std::move(*sequence);
  }
  return edited;
}

void drawThumbnail(Ui& ui, const Weave& weave, ImVec2 min, float size) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  constexpr int kCells = 10;
  const float cell = size / kCells;
  draw.AddRectFilled(min, ImVec2(min.x + size, min.y + size), packed(ui.theme.paper), ui.px(2));
  for (int pick = 0; pick < kCells; ++pick)
    for (int end = 0; end < kCells; ++end) {
      if (!weave.warpOver(pick, end)) continue;
      const float x = min.x + cell * static_cast<float>(end), y = min.y + size - cell * static_cast<float>(pick + 1);
      draw.AddRectFilled(ImVec2(x, y), ImVec2(x + cell, y + cell), packed(ui.theme.ink));
    }
}

std::optional<Fabric> structures(Ui& ui, const Fabric& fabric, DraftView& view) {
  std::optional<Fabric> edited;
  heading(ui, "Structures");
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.px(6), ui.px(6)));
  const float size = ui.px(30), gap = ui.px(6), all = ImGui::GetContentRegionAvail().x;
  const int perLine = std::max(1, static_cast<int>((all + gap) / (size + gap)));
  for (int i = 0; i < static_cast<int>(view.palette.size()); ++i) {
    if (i % perLine != 0) ImGui::SameLine(0, gap);
    const Structure& structure = view.palette[static_cast<size_t>(i)];
    const std::string id = "structure/" + structure.name;
    const ImVec2 min = ImGui::GetCursorScreenPos();
    if (ImGui::InvisibleButton(id.c_str(), ImVec2(size, size))) {
      edited = fabric;
      edited->weave = structure.weave;
      edited->draft.reset();
      view.cell = 0;
    }
    ui.probe.recordItem(id);
    drawThumbnail(ui, structure.weave, min, size);
    const bool chosen = structure.weave == fabric.weave;
    const ImVec2 max(min.x + size, min.y + size);
    ImGui::GetWindowDrawList()->AddRect(min, max, packed(ui.theme.line), ui.px(2));
    if (chosen || ImGui::IsItemHovered())
      ImGui::GetWindowDrawList()->AddRect(
          ImVec2(min.x - ui.px(2), min.y - ui.px(2)), ImVec2(max.x + ui.px(2), max.y + ui.px(2)),
          packed(chosen ? ui.theme.accent : ui.theme.textQuiet), ui.px(4), 0, ui.px(1.5f));
    tooltipFor(ui, id.c_str(), min, max, structure.name.c_str());
  }
  ImGui::PopStyleVar();
  return edited;
}

}  // namespace

std::optional<Fabric> draftPanel(Ui& ui, const Fabric& fabric, const std::vector<ImVec4>& yarnColours, DraftView& view,
                                 std::optional<CrossingIndex> lit) {
  panelHead(ui, view);
  const ImVec2 room = ImGui::GetContentRegionAvail();
  // Square where there is room; what stands below keeps its place.
  const float below = 4 * ImGui::GetFrameHeightWithSpacing() + ui.px(250);
  const float height = std::max(ui.px(160), std::min(room.x, room.y - below));
  std::optional<Fabric> edited = draftCanvas(ui, fabric, yarnColours, view, lit, ImVec2(room.x, height));
  if (auto resized = repeatRows(ui, fabric, view)) edited = std::move(resized);
  if (auto ordered = orderRows(ui, fabric, view)) edited = std::move(ordered);
  if (auto structured = structures(ui, fabric, view)) edited = std::move(structured);
  return edited;
}

}  // namespace loomlight
