#pragma once

#include <cstdint>
#include <vector>

#include "core/fabric/model/fabric.h"

namespace loomlight {

/// Where a yarn lies free between two crossings that bind it. Its length is that of the crossings between them:
/// floatLength_mm(). On the face it lies over the yarns of the other system, on the back under them.
struct FloatRun {
  System system = System::warp;
  bool onFace = true;
  int across = 0;          ///< end or pick of the repeat, from 0
  int first = 0;           ///< the pick or end that it begins over; it may go on over the edge of the repeat
  int cells = 1;           ///< how many yarns it passes
  bool isEndless = false;  ///< nothing binds the yarn at all; `cells` are those of a repeat
  double length_mm = 0;
  friend bool operator==(const FloatRun&, const FloatRun&) = default;
};

/// How many crossings a yarn of either system may pass where floats may be so long.
struct FloatLimits {
  int warp = 0, weft = 0;
};
FloatLimits floatLimits(const Fabric& fabric, double limit_mm);

/// Whether one of the two yarns that cross there floats further than it may, on the face or on the back. Looks no
/// further than the limits.
bool floatsTooFar(const Weave& weave, int pick, int end, const FloatLimits& limits);

/// Beyond which floats are marked, listed and warned of, where no other limit is set.
inline constexpr double kUsualFloatLimit_mm = 4;

/// The floats of one repeat that are longer than they may be. Ends and picks that nothing binds are, whatever the
/// limit.
struct LongFloats {
  double limit_mm = kUsualFloatLimit_mm;
  int64_t count = 0;              ///< all of them
  std::vector<FloatRun> longest;  ///< the longest first; at most kMostListed
  static constexpr size_t kMostListed = 500;
};
LongFloats longFloats(const Fabric& fabric, double limit_mm);

}  // namespace loomlight
