#pragma once

#include "core/base/random.h"
#include "core/volume/pool/component.h"
#include "core/volume/pool/tangent_spread.h"

namespace loomlight {

/// A tangent of the fibre that a ray along d hits: the Gaussian about the mean, weighted by how much of a fibre's
/// length the ray sees. Rejection; the number of trials is 1 / I(alpha, s), and events are as rare as I is small.
inline glm::vec3 projectedTangent(const FibreDistribution& fibres, glm::vec3 direction, Random& random) {
  if (fibres.spread == 0) return fibres.direction;
  constexpr int kTrials = 1000;  // a fibre within 1e-3 rad of the ray; beyond that any tangent of the Gaussian will do
  glm::vec3 tangent = fibres.direction;
  for (int i = 0; i < kTrials; ++i) {
    const float u1 = random.uniform(), u2 = random.uniform();
    tangent = sampleTangent(fibres, u1, u2);
    const float cosine = glm::dot(tangent, direction);
    const float u = random.uniform();
    if (u * u < 1.0f - cosine * cosine) break;
  }
  return tangent;
}

/// Fibres lie with their roots at either end of their yarn, which scales that are tilted let light see: a tangent and
/// its opposite are as likely.
inline glm::vec3 eitherWay(glm::vec3 tangent, Random& random) {
  return random.next() >> 63 ? -tangent : tangent;
}

}  // namespace loomlight
