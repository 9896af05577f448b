#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/spectrum.h"
#include "core/base/units.h"

namespace loomlight {

/// A dye on a fibre, as a dyer's recipe has it.
struct Dyestuff {
  std::string name = "dye";
  double amount_percent = 1;      ///< on weight of fibre, 0..100
  Spectrum absorption_per_mm{0};  ///< of a fibre with 1 %, 0..10000 in each band; it grows with the amount
  friend bool operator==(const Dyestuff&, const Dyestuff&) = default;
};

/// How strongly a fibre absorbs light on its way inside, 1/mm: the sum of what is known of it by three numbers, of what
/// is known band by band, and of the dyes on it.
struct Absorption {
  Rgb primaries{0.0f};            ///< of red, green and blue light, 0..10000 each: all that a colour picker can say
  std::optional<Spectrum> bands;  ///< as measured, 0..10000 each
  std::vector<Dyestuff> dyes;     ///< at most kMostDyes

  static constexpr size_t kMostDyes = 16;

  Absorption() = default;
  Absorption(const Rgb& per_mm) : primaries(per_mm) {}  // NOLINT: three numbers are an absorption
  explicit Absorption(const Spectrum& per_mm) : bands(per_mm) {}

  /// Whether more is known of it than three numbers.
  bool isSpectral() const { return bands || !dyes.empty(); }
  /// What bands and dyes absorb together, without the primaries.
  Spectrum inBands() const;

  friend bool operator==(const Absorption&, const Absorption&) = default;
};

}  // namespace loomlight
