#include "render/optics/bcsdf.h"

#include <algorithm>
#include <cmath>

#include "render/optics/dielectric_cylinder.h"

namespace loomlight {

using namespace optics;

namespace {

/// Chooses R, TT, TRT or the residual. Sums of comparisons, since no processor can predict this branch.
template <class T>
WholeOf<T> chooseMode(const std::array<T, FibreBcsdf::kModes>& share, T u) {
  const T two = share[0] + share[1], three = two + share[2];
  const auto one = [](MaskOf<T> mask) { return mask ? WholeOf<T>{} + 1 : WholeOf<T>{}; };
  // Rounding of the sums must not choose a residual that cannot be.
  return one(u >= share[0]) + one(u >= two) + one((u >= three) & (share[3] > 0));
}

/// Of the residual: 3 + k with probability (1 - f) f^k.
template <class T>
WholeOf<T> drawOrder(T internalReflectance, T u) {
  return 3 + truncated<T>(least(broadcast<T>(1e6), logarithm<T>(1 - u) / logarithm<T>(internalReflectance)));
}

Vec3Of<float> numbersOf(glm::vec3 v) {
  return {v.x, v.y, v.z};
}

}  // namespace

FibreBcsdf::FibreBcsdf(const Fibre& fibre)
    : index_(static_cast<float>(fibre.refractiveIndex)),
      along_(fibre.longitudinalRoughness, fibre.refractiveIndex, fibre.scaleTilt_deg * kPi / 180),
      about_(fibre.azimuthalRoughness, fibre.section, fibre.refractiveIndex) {}

template <class T>
inline FibreBcsdf::SampleOf<T> FibreBcsdf::drawOf(const Vec3Of<T>& wo, T h, RandomLanes<T>& random,
                                                  bool withPdf) const {
  const CylinderHit<T> hit(wo, h, index_);
  const auto o = along_.outgoing<T>({hit.sineO, hit.cosineO});
  const WholeOf<T> mode = chooseMode<T>(hit.share, random.uniform());
  const Inclination<T> i = along_.sample<T>(mode, o, random);
  const SinCos<T> turn = about_.sample<T>(mode, hit, random);

  SampleOf<T> sample;
  sample.wi = {i.sine, i.cosine * (turn.cosine * hit.azimuthOCosine - turn.sine * hit.azimuthOSine),
               i.cosine * (turn.sine * hit.azimuthOCosine + turn.cosine * hit.azimuthOSine)};
  sample.order = mode;
  const MaskOf<T> residual = mode == 3;
  if (any(residual)) sample.order = residual ? drawOrder<T>(hit.internalReflectance, random.uniform(residual)) : mode;
  sample.length_radii = toFloats<T>(sample.order) * hit.chord_radii;
  if (withPdf) {
    const std::array<T, kModes> along = along_.density<T>(o, i), about = about_.density<T>(hit, turn.cosine, turn.sine);
    std::array<T, kModes> q;
    for (size_t k = 0; k < kModes; ++k) q[k] = hit.share[k] * along[k] * about[k];
    sample.pdf = (q[0] + q[1]) + (q[2] + q[3]);
  }
  return sample;
}

template <class T>
inline void FibreBcsdf::evaluateAll(const Vec3Of<T>& wo, const Vec3Of<T>& wi, std::span<const T> offsets,
                                    std::span<ValueOf<T>> values) const {
  const Inclination<T> i(wi.x, least(squareRoot<T>(wi.y * wi.y + wi.z * wi.z), broadcast<T>(1.0)));
  std::array<T, kModes> along{};
  for (size_t at = 0; at < offsets.size(); ++at) {
    const CylinderHit<T> hit(wo, offsets[at], index_);
    if (at == 0) along = along_.density<T>(along_.outgoing<T>({hit.sineO, hit.cosineO}), i);
    const T cosine = wi.y * hit.azimuthOCosine + wi.z * hit.azimuthOSine;
    const T sine = wi.z * hit.azimuthOCosine - wi.y * hit.azimuthOSine;
    const std::array<T, kModes> about = about_.density<T>(hit, cosine, sine);
    for (size_t k = 0; k < kModes; ++k) values[at].q[k] = hit.share[k] * along[k] * about[k];
    values[at].chord_radii = hit.chord_radii;
    values[at].internalReflectance = hit.internalReflectance;
  }
}

FibreBcsdf::Sample FibreBcsdf::draw(glm::vec3 wo, float h, Random& random, bool withPdf) const {
  RandomLanes<float> numbers(random);
  const SampleOf<float> s = drawOf<float>(numbersOf(wo), h, numbers, withPdf);
  return {{s.wi.x, s.wi.y, s.wi.z}, s.order, s.length_radii, s.pdf};
}

FibreBcsdf::Value FibreBcsdf::evaluate(glm::vec3 wo, glm::vec3 wi, float h) const {
  Value value;
  evaluateAll<float>(numbersOf(wo), numbersOf(wi), {&h, 1}, {&value, 1});
  return value;
}

FibreBcsdf::SampleOf<FibreBcsdf::Lanes> FibreBcsdf::sample(const Vec3Of<Lanes>& wo, Lanes h, RandomLanes<Lanes>& random,
                                                           bool withPdf) const {
  return drawOf<Lanes>(wo, h, random, withPdf);
}

void FibreBcsdf::evaluate(const Vec3Of<Lanes>& wo, const Vec3Of<Lanes>& wi, std::span<const Lanes> offsets,
                          std::span<ValueOf<Lanes>> values) const {
  evaluateAll<Lanes>(wo, wi, offsets, values);
}

FibreBcsdf::Modes FibreBcsdf::modes(glm::vec3 wo, float h) const {
  const CylinderHit<float> hit(numbersOf(wo), h, index_);
  return {hit.share, hit.chord_radii, hit.internalReflectance};
}

}  // namespace loomlight
