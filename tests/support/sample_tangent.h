#pragma once

#include <cmath>

#include "core/volume/pool/tangent_spread.h"

namespace loomlight::test {

/// A tangent of the distribution, its Gaussian about the mean direction; u1, u2 uniform in [0, 1), of 24 bits.
///
/// With the majorant 2 r lambda, the extinction of fibres all seen side-on, it makes the table-free reference of the
/// look-up: draw a flight from the majorant and a tangent t from here, and accept the collision with probability
/// |sin angle(d, t)|. What is accepted has exactly the rate 2 r lambda I(alpha, s) and the law of the fibres that a ray
/// along d hits.
inline glm::vec3 sampleTangent(const FibreDistribution& distribution, float u1, float u2) {
  const glm::vec3 m = distribution.direction;
  if (distribution.spread == 0) return m;
  const float theta = distribution.spread * std::sqrt(-2 * std::log(1 - u1));
  const float phi = static_cast<float>(2 * kPi) * u2;
  // Duff et al. 2017, "Building an Orthonormal Basis, Revisited".
  const float sign = std::copysign(1.0f, m.z);
  const float a = -1 / (sign + m.z), b = m.x * m.y * a;
  const glm::vec3 e1(1 + sign * m.x * m.x * a, sign * b, -sign * m.x), e2(b, sign + m.y * m.y * a, -m.y);
  const float across = std::sin(theta);
  return std::cos(theta) * m + across * (std::cos(phi) * e1 + std::sin(phi) * e2);
}

}  // namespace loomlight::test
