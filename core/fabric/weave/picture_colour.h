#pragma once

#include <array>
#include <cstdint>

namespace loomlight {

using Rgb8 = std::array<uint8_t, 3>;  ///< as displayed

/// The same in numbers that need not be whole: means of colours.
using ExactColour = std::array<double, 3>;

inline ExactColour exactly(const Rgb8& c) {
  return {static_cast<double>(c[0]), static_cast<double>(c[1]), static_cast<double>(c[2])};
}

/// A product of two differences of colours that weighs the channels as the eye does, roughly.
inline double seenProduct(const ExactColour& a, const ExactColour& b) {
  return 2 * a[0] * b[0] + 4 * a[1] * b[1] + 3 * a[2] * b[2];
}

inline ExactColour difference(const ExactColour& a, const ExactColour& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// The square of how far apart two colours look, roughly; black and white are 765 apart.
inline double distance2(const ExactColour& a, const ExactColour& b) {
  const ExactColour apart = difference(a, b);
  return seenProduct(apart, apart);
}

}  // namespace loomlight
