#include "core/fabric/model/absorption.h"

namespace loomlight {

Spectrum Absorption::inBands() const {
  Spectrum sum = bands.value_or(Spectrum{});
  for (const Dyestuff& dye : dyes)
    for (size_t j = 0; j < kBands; ++j) sum[j] += static_cast<float>(dye.amount_percent) * dye.absorption_per_mm[j];
  return sum;
}

}  // namespace loomlight
