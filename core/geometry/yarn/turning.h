#pragma once

#include <cmath>

#include "core/base/units.h"

namespace loomlight {

// Places in a yarn's section are (up, across). Positive turns go from up (z) towards u: right-handed about s, so Z
// twist. A turn is kept as the direction that it takes "up" to.

/// A place, turned.
template <class Vec2>
Vec2 turned(Vec2 direction, Vec2 p) {
  return {direction.x * p.x - direction.y * p.y, direction.y * p.x + direction.x * p.y};
}
/// The turn as far the other way.
inline glm::vec2 backwards(glm::vec2 direction) {
  return {direction.x, -direction.y};
}
/// To the i-th of n that stand evenly around.
inline glm::vec2 directionOf(int i, int n) {
  const float angle = 2 * static_cast<float>(kPi) * static_cast<float>(i) / static_cast<float>(n);
  return {std::cos(angle), std::sin(angle)};
}

/// A point that moves: its place, and the first and second derivative of it.
struct Motion {
  glm::dvec2 at{0}, velocity{0}, acceleration{0};
  /// As it is seen from outside of a frame that turns about the origin: `rate` radians from x to y.
  Motion turning(double rate) const {
    const auto quarter = [](glm::dvec2 v) { return glm::dvec2(-v.y, v.x); };
    return {at, velocity + rate * quarter(at), acceleration + 2 * rate * quarter(velocity) - rate * rate * at};
  }
};
inline Motion turned(glm::dvec2 direction, const Motion& m) {
  return {turned(direction, m.at), turned(direction, m.velocity), turned(direction, m.acceleration)};
}

}  // namespace loomlight
