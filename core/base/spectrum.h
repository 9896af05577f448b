#pragma once

#include <array>
#include <cstddef>

namespace loomlight {

/// The wavelengths at which colour is computed: bands from 380 to 730 nm, 10 nm apart, as spectrophotometers report
/// them (ISO 13655, ASTM E308).
inline constexpr size_t kBands = 36;
inline constexpr int kFirstBand_nm = 380, kBandStep_nm = 10;

/// Wavelength of a band.
constexpr int bandWavelength_nm(size_t band) {
  return kFirstBand_nm + kBandStep_nm * static_cast<int>(band);
}

/// One value for each band: a reflectance (1 is a perfect diffuser), the power of a light, or an absorption (1/mm).
using Spectrum = std::array<float, kBands>;

/// Whose eye sees colours: the CIE standard observer of 1931, for patches of 2 degrees, or of 1964, for 10 degrees,
/// with which the textile trade measures.
enum class Observer { degrees2, degrees10 };

}  // namespace loomlight
