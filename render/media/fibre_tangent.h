#pragma once

#include "core/base/random_lanes.h"
#include "core/volume/pool/component.h"
#include "render/optics/fibre_frame.h"
#include "render/optics/polynomials.h"

namespace loomlight {

/// A tangent of the fibre that a ray along d hits: the Gaussian of `spread` radians per axis about the mean, weighted
/// by how much of a fibre's length the ray sees. T: of one ray, or of several side by side. Rejection; the number of
/// trials is 1 / I(alpha, s), and events are as rare as I is small.
template <class T>
Vec3Of<T> projectedTangent(const Vec3Of<T>& mean, T spread, const Vec3Of<T>& direction, RandomLanes<T>& random) {
  constexpr int kTrials = 1000;  // a fibre within 1e-3 rad of the ray; beyond that any tangent of the Gaussian will do
  const FibreFrameOf<Vec3Of<T>> frame(mean);
  Vec3Of<T> tangent = mean;
  MaskOf<T> pending = random.inUse() & (spread > 0);
  for (int i = 0; i < kTrials && any(pending); ++i) {
    const auto [u1, u2] = random.uniformPair(pending);
    const T radius = squareRoot(-2 * optics::logarithm<T>(1 - u1));
    const T half = spread * radius * static_cast<float>(1 / kPi);  // turns, of half a circle each; below 2
    const auto tilt = optics::sinCosPi<T>(half > 1 ? half - 2 : half);
    const auto about = optics::sinCosPi<T>(2 * u2 - 1);
    const Vec3Of<T> tried = frame.toWorld({tilt.cosine, tilt.sine * about.cosine, tilt.sine * about.sine});
    const T cosine = dot(tried, direction), u = random.uniform(pending);
    tangent = {pending ? tried.x : tangent.x, pending ? tried.y : tangent.y, pending ? tried.z : tangent.z};
    pending = pending & (u * u >= 1 - cosine * cosine);
  }
  return tangent;
}

/// The same of one ray, of the fibres of one component.
inline glm::vec3 projectedTangent(const FibreDistribution& fibres, glm::vec3 direction, Random& random) {
  RandomLanes<float> numbers(random);
  const auto& m = fibres.direction;
  const Vec3Of<float> t =
      projectedTangent<float>({m.x, m.y, m.z}, fibres.spread, {direction.x, direction.y, direction.z}, numbers);
  return {t.x, t.y, t.z};
}

/// Fibres lie with their roots at either end of their yarn, which scales that are tilted let light see: a tangent and
/// its opposite are as likely. The factor of either.
inline float eitherWay(Random& random) {
  return random.next() >> 63 ? -1.0f : 1.0f;
}

}  // namespace loomlight
