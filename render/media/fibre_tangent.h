#pragma once

#include "core/base/random_lanes.h"
#include "render/optics/fibre_frame.h"
#include "render/optics/polynomials.h"

namespace loomlight {

/// A tangent of fibres whose directions are the Gaussian of `spread` radians per axis about the mean, the x axis of
/// `frame`, for the rays that draw one. T: of one ray, or of several side by side.
template <class T>
Vec3Of<T> gaussianTangent(const FibreFrameOf<Vec3Of<T>>& frame, T spread, RandomLanes<T>& random, MaskOf<T> draws) {
  const auto [u1, u2] = random.uniformPair(draws);
  const T radius = squareRoot(-2 * optics::logarithm<T>(1 - u1));
  const T half = spread * radius * static_cast<float>(1 / kPi);  // turns, of half a circle each; below 2
  const auto tilt = optics::sinCosPi<T>(half > 1 ? half - 2 : half);
  const auto about = optics::sinCosPi<T>(2 * u2 - 1);
  return frame.toWorld({tilt.cosine, tilt.sine * about.cosine, tilt.sine * about.sine});
}

/// A tangent of any of the fibres, whichever way they lie to the ray.
template <class T>
Vec3Of<T> anyTangent(const Vec3Of<T>& mean, T spread, RandomLanes<T>& random) {
  return gaussianTangent<T>(FibreFrameOf<Vec3Of<T>>(mean), spread, random, random.inUse());
}

/// A tangent of the fibre that a ray along d hits: one of the fibres', weighted by how much of a fibre's length the ray
/// sees. Rejection; the number of trials is 1 / I(alpha, s), and events are as rare as I is small.
template <class T>
Vec3Of<T> projectedTangent(const Vec3Of<T>& mean, T spread, const Vec3Of<T>& direction, RandomLanes<T>& random) {
  constexpr int kTrials = 1000;  // a fibre within 1e-3 rad of the ray; beyond that any tangent of the Gaussian will do
  const FibreFrameOf<Vec3Of<T>> frame(mean);
  Vec3Of<T> tangent = mean;
  MaskOf<T> pending = random.inUse() & (spread > 0);
  for (int i = 0; i < kTrials && any(pending); ++i) {
    const Vec3Of<T> tried = gaussianTangent<T>(frame, spread, random, pending);
    const T cosine = dot(tried, direction), u = random.uniform(pending);
    tangent = {pending ? tried.x : tangent.x, pending ? tried.y : tangent.y, pending ? tried.z : tangent.z};
    pending = pending & (u * u >= 1 - cosine * cosine);
  }
  return tangent;
}

/// Fibres lie with their roots at either end of their yarn, which scales that are tilted let light see: a tangent and
/// its opposite are as likely. The factor of either.
inline float eitherWay(Random& random) {
  return random.next() >> 63 ? -1.0f : 1.0f;
}

}  // namespace loomlight
