#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/base/rgb.h"

/// The film's fixed point: how a sample becomes the integers that are summed. See Film for quanta and ranges.
namespace loomlight {

inline constexpr double kRadianceQuantum = 0x1p-24, kSquareQuantum = 0x1p-28, kDepthQuantum_mm = 0x1p-16,
                        kDirectionQuantum = 0x1p-10;
inline constexpr double kMaxRadiance = 0x1p18, kMaxSquare = 0x1p34, kMaxDepth_mm = 0x1p20;

/// Rounded to the nearest quantum; NaN gives 0. Radiance of colours outside of the gamut has negative channels.
inline int64_t fixedRadiance(float value) {
  if (std::isnan(value)) return 0;
  return std::llrint(std::clamp(static_cast<double>(value), -kMaxRadiance, kMaxRadiance) * (1 / kRadianceQuantum));
}

/// Rounded to the nearest quantum; NaN and what is below zero give 0.
inline uint64_t fixedPositive(double value, double maximum, double quantum) {
  if (!(value > 0)) return 0;
  return static_cast<uint64_t>(std::llrint(std::min(value, maximum) * (1 / quantum)));
}

inline uint64_t fixedDepth(float value_mm) {
  return fixedPositive(value_mm, kMaxDepth_mm, kDepthQuantum_mm);
}
inline uint64_t fixedSquare(double luminance) {
  return fixedPositive(luminance * luminance, kMaxSquare, kSquareQuantum);
}

inline int32_t fixedDirection(float component) {
  if (std::isnan(component)) return 0;
  return static_cast<int32_t>(
      std::lrint(std::clamp(component, -1.0f, 1.0f) * static_cast<float>(1 / kDirectionQuantum)));
}

/// Associative and commutative, because all terms are positive.
inline uint64_t saturatingAdd(uint64_t a, uint64_t b) {
  return a > std::numeric_limits<uint64_t>::max() - b ? std::numeric_limits<uint64_t>::max() : a + b;
}

/// Of radiance in quanta.
inline double luminanceOf(const glm::dvec3& quanta) {
  return kRadianceQuantum * luminance(quanta);
}

}  // namespace loomlight
