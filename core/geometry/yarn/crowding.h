#pragma once

#include <array>

#include "core/geometry/yarn/pressing.h"

namespace loomlight {

/// How much a yarn is drawn to one of its neighbours is counted as its leaning: the crossing itself counts this much,
/// and each of the two beside it along the yarn 1. It is below 0 towards the neighbour before.
inline constexpr int kLeaning = 4;
inline constexpr int kMostLeaning = kLeaning + 2;  ///< to either side

/// How far the rims of threads that lie close are pressed in, over the half-width: relaxed yarns that touch already
/// come so near.
inline constexpr double kPressedIn = 0.1;

/// How far a yarn stands aside where a crossing thread passes between it and one of its neighbours, but not between it
/// and the other, so that threads which float side by side draw together.
struct Crowding {
  std::array<double, kFloatStates> byState_mm{};  ///< where that is so at the crossing alone
  double most_mm = 0;                             ///< until such threads touch, their rims pressed in a little

  /// Along the count of threads.
  float aside_mm(int floatState, int leaning) const;
  bool operator==(const Crowding&) const = default;
};

/// Of a yarn of this radius in this section, whose neighbours stand `pitch_mm` apart. Read off relaxed yarns
/// (tests/bench/relaxation.h); `amount` (1) multiplies it (Fabric::crowding).
Crowding crowdingOf(double radius_mm, double halfWidth_mm, double pitch_mm, double amount);

}  // namespace loomlight
