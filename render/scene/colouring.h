#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/spectrum.h"
#include "core/fabric/model/fabric.h"
#include "render/colour/illuminants.h"

namespace loomlight {

/// What light shows to an eye that is adapted to the lamps, in linear Rec. 709: `primaries[c][j] * channels[o][j]` is
/// what primary c of light that is left over in band j adds to channel o. Whatever the lamps, white stays (1, 1, 1).
struct EyeResponse {
  std::array<Spectrum, 3> primaries{}, channels{};
  /// The sum over all bands: of light of which nothing is lost. nullopt where it is the identity.
  std::optional<glm::mat3> whole;
  friend bool operator==(const EyeResponse&, const EyeResponse&) = default;
};

/// All that turns the light of a path, and the lengths that it has gone inside the fibres of each material, into a
/// colour. The absorption of a material is known in primaries or in bands, and then 0 in the other; primaries of a
/// material with bands are spread over them.
///
/// Primaries are no spectrum: light of three numbers has that of the lamps times the smooth partition of white into
/// three by Mallett and Yuksel (2019), after all exponentials. So a fabric of three numbers looks in daylight just as
/// if each channel were traced alone, and it keeps a spectrum that other lamps can be seen by.
struct Colouring {
  std::vector<Rgb> primaries_per_mm;     ///< of each material
  std::vector<Spectrum> bands_per_mm{};  ///< of each material; empty where none is known in bands
  uint64_t knownInBands = 0;             ///< bit k stands for material k: a fabric has 64 at most
  EyeResponse eye{};

  bool isSpectral() const { return knownInBands != 0; }
  bool isSpectral(size_t material) const { return (knownInBands >> material & 1) != 0; }
  void setBands(size_t material, const Spectrum& absorption_per_mm);
  friend bool operator==(const Colouring&, const Colouring&) = default;
};

/// The spectrum of a light's lamps. Throws InputError for a bad file.
Illuminant illuminantOf(const Light& light);

/// Of the fabric's fibres under its lamps.
Colouring colouringOf(const Fabric& fabric);
/// Of the fabric's fibres in daylight, as colours are named and wanted.
Colouring colouringInDaylight(const Fabric& fabric);

/// For each material what each primary loses at the least, 1/mm, in the bands where it has most of its light: Russian
/// roulette may end paths by it, since hardly a band is brighter than these say.
std::vector<Rgb> leastAbsorption_per_mm(const Colouring& colouring);

}  // namespace loomlight
