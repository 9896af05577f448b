#pragma once

#include <vector>

#include "core/geometry/yarn/yarn_geometry.h"

namespace loomlight {

/// A loose fibre: an end that leaves the body of the yarn and rises linearly in radius, angle and length, or a loop
/// that leaves and comes back (Zhao et al. 2016, section 4.3); most ends do not stand free, but lie on the face or the
/// back of the cloth, over the yarn's neighbours, each in a direction of its own. Positions along the yarn count cells
/// from the start of the period; 0 <= start < period, and `end` may lie beyond the period, where the yarn repeats.
struct Flyaway {
  double start = 0, end = 0;
  double angle = 0, angleSpan = 0;  ///< about the yarn's axis, from up (z) towards u
  double root_mm = 0;               ///< radius in the round yarn where it leaves
  double rise_mm = 0;               ///< how far it reaches beyond the root; where it lies, over the yarn's crown
  double drift_mm = 0;              ///< where it lies: how far across the yarn it goes
  double curl = 0;                  ///< where it lies: how far it swings aside on the way, as a share of that
  bool loop = false, lies = false;
  bool isRaised = false;   ///< of one that lies: it leans, and rises to its tip
  bool backwards = false;  ///< rises towards its start
};

/// The loose fibres of one period: hairiness_per_mm of them, three in five ends and the rest loops (the ratio of Zhao's
/// cotton), reaching an exponentially distributed distance of at most hairLength_mm; four ends in five lie, or all are
/// raised (HairLie). Then the wrapper fibres, whose turns keep to the surface. Fewer of either where they would be more
/// than kMaxFlyaways, or longer in all than `budget_mm`. A pure function of its arguments.
std::vector<Flyaway> placeFlyaways(const YarnGeometry& geometry, double budget_mm);
inline constexpr int kMaxFlyaways = 4096;

/// How high the yarn's axis lies in the cloth, and would if the yarn were uppermost there and even; how much higher its
/// top lies, as it is thick there; and its section.
struct AxisPosition {
  double here_mm = 0, crown_mm = 0, lift_mm = 0;
  SectionScale section;
  double aside_mm = 0;  ///< from the middle of the cell
};

/// Where a loose fibre is at `t` cells, start <= t <= end: from the middle of the cell, u, and from the yarn's axis,
/// up; mm.
glm::dvec2 flyawayOffset(const Flyaway& flyaway, const YarnGeometry& geometry, double t, const AxisPosition& axis);

}  // namespace loomlight
