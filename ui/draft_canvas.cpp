#include "ui/draft_canvas.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "ui/fields.h"

namespace loomlight {
namespace {

constexpr float kBar = 14.0f;  ///< thickness of a colour bar
constexpr float kBarGap = 4.0f;

/// The crossings from a to b, both included, along the straighter axis first where Shift holds a line.
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

std::optional<Fabric> paintCells(const Fabric& fabric, const std::vector<CrossingIndex>& cells, bool warpOver) {
  std::optional<Fabric> edited;
  Weave weave = fabric.weave;
  for (const CrossingIndex& cell : cells) {
    const CrossingIndex c = inRepeat(cell, weave);
    if (weave.at(c.pick, c.end) == warpOver) continue;
    weave = weave.with(c.pick, c.end, warpOver);
    if (!edited) edited = fabric;
  }
  if (!edited) return std::nullopt;
  edited->weave = weave;
  edited->draft.reset();  // drawn by hand, it is no longer what the loom's draft makes
  return edited;
}

std::optional<Fabric> paintBar(const Fabric& fabric, System system, int from, int to, int yarn) {
  std::optional<Fabric> edited;
  for (int i = std::min(from, to); i <= std::max(from, to); ++i) {
    const std::vector<int>& sequence = system == System::warp ? fabric.warpSequence : fabric.weftSequence;
    const size_t at = static_cast<size_t>(wrapped(i, static_cast<int>(sequence.size())));
    if ((edited ? (system == System::warp ? edited->warpSequence : edited->weftSequence) : sequence)[at] == yarn)
      continue;
    if (!edited) edited = fabric;
    (system == System::warp ? edited->warpSequence : edited->weftSequence)[at] = yarn;
  }
  return edited;
}

/// One thread's colour per end above the weave, per pick beside it.
void drawBar(Ui& ui, const Fabric& fabric, const std::vector<ImVec4>& colours, const DraftFrame& frame, System system,
             ImVec2 min, ImVec2 max) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.PushClipRect(min, max, true);
  const bool warp = system == System::warp;
  const int step = std::max(1, static_cast<int>(std::ceil(1.0f / frame.cell)));
  const int first = warp ? frame.firstEnd() : frame.firstPick(), last = warp ? frame.lastEnd() : frame.lastPick();
  const float gap = frame.cell >= 6 * ui.scale ? 1.0f : 0.0f;
  for (int i = first; i <= last; i += step) {
    const int yarn = warp ? fabric.warpYarn(i) : fabric.weftYarn(i);
    ImVec2 a(min.x, std::round(frame.y(i + step))), b(max.x, std::round(frame.y(i)) - gap);
    if (warp) a = ImVec2(std::round(frame.x(i)), min.y), b = ImVec2(std::round(frame.x(i + step)) - gap, max.y);
    const int period = static_cast<int>(warp ? fabric.warpSequence.size() : fabric.weftSequence.size());
    const float opacity = i >= 0 && i < period ? 1.0f : 0.7f;
    draw.AddRectFilled(a, b, packed(colours[static_cast<size_t>(yarn)], opacity));
  }
  draw.PopClipRect();
}

/// Pan with the middle button or with Space held, zoom with the wheel. True while it has the mouse.
bool navigate(DraftView& view, ImVec2 min, ImVec2 max) {
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsItemHovered() && io.MouseWheel != 0) zoomDraft(view, min, max, io.MousePos, io.MouseWheel);
  const bool space = ImGui::IsKeyDown(ImGui::GetKeyIndex(ImGuiKey_Space));
  if (!ImGui::IsItemActive() || !(ImGui::IsMouseDown(ImGuiMouseButton_Middle) || space)) return false;
  view.origin.x -= io.MouseDelta.x / view.cell;
  view.origin.y += io.MouseDelta.y / view.cell;
  return true;
}

std::optional<Fabric> stroke(const Fabric& fabric, DraftView& view, const DraftFrame& frame) {
  const bool left = ImGui::IsMouseDown(ImGuiMouseButton_Left), right = ImGui::IsMouseDown(ImGuiMouseButton_Right);
  if (!ImGui::IsItemActive() || (!left && !right)) {
    view.stroke = DraftView::Stroke::none;
    return std::nullopt;
  }
  const CrossingIndex under = frame.at(ImGui::GetIO().MousePos);
  if (view.stroke != DraftView::Stroke::cells) {
    view.stroke = DraftView::Stroke::cells;
    view.strokeValue = left && !fabric.weave.warpOver(under.pick, under.end);
    view.strokeStart = view.strokeLast = under;
  }
  const CrossingIndex now = constrained(view.strokeStart, under);
  const auto edited = paintCells(fabric, strokeBetween(view.strokeLast, now), view.strokeValue);
  view.strokeLast = now;
  return edited;
}

