#include "render/transport/path_light.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "render/colour/primaries.h"
#include "render/optics/polynomials.h"

namespace loomlight {
namespace {

using optics::exponential;

#include "render/transport/path_light-inl.h"

/// As the formulas read it.
class OneLight {
 public:
  using Number = float;
  using Bands = Float32x4;
  static constexpr size_t kSideBySide = 4;

  OneLight(const PathLight& light, std::span<const float> lengths_mm)
      : light_(light), lengths_mm_(lengths_mm), isWithin_(isWithinFibres(lengths_mm)) {}

  static Float32x4 of(const Rgb& rgb, size_t) { return Float32x4{rgb.r, rgb.g, rgb.b, 0}; }
  static Float32x4 of(const Spectrum& spectrum, size_t j) {
    Float32x4 four;
    std::memcpy(&four, &spectrum[j], sizeof(four));
    return four;
  }

  int sender() const { return light_.sender(); }
  float mode(size_t p) const { return light_.modes[p]; }
  float traverse_mm() const { return light_.traverse_mm; }
  float internalReflectance() const { return light_.internalReflectance; }
  Float32x4 radiance(size_t c) const { return of(light_.arriving(), c); }
  bool isWithin() const { return isWithin_; }
  bool isWithin(size_t k) const { return lengths_mm_[k] > 0; }
  float length_mm(size_t k) const { return lengths_mm_[k]; }

  static std::array<float, 3> apart(const std::array<Float32x4, 1>& rgb) { return {rgb[0][0], rgb[0][1], rgb[0][2]}; }
  static float sum(const std::array<Float32x4, 1>& partial) { return loomlight::sum(partial[0]); }

 private:
  const PathLight& light_;
  std::span<const float> lengths_mm_;
  bool isWithin_;
};

}  // namespace

bool isWithinFibres(std::span<const float> lengths_mm) {
  return std::any_of(lengths_mm.begin(), lengths_mm.end(), [](float length) { return length > 0; });
}

Rgb transmittance(std::span<const Rgb> absorption_per_mm, std::span<const float> lengths_mm) {
  Rgb exponent(0.0f);
  for (size_t k = 0; k < lengths_mm.size(); ++k) exponent -= absorption_per_mm[k] * lengths_mm[k];
  const Float32x4 left = exponential(OneLight::of(exponent, 0));
  return {left[0], left[1], left[2]};
}

Spectrum leftInBands(std::span<const float> lengths_mm, const Colouring& colouring) {
  Spectrum left = mixed(colourPrimaries(), transmittance(colouring.primaries_per_mm, lengths_mm));
  if (!colouring.isSpectral()) return left;
  const PathLight any;
  const OneLight light(any, lengths_mm);
  InAllBands<OneLight> exponents;
  findExponents(light, colouring, exponents);
  size_t band = 0;
  for (const Float32x4 exponent : exponents) {
    const Float32x4 four = exponential(exponent);
    for (size_t i = 0; i < OneLight::kSideBySide; ++i) left[band++] *= four[i];
  }
  return left;
}

Rgb colourOf(const PathLight& light, std::span<const float> lengths_mm, const Colouring& colouring) {
  const std::array<float, 3> colour = colourOf(OneLight(light, lengths_mm), colouring);
  return {colour[0], colour[1], colour[2]};
}

}  // namespace loomlight
