#include "render/optics/bcsdf.h"

#include <algorithm>
#include <cmath>

#include "render/optics/dielectric_cylinder.h"

namespace loomlight {

using namespace optics;

namespace {

/// Chooses R, TT, TRT or the residual. Sums of comparisons, since no processor can predict this branch.
size_t chooseMode(const std::array<float, FibreBcsdf::kLobes>& share, float u) {
  const float two = share[0] + share[1], three = two + share[2];
  // Rounding of the sums must not choose a residual that cannot be.
  return size_t{u >= share[0]} + size_t{u >= two} + size_t{u >= three && share[3] > 0};
}

/// Of the residual: 3 + k with probability (1 - f) f^k.
int drawOrder(float inside, float u) {
  constexpr float kMost = 1e6f;
  return 3 + static_cast<int>(std::min(kMost, logarithm(1 - u) / logarithm(inside)));
}

}  // namespace

FibreBcsdf::FibreBcsdf(const Fibre& fibre)
    : index_(static_cast<float>(fibre.refractiveIndex)),
      along_(fibre.longitudinalRoughness, fibre.refractiveIndex, fibre.scaleTilt_deg * kPi / 180),
      about_(fibre.azimuthalRoughness, fibre.section, fibre.refractiveIndex) {}

FibreBcsdf::Sample FibreBcsdf::draw(glm::vec3 wo, float h, Random& random, bool withPdf) const {
  const CylinderHit<float> hit(wo, h, index_);
  const LongitudinalLobes::Outgoing o = along_.outgoing({hit.sineO, hit.cosineO});
  const size_t mode = chooseMode(hit.share, random.uniform());
  const Inclination i = along_.sample(mode, o, random);
  const SinCos turn = about_.sample(mode, hit, random);

  Sample sample;
  sample.wi = {i.sine, i.cosine * (turn.cosine * hit.azimuthO.x - turn.sine * hit.azimuthO.y),
               i.cosine * (turn.sine * hit.azimuthO.x + turn.cosine * hit.azimuthO.y)};
  sample.order = mode < 3 ? static_cast<int>(mode) : drawOrder(hit.inside, random.uniform());
  sample.length = static_cast<float>(sample.order) * hit.chord;
  if (withPdf)
    sample.pdf = sum(sideBySide(hit.share) * along_.density(o, i) * about_.density(hit, turn.cosine, turn.sine));
  return sample;
}

FibreBcsdf::Value FibreBcsdf::evaluate(glm::vec3 wo, glm::vec3 wi, float h) const {
  Value value;
  evaluate(wo, wi, {&h, 1}, {&value, 1});
  return value;
}

void FibreBcsdf::evaluate(glm::vec3 wo, glm::vec3 wi, std::span<const float> offsets, std::span<Value> values) const {
  constexpr size_t kSideBySide = 4;
  const Inclination i(wi.x, std::min(1.0f, std::sqrt(wi.y * wi.y + wi.z * wi.z)));
  Float32x4 along{};
  for (size_t first = 0; first < offsets.size(); first += kSideBySide) {
    const size_t count = std::min(offsets.size() - first, kSideBySide);
    Float32x4 h{};
    for (size_t k = 0; k < count; ++k) h[k] = offsets[first + k];
    const CylinderHit<Float32x4> hit(wo, h, index_);
    if (first == 0) along = along_.density(along_.outgoing({hit.sineO, hit.cosineO}), i);
    const float cosine = wi.y * hit.azimuthO.x + wi.z * hit.azimuthO.y;
    const float sine = wi.z * hit.azimuthO.x - wi.y * hit.azimuthO.y;
    std::array<Float32x4, kLobes> q;
    for (size_t mode = 0; mode < kLobes; ++mode)
      q[mode] = hit.share[mode] * along[mode] * about_.density(mode, hit, cosine, sine);
    for (size_t k = 0; k < count; ++k)
      values[first + k] = {{q[0][k], q[1][k], q[2][k], q[3][k]}, hit.chord[k], hit.inside[k]};
  }
}

FibreBcsdf::Modes FibreBcsdf::modes(glm::vec3 wo, float h) const {
  const CylinderHit<float> hit(wo, h, index_);
  return {hit.share, hit.chord, hit.inside};
}

}  // namespace loomlight