std::optional<Fabric> barStroke(Ui& ui, const Fabric& fabric, DraftView& view, const DraftFrame& frame, System system,
                                ImVec2 min, ImVec2 max) {
  const bool warp = system == System::warp;
  const char* id = warp ? "draft.warp_bar" : "draft.weft_bar";
  ImGui::SetCursorScreenPos(min);
  ImGui::InvisibleButton(id, ImVec2(max.x - min.x, max.y - min.y));
  ui.probe.recordItem(id);
  tooltipFor(ui, id, min, max,
             warp ? "The yarn of each end (warp thread). Click or drag to give ends the selected yarn."
                  : "The yarn of each pick (weft thread). Click or drag to give picks the selected yarn.");
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
  return paintBar(fabric, system, from, to, view.brushYarn);
}

void ringCrossing(Ui& ui, const DraftFrame& frame, const CrossingIndex& c) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float grow = std::max(0.0f, 0.5f * (6.0f * ui.scale - frame.cell));
  const ImVec2 a(frame.x(c.end) - grow, frame.y(c.pick + 1) - grow),
      b(frame.x(c.end + 1) + grow, frame.y(c.pick) + grow);
  draw.AddRect(a, b, packed(ui.theme.onAccent), 0, 0, ui.px(4));
  draw.AddRect(a, b, packed(ui.theme.accent), 0, 0, ui.px(2));
}

}  // namespace

std::optional<Fabric> draftCanvas(Ui& ui, const Fabric& fabric, const std::vector<ImVec4>& yarnColours, DraftView& view,
                                  std::optional<CrossingIndex> lit, ImVec2 size) {
  const float inset = ui.px(kBar + kBarGap);
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 min(corner.x + inset, corner.y + inset), max(corner.x + size.x, corner.y + size.y);
  if (view.cell <= 0) fitDraft(view, fabric.weave, ImVec2(max.x - min.x, max.y - min.y), ui.scale);

  ImGui::SetCursorScreenPos(min);
  ImGui::InvisibleButton(
      "draft.canvas", ImVec2(max.x - min.x, max.y - min.y),
      ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight | ImGuiButtonFlags_MouseButtonMiddle);
  ui.probe.recordItem("draft.canvas");
  const bool hovered = ImGui::IsItemHovered() || ImGui::IsItemActive();
  const bool navigating = navigate(view, min, max);
  DraftFrame frame = frameOf(view, min, max);
  std::optional<Fabric> edited;
  if (!navigating) edited = stroke(fabric, view, frame);
  view.hovered.reset();
  if (hovered) view.hovered = frame.at(ImGui::GetIO().MousePos);

  const ImVec2 warpMin(min.x, corner.y), warpMax(max.x, corner.y + ui.px(kBar));
  const ImVec2 weftMin(corner.x, min.y), weftMax(corner.x + ui.px(kBar), max.y);
  if (!edited) edited = barStroke(ui, fabric, view, frame, System::warp, warpMin, warpMax);
  if (!edited) edited = barStroke(ui, fabric, view, frame, System::weft, weftMin, weftMax);

  const Fabric& shown = edited ? *edited : fabric;
  drawWeave(ui, shown, yarnColours, frame, view.inColour);
  drawBar(ui, shown, yarnColours, frame, System::warp, warpMin, warpMax);
  drawBar(ui, shown, yarnColours, frame, System::weft, weftMin, weftMax);
  ImGui::GetWindowDrawList()->PushClipRect(min, max, true);
  if (hovered && view.stroke == DraftView::Stroke::none) ringCrossing(ui, frame, *view.hovered);
  if (lit) ringCrossing(ui, frame, inRepeat(*lit, fabric.weave));
  ImGui::GetWindowDrawList()->PopClipRect();
  if (ui.probe.watching()) {
    const CrossingIndex first{0, 0};
    ui.probe.record("draft.cell_0_0", ImVec2(frame.x(first.end), frame.y(1)), ImVec2(frame.x(1), frame.y(0)));
  }
  ImGui::SetCursorScreenPos(ImVec2(corner.x, corner.y + size.y));
  ImGui::Dummy(ImVec2(0, 0));
  return edited;
}

}  // namespace loomlight
