#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/geometry/yarn/crowding.h"

namespace loomlight {

/// How the thickness of a yarn, and where it lies in the cloth, vary along it.
struct Evenness {
  double massCv = 0;  ///< coefficient of variation of the mass of kEvennessCut_mm of yarn between its slubs (CVm), 0..1
  double slubs_per_mm = 0;
  double slubLength_mm = 0;  ///< at half their height, on average
  double slubMass = 1;       ///< of a length of slub, over that of the yarn between
  double aside_mm = 0;       ///< RMS distance of its axis from where an even sett would have it
  Crowding crowding;         ///< in an even sett: by the weave alone, whatever the place along the yarn
  double displaced_mm = 0;   ///< farthest that the cloth's spacing has such a thread from its place in an even sett
  double crossingsDisplaced_mm = 0;  ///< likewise, of the threads that it crosses
  /// Evenly spun, and not wandering in its sett: "even" of a yarn means both. It may crowd, and be displaced.
  bool isEven() const { return massCv == 0 && slubs_per_mm == 0 && aside_mm == 0; }
  bool operator==(const Evenness&) const = default;
};
/// The length of the pieces that an evenness tester (Uster) compares.
inline constexpr double kEvennessCut_mm = 8;

/// A stretch of yarn, one period long, which goes from one mass per length to another; both over the yarn's mean. On
/// the way its axis moves aside in the cloth's plane, from one place to another.
struct Stretch {
  float from = 1, to = 1;
  float asideFrom_mm = 0, asideTo_mm = 0;  ///< signed, along u of the cell's frame

  /// `t`: cells from the middle of the stretch's first cell, -1..period. Constant up to that middle, and from the
  /// middle of the last cell on, so that stretches join wherever the one ends as the other begins.
  double massAt(double t, int period) const;
  /// Factor on the radius, of a yarn that is equally compact everywhere.
  double radiusAt(double t, int period) const { return std::sqrt(massAt(t, period)); }
  /// Twist runs into thin places: how much of it, over the mean, the middle of the lighter half has more than the yarn,
  /// and that of the heavier half less. Positive where the stretch grows heavier.
  double twistSwing() const { return (static_cast<double>(to) - from) / (static_cast<double>(to) + from); }
  /// The place of an even yarn, in cells, up to which it has as much twist as this stretch up to `t`. The same at the
  /// ends of the stretch, and as fast there, so that fibres go on; halfway between, both halves have a twist that goes
  /// by one over their mass, as that of yarns does which are equally stiff in torsion for their mass.
  double twistAt(double t, int period) const;
  /// Of the axis; constant beyond the middles of the first and the last cell, as the mass is.
  double asideAt_mm(double t, int period) const;
  /// Of the mass, over a cell.
  double massOfCell(int phase, int period) const;
};

/// A long piece of yarn as it was spun, whose ends join: all threads of the yarn in a cloth are taken from it, each
/// from a place of its own. The mass per length is light or heavy at each end of a stretch, or that of a slub; so there
/// are few kinds of stretches, and cells of one kind share a brick. In an uneven sett the place of the axis follows the
/// mass: light places lie to one side of the cell's middle, heavy ones to the other, slubs between. Drawn on its own it
/// would take four times as many kinds of stretches, and bricks. Neighbouring threads are independent all the same, as
/// each begins elsewhere on the spool. Immutable.
class Spool {
 public:
  /// Of a yarn whose twist has a period of so many cells, each with so much yarn. A pure function of its arguments.
  Spool(const Evenness& evenness, int period, double cell_mm, uint64_t seed);

  static constexpr uint32_t kStretches = uint32_t{1} << 16;
  int kinds() const { return states_ * states_; }
  /// Of a stretch, counted on beyond the spool's end. Two loads.
  int kind(uint32_t stretch) const {
    return stateAt_[stretch % kStretches] * states_ + stateAt_[(stretch + 1) % kStretches];
  }
  Stretch stretch(int kind) const {
    const int from = kind / states_, to = kind % states_;
    return {massOf_[from], massOf_[to], asideOf_mm_[from], asideOf_mm_[to]};
  }
  /// Of all stretches, those of a kind.
  double share(int kind) const { return shares_[static_cast<size_t>(kind)]; }
  double largestRadius() const;   ///< factor on the yarn's radius
  double smallestRadius() const;  ///< likewise
  double farthestAside_mm() const;
  size_t bytes() const { return sizeof(Spool) + stateAt_.capacity() + shares_.capacity() * sizeof(double); }

 private:
  void setAside(double rms_mm, int period);

  int states_ = 2;
  std::vector<uint8_t> stateAt_;     ///< where stretch i begins
  float massOf_[3] = {1, 1, 1};      ///< by state: light, heavy, slub; over the yarn's mean
  float asideOf_mm_[3] = {0, 0, 0};  ///< likewise
  std::vector<double> shares_;       ///< by kind
};

}  // namespace loomlight
