#include "ui/draft/draft_drawing.h"

#include <algorithm>
#include <cmath>

#include "core/base/modulo.h"
#include "core/fabric/yarn/long_floats.h"

namespace loomlight {
namespace {

/// Below this many pixels a cell, neighbouring cells share one drawn block.
constexpr float kSmallestBlock = 2.0f;

/// Horizontal runs of one colour become one rectangle each, so a zoomed-out jacquard stays a few thousand rectangles.
class RunPainter {
 public:
  RunPainter(ImDrawList& draw, float gap) : draw_(draw), gap_(gap) {}

  void cell(const Box& box, ImU32 colour) {
    if (colour == colour_ && box.min.y == run_.min.y && gap_ == 0) {
      run_.min.x = std::min(run_.min.x, box.min.x);
      run_.max.x = std::max(run_.max.x, box.max.x);
      return;
    }
    flush();
    colour_ = colour;
    run_ = box;
  }

  void flush() {
    if (colour_ != 0)
      draw_.AddRectFilled(ImVec2(run_.min.x + gap_, run_.min.y + gap_), ImVec2(run_.max.x - gap_, run_.max.y - gap_),
                          colour_);
    colour_ = 0;
  }

 private:
  ImDrawList& draw_;
  float gap_;
  ImU32 colour_ = 0;
  Box run_;
};

void drawCells(Ui& ui, const Fabric& fabric, const std::vector<ImVec4>& yarnColours, const DraftFrame& frame,
               bool inColour) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  std::vector<ImU32> colours;
  for (const ImVec4& colour : yarnColours) colours.push_back(packed(colour));
  const ImU32 ink = packed(ui.theme.ink);
  const Weave& weave = fabric.weave;
  const int step = std::max(1, static_cast<int>(std::ceil(kSmallestBlock / frame.smaller())));
  RunPainter painter(draw, !inColour && frame.smaller() >= 9 * ui.scale ? ui.scale : 0.0f);
  const int firstPick = frame.firstPick() - wrap(frame.firstPick(), step);
  const int firstEnd = frame.firstEnd() - wrap(frame.firstEnd(), step);
  for (int pick = firstPick; pick <= frame.lastPick(); pick += step) {
    const std::span<const uint8_t> row = weave.row(wrap(pick, weave.picks()));
    for (int end = firstEnd; end <= frame.lastEnd(); end += step) {
      const bool warpOnTop = (row[static_cast<size_t>(wrap(end, weave.ends()))] != 0) != frame.back;
      ImU32 colour = warpOnTop ? ink : 0;
      if (inColour) colour = colours[static_cast<size_t>(warpOnTop ? fabric.warpYarn(end) : fabric.weftYarn(pick))];
      painter.cell(frame.cells(pick, end, step, step), colour);
    }
    painter.flush();
  }
}

void markFloats(Ui& ui, const Fabric& fabric, const DraftFrame& frame, double limit_mm) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const FloatLimits limits = floatLimits(fabric, limit_mm);
  const int step = std::max(1, static_cast<int>(std::ceil(kSmallestBlock / frame.smaller())));
  RunPainter painter(draw, 0);
  const ImU32 mark = packed(ui.theme.warning, 0.75f);
  for (int pick = frame.firstPick(); pick <= frame.lastPick(); pick += step) {
    for (int end = frame.firstEnd(); end <= frame.lastEnd(); end += step)
      painter.cell(frame.cells(pick, end, step, step), floatsTooFar(fabric.weave, pick, end, limits) ? mark : 0);
    painter.flush();
  }
}

void drawGrid(Ui& ui, const DraftFrame& frame) {
  const float fade = std::clamp((frame.smaller() / ui.scale - 6.0f) / 6.0f, 0.0f, 1.0f);
  if (fade <= 0) return;
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const Box& box = frame.box;
  for (int end = frame.firstEnd(); end <= frame.lastEnd() + 1; ++end) {
    const ImU32 line = packed(ui.theme.ink, fade * (wrap(end, 4) == 0 ? 0.32f : 0.14f));
    const float x = std::round(frame.x(end));
    draw.AddRectFilled(ImVec2(x, box.min.y), ImVec2(x + 1, box.max.y), line);
  }
  for (int pick = frame.firstPick(); pick <= frame.lastPick() + 1; ++pick) {
    const ImU32 line = packed(ui.theme.ink, fade * (wrap(pick, 4) == 0 ? 0.32f : 0.14f));
    const float y = std::round(frame.y(pick));
    draw.AddRectFilled(ImVec2(box.min.x, y), ImVec2(box.max.x, y + 1), line);
  }
}

