#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/task.h"
#include "core/geometry/yarn/flyaways.h"
#include "core/geometry/yarn/migration.h"
#include "core/geometry/yarn/yarn_geometry.h"
#include "core/geometry/yarn/yarn_path.h"

namespace loomlight {

/// All that a YarnModel depends on, and nothing more: equal sources have equal models.
struct YarnSource {
  YarnGeometry resolved;  ///< with its twist
  double fibreRadius_um = 0, fibreDensity_g_cm3 = 0;
  double count_tex = 0;
  std::optional<int> fibresPerPly;
  bool sketched = false;  ///< for a first look: packed fibres may overlap, which saves most of the time
  bool operator==(const YarnSource&) const = default;
};

/// How fast something moves or changes along a yarn, and how sharply it turns: bounds on its first and second
/// derivative.
struct RateBounds {
  double slope = 0, bend = 0;
};

/// All that laying the fibres of a cell needs of its yarn, computed once: the section of the plies, the loose fibres.
/// Immutable, and a pure function of its YarnSource.
struct YarnModel {
  YarnSource source;  ///< what it was made of
  YarnGeometry geometry;
  std::vector<Migration> plies;  ///< the fibres of the first cord's; other cords are that one, turned
  int patterns = 0;              ///< of the fibres' ways, in a period; 0 for none
  /// How far the fibres keep apart: 1 where none runs through another, 0 where they do as often as if they lay at
  /// random.
  double separation = 1;
  double bodyReach_mm = 0;  ///< furthest of these fibres from the yarn's axis, not pressed
  double plyReach_mm = 0;   ///< and from the middle of their ply, round
  RateBounds twisting;   ///< of the outermost fibres' places as they turn, mm, by the angle of one turn in the period
  RateBounds wandering;  ///< of places on their way between core and surface, mm, by the patterns made
  double shapeBend_per_mm = 0;  ///< how much plies and cords that give way bend straight ways (PlyShape::bend_per_mm)
  std::vector<Flyaway> flyaways;
  /// Per phase: the loose fibres near that cell, and the shift in cells that brings them there.
  struct FlyawayUse {
    int index;
    double shift;
  };
  std::vector<std::vector<FlyawayUse>> flyawaysAt;
  std::shared_ptr<const Spool> spool;     ///< null where the yarn is even
  std::vector<double> straightLength_mm;  ///< per phase: of all fibres in a straight cell of length cellLength

  size_t fibreCount() const {
    return static_cast<size_t>(geometry.singles()) * static_cast<size_t>(geometry.fibresPerPly);
  }
  /// Factor across of the widest section that stays in the cells beside its own wherever its axis wanders: a few fat
  /// fibres may reach far beyond their ply.
  double widest() const { return (1.499 * geometry.crossPitch_mm - farthestAside_mm()) / bodyReach_mm; }
  /// Of a kind that its spool has; of an even yarn, 0.
  Stretch stretch(int kind) const { return spool ? spool->stretch(kind) : Stretch{}; }
  /// Factor on its radius, where it is thickest.
  double thickest() const { return spool ? spool->largestRadius() : 1.0; }
  double thinnest() const { return spool ? spool->smallestRadius() : 1.0; }
  /// Of its axis from the middle of the cell, where the sett is uneven and threads crowd.
  double farthestAside_mm() const {
    return farthestOffSett_mm() + geometry.evenness.crowding.most_mm + geometry.evenness.displaced_mm;
  }
  double farthestOffSett_mm() const { return spool ? spool->farthestAside_mm() : 0.0; }
  /// Where the yarn lies straight, its section is the usual one.
  PathNode straightNode() const {
    return {0.0f, static_cast<float>(geometry.usual().up), static_cast<float>(geometry.usual().across)};
  }
  /// Furthest that a fibre's surface rises above the yarn's axis, hairs included.
  double reachUp_mm() const;
};

/// Gives a yarn with resolved twist its fibres. Their number is that of the yarn, or count over fineness and take-up,
/// rounded; their radius then makes the yarn weigh its count exactly, take-up and loose fibres included. A yarn of more
/// than kMaxFibresPerPly fibres a ply, or kMaxFibresInYarn in all, or with more than kMaxPointsPerCell points in a
/// straight cell, gets thicker fibres instead, each for a bundle: the mass stays. A given number of fibres keeps its
/// radius, and the count follows. Once the task is stopped the model is made in no time, to be thrown away.
std::shared_ptr<const YarnModel> makeYarnModel(const YarnSource& source, const Task& task = oneThread());
/// The same yarn, spun more or less evenly: its fibres lie as they did.
std::shared_ptr<const YarnModel> withEvenness(const YarnModel& model, const Evenness& evenness);
/// Whether to sketch the yarn first saves time that is felt.
bool isWorthSketching(const YarnSource& source);
YarnSource sourceOf(const YarnGeometry& resolved, const Yarn& yarn, const Fibre& fibre);
inline constexpr int kMaxFibresPerPly = 2000;
inline constexpr int kMaxPointsPerCell = 400'000;

}  // namespace loomlight
