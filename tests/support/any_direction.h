#pragma once

#include <cmath>
#include <glm/glm.hpp>

#include "core/base/random.h"
#include "core/base/units.h"

namespace loomlight::test {

/// A unit vector, uniform over the sphere.
inline glm::vec3 anyDirection(Random& random) {
  const float z = 2 * random.uniform() - 1, phi = static_cast<float>(2 * kPi) * random.uniform();
  const float sine = std::sqrt(1 - z * z);
  return {sine * std::cos(phi), sine * std::sin(phi), z};
}

}  // namespace loomlight::test
