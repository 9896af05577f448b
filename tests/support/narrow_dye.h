#pragma once

#include <cmath>

#include "core/base/spectrum.h"

namespace loomlight::test {

/// Absorption of a dye that takes yellowish green light alone, 1/mm. Lamps differ in how much of their light is there:
/// each shows it as another colour.
inline Spectrum narrowDye(double height_per_mm) {
  constexpr double kCentre_nm = 560, kWidth_nm = 25;
  Spectrum bands{};
  for (size_t j = 0; j < kBands; ++j) {
    const double away = (bandWavelength_nm(j) - kCentre_nm) / kWidth_nm;
    bands[j] = static_cast<float>(height_per_mm * std::exp(-away * away));
  }
  return bands;
}

}  // namespace loomlight::test
