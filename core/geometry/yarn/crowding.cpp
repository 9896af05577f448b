#include "core/geometry/yarn/crowding.h"

#include <algorithm>

// How it works. A thread that passes between two yarns pushes both away, one to either side. A yarn that is pushed from
// one side only gives way, the more so where the crossings beside push it the same way, and the less where they push it
// back: it is too stiff to follow each. That is why the threads of a hopsack pair up, while those of a 2/2 twill hardly
// move. Inside a float it lies above the thread that passes, which then pushes little.

namespace loomlight {

Crowding crowdingOf(double radius_mm, double halfWidth_mm, double pitch_mm, double amount) {
  constexpr std::array<double, kFloatStates> kAside = {0.085, 0.11, 0.045};  // over the radius
  Crowding crowding;
  for (size_t state = 0; state < kAside.size(); ++state) {
    crowding.byState_mm[state] = amount * kAside[state] * radius_mm;
    crowding.most_mm = std::max(crowding.most_mm, crowding.byState_mm[state] * kMostLeaning / kLeaning);
  }
  crowding.most_mm = std::min(crowding.most_mm, std::max(0.0, 0.5 * pitch_mm - (1 - kPressedIn) * halfWidth_mm));
  return crowding;
}

float Crowding::aside_mm(int floatState, int leaning) const {
  const double wanted_mm = byState_mm[static_cast<size_t>(floatState)] * leaning / kLeaning;
  return static_cast<float>(std::clamp(wanted_mm, -most_mm, most_mm)) + 0.0f;  // not -0, whose hash is another
}

}  // namespace loomlight
