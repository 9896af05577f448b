#include "ui/draft/draft_layout.h"

#include <algorithm>
#include <cmath>

namespace loomlight {
namespace {

constexpr float kBar = 14, kGap = 4, kRulerHeight = 18, kRulerWidth = 24, kWidestLift = 12;
constexpr float kMostOfRoom = 0.36f;

}  // namespace

DraftLayout layOutDraft(ImVec2 corner, ImVec2 size, int shafts, int columns, bool rulers, float scale) {
  const float bar = std::round(kBar * scale), gap = std::round(kGap * scale);
  const float below = rulers ? std::round(kRulerHeight * scale) : 0;
  const float before = rulers ? std::round(kRulerWidth * scale) : 0;
  DraftLayout layout;
  float above = 0, beside = 0;
  if (shafts > 0 && columns > 0) {
    const float lift = std::min({kWidestLift * scale, kMostOfRoom * size.y / static_cast<float>(shafts),
                                 kMostOfRoom * size.x / static_cast<float>(columns)});
    layout.lift = lift >= 2 ? std::floor(lift) : lift;
    above = std::round(layout.lift * static_cast<float>(shafts)) + gap;
    beside = std::round(layout.lift * static_cast<float>(columns)) + gap;
  }
  const ImVec2 min(corner.x + before + bar + gap, corner.y + bar + gap + above);
  const ImVec2 max(corner.x + size.x - beside, corner.y + size.y - below);
  layout.cloth = {min, max};
  layout.warpBar = {ImVec2(min.x, corner.y), ImVec2(max.x, corner.y + bar)};
  layout.weftBar = {ImVec2(min.x - gap - bar, min.y), ImVec2(min.x - gap, max.y)};
  layout.endRuler = {ImVec2(min.x, max.y), ImVec2(max.x, max.y + below)};
  layout.pickRuler = {ImVec2(corner.x, min.y), ImVec2(corner.x + before, max.y)};
  if (layout.lift > 0) {
    layout.threading = {ImVec2(min.x, min.y - above), ImVec2(max.x, min.y - gap)};
    layout.treadling = {ImVec2(max.x + gap, min.y), ImVec2(corner.x + size.x, max.y)};
    layout.tieUp = {ImVec2(max.x + gap, min.y - above), ImVec2(corner.x + size.x, min.y - gap)};
  }
  return layout;
}

}  // namespace loomlight
