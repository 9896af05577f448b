#pragma once

#include <imgui.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "core/fabric/weave/draft_edit.h"
#include "core/fabric/weave/structures.h"
#include "core/fabric/weave/weave_edit.h"
#include "core/fabric/yarn/long_floats.h"
#include "ui/draft/colour_order_tools.h"
#include "ui/draft/order_field.h"
#include "ui/widgets/crossing_index.h"
#include "ui/widgets/panel_controls.h"

namespace loomlight {

/// How a designer likes drafts; kept between sessions.
struct DraftPreferences {
  /// The corner of the drawdown in which end 1 and pick 1 are.
  enum class Origin { bottomLeft, bottomRight, topLeft, topRight };
  Origin origin = Origin::bottomLeft;
  bool startsRight() const { return origin == Origin::bottomRight || origin == Origin::topRight; }
  bool startsAtTop() const { return origin == Origin::topLeft || origin == Origin::topRight; }
  bool inches = false;  ///< lengths and setts; else cm
  bool rulers = false;
  LoomLimits loom;
  double longFloat_mm = kUsualFloatLimit_mm;  ///< floats beyond it are marked
  friend bool operator==(const DraftPreferences&, const DraftPreferences&) = default;
};

/// The draft shown beside a weave that has none of its own. Worked out once for each weave, not for each frame.
class ShownDraft {
 public:
  const DerivedDraft& of(const Weave& weave, const LoomLimits& limits, bool liftplan);

 private:
  std::optional<Weave> weave_;
  LoomLimits limits_;
  bool liftplan_ = false;
  DerivedDraft derived_;
};

/// How the draft is looked at, and the stroke under way. No truth about the fabric.
struct DraftView {
  float cell = 0;                      ///< pixels of a crossing across; 0: fit at the next frame
  std::vector<std::string> yarnNames;  ///< what yarns are called, set before each frame
  float aspect = 1;                    ///< height of a crossing over its width: that of the cloth, by its sett
  ImVec2 origin{0, 0};                 ///< end and pick at the corner of the canvas where they start
  bool inColour = false;               ///< false: point paper; true: the yarn that lies on top
  bool back = false;                   ///< the cloth turned over like a page
  bool marksFloats = false;            ///< those longer than DraftPreferences::longFloat_mm

  /// How a weave that has no draft of its own is shown; jacquard: by itself.
  enum class Loom { treadles, liftplan, jacquard };
  Loom loom = Loom::treadles;
  ShownDraft shownDraft;
  int laidShafts = 0, laidColumns = 0;  ///< what room was made for; it stays while a stroke lasts
  std::string remark;                   ///< what the last edit did to the draft, to be said until the next

  enum class Tool { draw, select };
  Tool tool = Tool::draw;
  enum class Stroke { none, cells, selection, warpBar, weftBar, threading, tieUp, treadling };
  Stroke stroke = Stroke::none;
  bool strokeValue = false;  ///< what cells get
  /// Of the drawdown; of another part, its line as `end` and its number as `pick`.
  CrossingIndex strokeStart, strokeLast;
  std::optional<CellRect> selection;  ///< starts within the repeat, and is no larger

  enum class Page { structures, loom, colours };
  Page page = Page::structures;
  PageScroll scroll;
  bool libraryWanted = false;  ///< the library of structures was asked for in this frame

  OrderText warpOrder, weftOrder;
  ColourOrderView colourOrder;
  std::vector<Structure> palette = structurePalette();

  std::optional<CrossingIndex> hovered;  ///< under the mouse, not wrapped
  ImVec2 seen{0, 0};                     ///< ends and picks that the canvas has room for
  std::optional<FloatRun> chosenFloat;   ///< of the long floats, the one that is looked at
};

struct Box {
  ImVec2 min, max;
  float width() const { return max.x - min.x; }
  float height() const { return max.y - min.y; }
};

/// Between crossings and pixels. Ends and picks count away from the corner where they start.
struct DraftFrame {
  Box box;  ///< of the drawdown, pixels
  float cell = 1, aspect = 1;
  ImVec2 origin;
  bool fromRight = false, fromTop = false;
  bool back = false;  ///< warp over is weft over

  float cellHeight() const { return cell * aspect; }
  float smaller() const { return cell * std::min(1.0f, aspect); }  ///< side of a crossing
  float x(double end) const;                                       ///< the near edge of the end
  float y(double pick) const;
  /// Of a block of crossings, to whole pixels.
  Box cells(int pick, int end, int picks = 1, int ends = 1) const;
  CrossingIndex at(ImVec2 p) const;
  int firstEnd() const, lastEnd() const, firstPick() const, lastPick() const;  ///< visible, inclusive
};

DraftFrame frameOf(const DraftView& view, const DraftPreferences& preferences, const Box& box);
/// Height over width of a crossing at a sett, as far as it can be drawn.
float cellAspect(const Fabric& fabric);
/// Shows the whole repeat, and a little of how it goes on.
void fitDraft(DraftView& view, const Weave& weave, ImVec2 size, float scale);
/// Brings a float into the middle, as near as it has been looked at.
void showFloat(DraftView& view, const FloatRun& run);
/// The crossing under the pointer stays there.
void zoomDraft(DraftView& view, const DraftFrame& frame, ImVec2 pointer, float clicks);

/// The selection between two crossings, both included, as DraftView holds it.
CellRect selectionBetween(const CrossingIndex& a, const CrossingIndex& b, const Weave& weave);

/// Of a selection, whether the crossing is in it; both may go over the edge of the repeat.
bool isSelected(const CellRect& selection, const CrossingIndex& crossing, const Weave& weave);

/// The draft shown beside the weave; null for a jacquard, and `remark` says why where there is a reason.
const Draft* draftBeside(const Fabric& fabric, const DraftPreferences& preferences, DraftView& view,
                         std::string* remark = nullptr);

}  // namespace loomlight
