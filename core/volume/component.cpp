#include "core/volume/component.h"

#include <algorithm>
#include <cassert>

namespace loomlight {
namespace {

/// Of the two unit vectors of a line, the one in the upper half-space; on its rim, the one towards +x, then +y.
glm::vec3 canonical(glm::vec3 m) {
  const bool lower = m.z != 0 ? m.z < 0 : m.x != 0 ? m.x < 0 : m.y < 0;
  return lower ? -m : m;
}

uint64_t unitCode(float value, float steps) {
  return static_cast<uint64_t>(std::lround(std::clamp(value, 0.0f, 1.0f) * steps));
}

}  // namespace

uint64_t Component::encodeDirection(glm::vec3 direction) {
  const glm::vec3 m = canonical(direction);
  const float norm = std::abs(m.x) + std::abs(m.y) + m.z;
  assert(norm > 0);
  const float u = (m.x + m.y) / norm * kAxisCentre, v = (m.x - m.y) / norm * kAxisCentre;
  const int u0 = static_cast<int>(std::floor(u)), v0 = static_cast<int>(std::floor(v));
  // The map is not conformal, so the nearest code is not always the rounded one: compare the four around it.
  uint64_t best = 0;
  double bestSine = 2;  // squared; of the cosine float could not tell apart what lies within 0.3 mrad
  for (int corner = 0; corner < 4; ++corner) {
    const int i = std::clamp(u0 + (corner & 1), -kAxisCentre, kAxisCentre);
    const int j = std::clamp(v0 + (corner >> 1), -kAxisCentre, kAxisCentre);
    const auto code = static_cast<uint64_t>(i + kAxisCentre) | static_cast<uint64_t>(j + kAxisCentre) << 12;
    const glm::dvec3 normal = glm::cross(glm::dvec3(decodeDirection(code)), glm::dvec3(m));
    if (const double sine = glm::dot(normal, normal); sine < bestSine) {
      bestSine = sine;
      best = code;
    }
  }
  // On the rim a line has two codes.
  const int i = static_cast<int>(best & 0xFFF) - kAxisCentre, j = static_cast<int>(best >> 12) - kAxisCentre;
  const bool rim = std::max(std::abs(i), std::abs(j)) == kAxisCentre;
  if (!rim || i + j > 0 || (i + j == 0 && i > 0)) return best;
  return static_cast<uint64_t>(kAxisCentre - i) | static_cast<uint64_t>(kAxisCentre - j) << 12;
}

Component Component::encode(const FibreDistribution& d) {
  constexpr int kDroppedBits = 12;  // of the 23 of a float's mantissa
  const float density = std::max(d.lengthDensity, 0.0f);
  const int64_t excess = static_cast<int64_t>(std::bit_cast<uint32_t>(density)) - kDensityBias;
  const int64_t rounded = (excess + (1 << (kDroppedBits - 1))) >> kDroppedBits;
  // Code 0 is zero, so what would round to the value of code 0 goes to the nearer of zero and code 1.
  const int64_t code = rounded > 0 ? rounded : density >= 0x1p-13f ? 1 : 0;
  Component c;
  c.bits_ = encodeDirection(d.direction) | unitCode(std::sqrt(std::max(d.spread, 0.0f)), 255) << 24 |
            unitCode(d.packing, 255) << 32 | static_cast<uint64_t>(d.material & 0xFF) << 40 |
            static_cast<uint64_t>(std::min<int64_t>(code, 0xFFFF)) << 48;
  return c;
}

}  // namespace loomlight
