#include "ui/draft_view.h"

#include <algorithm>
#include <cmath>

namespace loomlight {

CrossingIndex DraftFrame::at(ImVec2 p) const {
  return {static_cast<int>(std::floor((max.y - p.y) / cell + origin.y)),
          static_cast<int>(std::floor((p.x - min.x) / cell + origin.x))};
}

int DraftFrame::firstEnd() const {
  return static_cast<int>(std::floor(origin.x));
}
int DraftFrame::lastEnd() const {
  return static_cast<int>(std::ceil(origin.x + (max.x - min.x) / cell)) - 1;
}
int DraftFrame::firstPick() const {
  return static_cast<int>(std::floor(origin.y));
}
int DraftFrame::lastPick() const {
  return static_cast<int>(std::ceil(origin.y + (max.y - min.y) / cell)) - 1;
}

DraftFrame frameOf(const DraftView& view, ImVec2 min, ImVec2 max) {
  return {min, max, view.cell, view.origin};
}

void fitDraft(DraftView& view, const Weave& weave, ImVec2 size, float scale) {
  // A tiny repeat is shown several times over: what a weave looks like shows only where it repeats.
  constexpr int kFewestCells = 12;
  const float ends = static_cast<float>(std::max(weave.ends(), kFewestCells));
  const float picks = static_cast<float>(std::max(weave.picks(), kFewestCells));
  const float cell = std::min(size.x / ends, size.y / picks);
  view.cell = cell >= 4 * scale ? std::floor(cell) : std::max(cell, 0.02f);
  view.origin = ImVec2(0, 0);
}

void zoomDraft(DraftView& view, ImVec2 min, ImVec2 max, ImVec2 pointer, float clicks) {
  const float smallest = 0.02f, largest = 96.0f;
  const float old = view.cell;
  view.cell = std::clamp(old * std::exp(0.16f * clicks), smallest, largest);
  const float fromLeft = pointer.x - min.x, fromBottom = max.y - pointer.y;
  view.origin.x += fromLeft / old - fromLeft / view.cell;
  view.origin.y += fromBottom / old - fromBottom / view.cell;
  // Far from the origin a float no longer tells neighbouring cells apart; nobody weaves there.
  constexpr float kFar = 1e5f;
  view.origin.x = std::clamp(view.origin.x, -kFar, kFar);
  view.origin.y = std::clamp(view.origin.y, -kFar, kFar);
}

}  // namespace loomlight
