#pragma once

#include <array>

namespace loomlight {

/// How a yarn lies at a crossing along its way: the number of its neighbouring crossings, of two, at which it lies on
/// the same side. 0 where it bends both ways, 1 at the end of a float, 2 inside one.
inline constexpr int kFloatStates = 3;

/// A yarn's outline in the cloth: factors on the height and width of the round one.
struct SectionOutline {
  double up = 1, across = 1;
  bool operator==(const SectionOutline&) const = default;
};

/// Factors that take the places of a yarn's fibres from the round section to where they lie in the cloth, within its
/// outline there (YarnGeometry::withinOutline).
struct SectionScale {
  double up = 1, across = 1;
};

/// How a yarn gives way where it crosses another, over its radius at the packing that the law takes it at.
struct Yielding {
  SectionOutline section;
  double apart = 1;  ///< distance of the two axes, over the sum of both radii
};

/// The packing that the law takes a yarn of this packing at, 0.5..0.7: pressing closes looser ones and opens denser.
/// Felting (feltingOf(), 0..1) lets a looser yarn swell again: at 1 it is as loose at crossings as between them. It
/// does nothing to a denser one.
double packingAtCrossings(double packing, double felting = 0);

/// Heights, widths and distances of yarns at their crossings. Washed (`press` 0), they are read off yarns that were
/// relaxed as bundles of hard strands under the loom's tension (tests/bench/relaxation.h); pressed (0.5) and calendered
/// (1), off an earlier such study with plates (bench_relaxation compares both). Rows of spun yarn of packing 0.5 and of
/// filament of packing 0.7; all between are interpolated. Filament spreads more, and comes to the same packing, 0.6 to
/// 0.74. Sections there are superellipses of exponent 2.4; ours are ellipses as high, and wider by the 6 % that keep
/// their area. Yarns lie no nearer than they are high together; inside a washed float they rise clear of each other.
Yielding yieldingOf(double press, double packing, int floatState);

/// The section of a yarn between two crossings, C1: from one's to the other's, and halfway eased a quarter of the way
/// to the section that the yarn has where nothing presses it. Relaxed yarns ease half of the way, but they also slip
/// aside for one another, as these do only where their threads crowd.
template <class Section>  // SectionOutline or SectionScale
class SectionEasing {
 public:
  SectionEasing(const Section& from, const Section& to, const Section& free) : from_(from), to_(to), free_(free) {}
  /// 0 <= share <= 1, of the way.
  Section at(double share) const;
  /// Bounds on the first and second derivative of either factor by the share.
  double slope() const;
  double bend() const;
  double largest() const;  ///< of either factor, on the way

 private:
  Section from_, to_, free_;
};

}  // namespace loomlight
