#include <algorithm>
#include <cmath>

#include "ui/draft_canvas.h"

namespace loomlight {
namespace {

/// Below this many pixels a cell, neighbouring cells share one drawn block.
constexpr float kSmallestBlock = 2.0f;

/// Horizontal runs of one colour become one rectangle each, so a zoomed-out jacquard stays a few thousand rectangles.
class RunPainter {
 public:
  RunPainter(ImDrawList& draw, float gap) : draw_(draw), gap_(gap) {}

  void cell(float x0, float x1, float y0, float y1, ImU32 colour) {
    if (colour == colour_ && y0 == y0_ && gap_ == 0) {
      x1_ = x1;
      return;
    }
    flush();
    colour_ = colour;
    x0_ = x0, x1_ = x1, y0_ = y0, y1_ = y1;
  }

  void flush() {
    if (colour_ != 0) draw_.AddRectFilled(ImVec2(x0_ + gap_, y0_ + gap_), ImVec2(x1_ - gap_, y1_ - gap_), colour_);
    colour_ = 0;
  }

 private:
  ImDrawList& draw_;
  float gap_;
  ImU32 colour_ = 0;
  float x0_ = 0, x1_ = 0, y0_ = 0, y1_ = 0;
};

void drawCells(Ui& ui, const Fabric& fabric, const std::vector<ImVec4>& yarnColours, const DraftFrame& frame,
               bool inColour) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  std::vector<ImU32> colours;
  for (const ImVec4& colour : yarnColours) colours.push_back(packed(colour));
  const ImU32 ink = packed(ui.theme.ink);
  const Weave& weave = fabric.weave;
  const int step = std::max(1, static_cast<int>(std::ceil(kSmallestBlock / frame.cell)));
  RunPainter painter(draw, !inColour && frame.cell >= 9 * ui.scale ? ui.scale : 0.0f);
  const int firstPick = frame.firstPick() - wrapped(frame.firstPick(), step);
  const int firstEnd = frame.firstEnd() - wrapped(frame.firstEnd(), step);
  for (int pick = firstPick; pick <= frame.lastPick(); pick += step) {
    const std::span<const uint8_t> row = weave.row(wrapped(pick, weave.picks()));
    const float y1 = std::round(frame.y(pick)), y0 = std::round(frame.y(pick + step));
    for (int end = firstEnd; end <= frame.lastEnd(); end += step) {
      const bool warpOver = row[static_cast<size_t>(wrapped(end, weave.ends()))] != 0;
      ImU32 colour = warpOver ? ink : 0;
      if (inColour) colour = colours[static_cast<size_t>(warpOver ? fabric.warpYarn(end) : fabric.weftYarn(pick))];
      painter.cell(std::round(frame.x(end)), std::round(frame.x(end + step)), y0, y1, colour);
    }
    painter.flush();
  }
}

void drawGrid(Ui& ui, const DraftFrame& frame) {
  const float fade = std::clamp((frame.cell / ui.scale - 6.0f) / 6.0f, 0.0f, 1.0f);
  if (fade <= 0) return;
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  for (int end = frame.firstEnd(); end <= frame.lastEnd() + 1; ++end) {
    const ImU32 line = packed(ui.theme.ink, fade * (wrapped(end, 4) == 0 ? 0.32f : 0.14f));
    const float x = std::round(frame.x(end));
    draw.AddRectFilled(ImVec2(x, frame.min.y), ImVec2(x + 1, frame.max.y), line);
  }
  for (int pick = frame.firstPick(); pick <= frame.lastPick() + 1; ++pick) {
    const ImU32 line = packed(ui.theme.ink, fade * (wrapped(pick, 4) == 0 ? 0.32f : 0.14f));
    const float y = std::round(frame.y(pick));
    draw.AddRectFilled(ImVec2(frame.min.x, y), ImVec2(frame.max.x, y + 1), line);
  }
}

/// What lies outside the one repeat that is edited recedes on point paper; colours need all of the cloth to be judged.
void drawRepeat(Ui& ui, const Weave& weave, const DraftFrame& frame, bool veiled) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImVec2 min(std::round(frame.x(0)), std::round(frame.y(weave.picks())));
  const ImVec2 max(std::round(frame.x(weave.ends())), std::round(frame.y(0)));
  const ImU32 veil = packed(ui.theme.panel, veiled ? 0.6f : 0.0f);
  const float top = std::clamp(min.y, frame.min.y, frame.max.y), bottom = std::clamp(max.y, frame.min.y, frame.max.y);
  draw.AddRectFilled(frame.min, ImVec2(frame.max.x, top), veil);
  draw.AddRectFilled(ImVec2(frame.min.x, bottom), frame.max, veil);
  if (min.x > frame.min.x)
    draw.AddRectFilled(ImVec2(frame.min.x, top), ImVec2(std::min(min.x, frame.max.x), bottom), veil);
  if (max.x < frame.max.x)
    draw.AddRectFilled(ImVec2(std::max(max.x, frame.min.x), top), ImVec2(frame.max.x, bottom), veil);
  draw.AddRect(min, ImVec2(max.x + 1, max.y + 1), packed(ui.theme.accent), 0, 0, std::max(1.0f, 1.5f * ui.scale));
}

}  // namespace

void drawWeave(Ui& ui, const Fabric& fabric, const std::vector<ImVec4>& yarnColours, const DraftFrame& frame,
               bool inColour) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.PushClipRect(frame.min, frame.max, true);
  draw.AddRectFilled(frame.min, frame.max, packed(ui.theme.paper));
  drawCells(ui, fabric, yarnColours, frame, inColour);
  drawGrid(ui, frame);
  drawRepeat(ui, fabric.weave, frame, !inColour);
  draw.PopClipRect();
}

}  // namespace loomlight
