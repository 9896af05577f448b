#pragma once

#include <imgui.h>

#include <optional>
#include <string>
#include <vector>

#include "core/fabric/structures.h"
#include "ui/crossing_index.h"

namespace loomlight {

/// How the draft is looked at, and the stroke under way. No truth about the fabric.
struct DraftView {
  float cell = 0;         ///< pixels of a crossing; 0: fit at the next frame
  ImVec2 origin{0, 0};    ///< end and pick at the lower left corner of the canvas
  bool inColour = false;  ///< false: point paper; true: the yarn that lies on top
  int brushYarn = 0;      ///< what a click on a colour bar paints

  enum class Stroke { none, cells, warpBar, weftBar };
  Stroke stroke = Stroke::none;
  bool strokeValue = false;  ///< warp over, for cells
  CrossingIndex strokeStart, strokeLast;

  struct OrderText {  ///< of a thread order, while it is being typed
    bool open = false;
    std::string text, problem;
  };
  OrderText warpOrder, weftOrder;
  std::vector<Structure> palette = structurePalette();

  std::optional<CrossingIndex> hovered;  ///< under the mouse, not wrapped
};

/// Between crossings and pixels: ends to the right, picks upwards, as they lie on the cloth.
struct DraftFrame {
  ImVec2 min, max;  ///< of the canvas, pixels
  float cell;
  ImVec2 origin;

  float x(double end) const { return min.x + static_cast<float>(end - origin.x) * cell; }
  float y(double pick) const { return max.y - static_cast<float>(pick - origin.y) * cell; }  ///< lower edge of the pick
  CrossingIndex at(ImVec2 p) const;
  int firstEnd() const, lastEnd() const, firstPick() const, lastPick() const;  ///< visible, inclusive
};

DraftFrame frameOf(const DraftView& view, ImVec2 min, ImVec2 max);
/// Shows the whole repeat, and a little of how it goes on.
void fitDraft(DraftView& view, const Weave& weave, ImVec2 size, float scale);
void zoomDraft(DraftView& view, ImVec2 min, ImVec2 max, ImVec2 pointer, float clicks);

}  // namespace loomlight
