#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/fabric/model/fabric.h"
#include "core/fabric/model/finish.h"
#include "core/geometry/yarn/ply_shape.h"
#include "core/geometry/yarn/pressing.h"
#include "core/geometry/yarn/spool.h"

namespace loomlight {

/// A yarn, resolved to lengths, as the geometry of one system (warp or weft) sees it. Its fibres repeat after `period`
/// cells, over which all twists make whole turns: that is what lets cells share one brick and still join seamlessly.
/// Equal values have equal fibres. Nothing here depends on the weave: an edit of a crossing changes no yarn.
struct YarnGeometry {
  int cords = 1;  ///< of which a cable is twisted; else 1
  int plies = 1;  ///< of each cord
  int fibresPerPly = 1;
  double fibreRadius_mm = 0;  ///< chosen so that the whole number of fibres has exactly the yarn's count
  double rim_mm = 0;          ///< from the outline to the axes of the outermost fibres, at most half the ply's radius
  double fibreDensity_g_cm3 = 0;
  double count_tex = 0;       ///< of the yarn as it lies in the cloth, take-up of its twists and loose hairs included
  double plyRadius_mm = 0;    ///< holds the fibres' volume at the yarn's packing
  double cordRadius_mm = 0;   ///< of a cord, as cords see one another; of a single ply, the ply's
  double radius_mm = 0;       ///< round, hairs excluded: what others rest on, on average as plies turn
  bool monofilament = false;  ///< of one fibre a ply, which nothing presses
  double fibreArea_mm2 = 0;   ///< of all fibres in the section
  std::array<SectionOutline, kFloatStates> pressed{};  ///< where the yarn crosses another, by float state
  SectionOutline free;                                 ///< where nothing presses it
  std::array<double, kFloatStates> rest_mm{};          ///< its part of the distance of the axes there
  int period = 1;                                      ///< cells
  int plyTurns = 0;                                    ///< signed turns over one period; positive is Z (right-handed)
  int yarnTurns = 0;         ///< of the plies about their cord's axis; they turn along rigidly, as they are plied
  int cableTurns = 0;        ///< of the cords about the yarn's axis; they turn along rigidly too
  double pitch_mm = 0;       ///< length of a cell along the yarn
  double crossPitch_mm = 0;  ///< width of a cell across the yarn
  double cellLength_mm = 0;  ///< typical length of axis in a cell: between a float's and a full interlacing's
  double migration = 0;
  double disorder = 0;  ///< of fibres, to their helix: RMS slope, along either axis
  double hairiness_per_mm = 0;
  double hairLength_mm = 0;
  HairLie hairLie;
  double wrappers_per_mm = 0;
  Evenness evenness;
  FibreLayout layout = FibreLayout::packed;
  uint64_t seed = 0;

  /// Of the plies in their cord, and of the cords in the yarn.
  PlyShape plyShape() const { return {plies, plyRadius_mm, monofilament}; }
  PlyShape cordShape() const { return {cords, cordRadius_mm, monofilament}; }
  double diameter_mm() const { return 2 * radius_mm; }
  /// How far from the yarn's axis, round, a place may lie that is so far from the middle of its ply; without a
  /// distance, the ply's own rim.
  double reach_mm() const { return reach_mm(plyRadius_mm); }
  double reach_mm(double inPly_mm) const { return cordShape().reach_mm(plyShape().reach_mm(inPly_mm)); }
  int singles() const { return cords * plies; }  ///< in the whole section
  /// Signed turns of the fibres over one period, as the axis of the yarn sees them.
  int fibreSpin() const { return plyTurns + yarnTurns + cableTurns; }
  /// The section at the end of a float, hairs excluded: of most crossings in most weaves.
  const SectionOutline& usual() const { return pressed[1]; }
  double halfWidth_mm() const { return usual().across * radius_mm; }
  double halfHeight_mm() const { return usual().up * radius_mm; }
  /// Factors on the places of its fibres in a section whose outline has these: they lie within by the rim, unless that
  /// would halve them.
  SectionScale withinOutline(const SectionOutline& outline) const;
  double highest() const;  ///< factor up of its highest section, on its fibres' places
  /// Area of a fibre's section times its density, g per mm of fibre.
  double fibreMass_g_mm() const { return fibreDensity_g_cm3 * 1e-3 * kPi * fibreRadius_mm * fibreRadius_mm; }
  bool operator==(const YarnGeometry&) const = default;
};

/// Yarns that differ only in colour, optics or name are one class: they have the same fibres. Class of each of
/// fabric.yarns, numbered in the order in which they first appear there.
std::vector<int> geometryClasses(const Fabric& fabric);

/// Section and outline of a yarn; pitch and crossPitch are those of its system. Leaves twists, period, cell length,
/// fibre count, fibre radius and rim to resolveTwist() and calibration (yarn_model.h), which need the path.
/// - ply radius: N fibres of volume fraction phi, N pi r^2 takeUp / phi = pi R^2;
/// - plies give way to one another (PlyShape); so do cords;
/// - sections are those of the law (pressing.h), wider and lower the more readily the yarn flattens. One that is too
///   wide for its pitch is squeezed until it touches its neighbours and grows taller, to twice as tall as wide;
///   beyond that (absurd setts) it overlaps them. A monofilament stays round;
/// - felting (feltingOf(), 0..1) opens the sections at crossings again, and widens all sections towards the neighbours.
YarnGeometry outlineYarn(const Yarn& yarn, const Fibre& fibre, double pitch_mm, double crossPitch_mm, double press,
                         double felting);

/// Cells after which any yarn repeats, at most.
inline constexpr int kMaxPeriod = 16;

/// Chooses the period, 4 to kMaxPeriod cells (8 at least where fibres, thickness or place vary along the yarn, 1 where
/// nothing does), and whole turns over it. The yarn's twist is met to within kTwistTolerance in the tangent of the
/// surface helix where any period does, else as nearly as one does: within 1/32 turn a cell. Twists beyond what a yarn
/// can take (kMaxHelixTangent at its surface, kMaxTurnsPerCell) are reduced to that.
void resolveTwist(YarnGeometry& geometry, const Yarn& yarn, double cellLength_mm);

inline constexpr double kTwistTolerance = 0.02;
inline constexpr double kMaxHelixTangent = 2.5;
inline constexpr double kMaxTurnsPerCell = 64;

/// Signed turns per length of yarn, Z positive: of fibres in their ply, plies in their cord, cords in the yarn.
struct Twist {
  double ply_per_mm = 0, yarn_per_mm = 0, cable_per_mm = 0;
};
/// The whole turns that were chosen.
Twist twistOf(const YarnGeometry& geometry);

/// Length of fibre per length of yarn, estimated for fibres spread evenly over their plies.
double estimateTakeUp(const YarnGeometry& geometry, const Twist& twist);

}  // namespace loomlight