/// What lies outside the one repeat that is edited recedes on point paper; colours need all of the cloth to be judged.
void drawRepeat(Ui& ui, const Weave& weave, const DraftFrame& frame, bool veiled) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const Box repeat = frame.cells(0, 0, weave.picks(), weave.ends()), &box = frame.box;
  const ImU32 veil = packed(ui.theme.panel, veiled ? 0.6f : 0.0f);
  const float top = std::clamp(repeat.min.y, box.min.y, box.max.y);
  const float bottom = std::clamp(repeat.max.y, box.min.y, box.max.y);
  draw.AddRectFilled(box.min, ImVec2(box.max.x, top), veil);
  draw.AddRectFilled(ImVec2(box.min.x, bottom), box.max, veil);
  if (repeat.min.x > box.min.x)
    draw.AddRectFilled(ImVec2(box.min.x, top), ImVec2(std::min(repeat.min.x, box.max.x), bottom), veil);
  if (repeat.max.x < box.max.x)
    draw.AddRectFilled(ImVec2(std::max(repeat.max.x, box.min.x), top), ImVec2(box.max.x, bottom), veil);
  draw.AddRect(repeat.min, ImVec2(repeat.max.x + 1, repeat.max.y + 1), packed(ui.theme.accent), 0, 0,
               std::max(1.0f, 1.5f * ui.scale));
}

}  // namespace

void drawWeave(Ui& ui, const Fabric& fabric, const std::vector<ImVec4>& yarnColours, const DraftFrame& frame,
               bool inColour, double floatLimit_mm) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.PushClipRect(frame.box.min, frame.box.max, true);
  draw.AddRectFilled(frame.box.min, frame.box.max, packed(ui.theme.paper));
  drawCells(ui, fabric, yarnColours, frame, inColour);
  if (floatLimit_mm > 0) markFloats(ui, fabric, frame, floatLimit_mm);
  drawGrid(ui, frame);
  drawRepeat(ui, fabric.weave, frame, !inColour);
  draw.PopClipRect();
}

void drawBar(Ui& ui, const Fabric& fabric, const std::vector<ImVec4>& yarnColours, const DraftFrame& frame,
             System system, const Box& bar) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.PushClipRect(bar.min, bar.max, true);
  const bool warp = system == System::warp;
  const float side = warp ? frame.cell : frame.cellHeight();
  const int step = std::max(1, static_cast<int>(std::ceil(1.0f / side)));
  const int first = warp ? frame.firstEnd() : frame.firstPick(), last = warp ? frame.lastEnd() : frame.lastPick();
  const float gap = side >= 3 * ui.scale ? 1.0f : 0.0f;  // ends are counted as long as a gap leaves anything of them
  for (int i = first; i <= last; i += step) {
    const int yarn = warp ? fabric.warpYarn(i) : fabric.weftYarn(i);
    const Box cell = frame.cells(i, i, step, step);
    const ImVec2 a(warp ? cell.min.x : bar.min.x, warp ? bar.min.y : cell.min.y);
    const ImVec2 b(warp ? cell.max.x - gap : bar.max.x, warp ? bar.max.y : cell.max.y - gap);
    const int period = static_cast<int>(warp ? fabric.warpSequence.size() : fabric.weftSequence.size());
    const float opacity = i >= 0 && i < period ? 1.0f : 0.7f;
    draw.AddRectFilled(a, b, packed(yarnColours[static_cast<size_t>(yarn)], opacity));
    if (gap == 0) continue;
    // Seen between ends as dark, or as light, as the panel too.
    const ImVec2 end(warp ? cell.max.x : bar.max.x, warp ? bar.max.y : cell.max.y);
    draw.AddRectFilled(ImVec2(warp ? b.x : a.x, warp ? a.y : b.y), end, packed(ui.theme.text, 0.35f));
  }
  draw.AddRect(bar.min, bar.max, packed(ui.theme.text, 0.18f));  // ecru is seen on a light panel, black on a dark one
  draw.PopClipRect();
}

void ringCrossing(Ui& ui, const DraftFrame& frame, const CrossingIndex& crossing) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float grow = std::max(0.0f, 0.5f * (6.0f * ui.scale - frame.smaller()));
  const Box cell = frame.cells(crossing.pick, crossing.end);
  const ImVec2 a(cell.min.x - grow, cell.min.y - grow), b(cell.max.x + grow, cell.max.y + grow);
  draw.AddRect(a, b, packed(ui.theme.onAccent), 0, 0, ui.px(4));
  draw.AddRect(a, b, packed(ui.theme.accent), 0, 0, ui.px(2));
}

void ringFloat(Ui& ui, const DraftFrame& frame, const FloatRun& run) {
  const bool warp = run.system == System::warp;
  const Box box =
      warp ? frame.cells(run.first, run.across, run.cells, 1) : frame.cells(run.across, run.first, 1, run.cells);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImVec2 a(box.min.x - ui.px(2), box.min.y - ui.px(2)), b(box.max.x + ui.px(2), box.max.y + ui.px(2));
  draw.AddRect(a, b, packed(ui.theme.onAccent), 0, 0, ui.px(4));
  draw.AddRect(a, b, packed(ui.theme.accent), 0, 0, ui.px(2));
}

void drawSelection(Ui& ui, const DraftFrame& frame, const CellRect& selection) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const Box box = frame.cells(selection.pick, selection.end, selection.picks, selection.ends);
  draw.AddRectFilled(box.min, box.max, packed(ui.theme.accent, 0.25f));
  draw.AddRect(box.min, ImVec2(box.max.x + 1, box.max.y + 1), packed(ui.theme.onAccent), 0, 0, ui.px(3));
  draw.AddRect(box.min, ImVec2(box.max.x + 1, box.max.y + 1), packed(ui.theme.accent), 0, 0, ui.px(1.5f));
}

}  // namespace loomlight
