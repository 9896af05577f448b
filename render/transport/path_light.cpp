#include "render/transport/path_light.h"

#include <bit>
#include <cstring>

#include "render/colour/primaries.h"

// How it works. Light comes in primaries, each with a spectrum of its own; fibres known in bands dim each band by an
// exponential of the lengths that the path has gone in them. The eye's response says what a primary has in each band,
// and what that adds to each channel, so that the colour is the sum over primaries and bands. Four bands are computed
// side by side.

namespace loomlight {
namespace {

constexpr size_t kSideBySide = 4;
static_assert(kBands % kSideBySide == 0);

Float32x4 fourOf(const Spectrum& spectrum, size_t band) {
  Float32x4 four;
  std::memcpy(&four, &spectrum[band], sizeof(four));
  return four;
}

/// exp(-sum sigma_k L_k) in four bands.
Float32x4 attenuationInBands(const Colouring& colouring, std::span<const float> lengths_mm, size_t band) {
  Float32x4 exponent{};
  for (uint64_t rest = colouring.knownInBands; rest != 0; rest &= rest - 1) {
    const auto k = static_cast<size_t>(std::countr_zero(rest));
    if (lengths_mm[k] > 0) exponent -= fourOf(colouring.bands_per_mm[k], band) * lengths_mm[k];
  }
  return optics::exponential(exponent);
}

}  // namespace

Spectrum leftInBands(std::span<const float> lengths_mm, const Colouring& colouring) {
  const Rgb primaries = attenuation(colouring.primaries_per_mm, lengths_mm);
  Spectrum left = mixed(colourPrimaries(), primaries);
  if (!colouring.isSpectral()) return left;
  for (size_t j = 0; j < kBands; j += kSideBySide) {
    const Float32x4 four = attenuationInBands(colouring, lengths_mm, j);
    for (size_t i = 0; i < kSideBySide; ++i) left[j + i] *= four[i];
  }
  return left;
}

Rgb path_light_detail::colourInBands(const Rgb& primaries, const PathLight& light, std::span<const float> lengths_mm,
                                     const Colouring& colouring) {
  const bool isSentInBands = light.traverse_mm > 0 && colouring.isSpectral(static_cast<size_t>(light.material));
  std::array<Float32x4, 3> channels{};
  for (size_t j = 0; j < kBands; j += kSideBySide) {
    Float32x4 left = attenuationInBands(colouring, lengths_mm, j);
    if (isSentInBands) {
      const Spectrum& own_per_mm = colouring.bands_per_mm[static_cast<size_t>(light.material)];
      left *= sentOn(light, optics::exponential(-fourOf(own_per_mm, j) * light.traverse_mm));
    }
    const EyeResponse& eye = colouring.eye;
    left *= fourOf(eye.primaries[0], j) * primaries.r + fourOf(eye.primaries[1], j) * primaries.g +
            fourOf(eye.primaries[2], j) * primaries.b;
    for (size_t o = 0; o < 3; ++o) channels[o] += left * fourOf(eye.channels[o], j);
  }
  return {sum(channels[0]), sum(channels[1]), sum(channels[2])};
}

}  // namespace loomlight
