#include "render/scene/colouring.h"

#include <algorithm>

#include "core/fabric/model/validate.h"
#include "render/colour/primaries.h"
#include "render/colour/tristimulus.h"

namespace loomlight {

Illuminant illuminantOf(const Light& light) {
  if (light.illuminant == StandardIlluminant::file) return illuminantCalled(light.illuminantFile);
  return illuminantOf(NamedLamp{light.illuminant, light.temperature_K});
}

namespace {

EyeResponse responseOf(const Illuminant& illuminant, Observer observer, const Primaries& primaries, bool isIdentity) {
  EyeResponse response{primaries, linearWeights(illuminant, observer).rows, {}};
  glm::mat3 whole(0.0f);
  for (size_t o = 0; o < 3; ++o)
    for (size_t c = 0; c < 3; ++c)
      for (size_t j = 0; j < kBands; ++j)
        whole[static_cast<int>(c)][static_cast<int>(o)] += response.primaries[c][j] * response.channels[o][j];
  if (!isIdentity) response.whole = whole;
  return response;
}

/// The lamps have a spectrum of their own, where they are not daylight; a sky's is that of daylight of its colours.
EyeResponse responseOf(const Light& light, Observer observer) {
  const bool isDaylight = light.illuminant == StandardIlluminant::d65 && observer == Observer::degrees2;
  const bool isSky = light.illuminant == StandardIlluminant::d65 && light.kind == LightKind::sky;
  return responseOf(illuminantOf(light), observer, isSky ? daylightPrimaries() : colourPrimaries(), isDaylight);
}

Colouring colouringOf(const std::vector<Fibre>& fibres, const EyeResponse& eye) {
  Colouring colouring;
  colouring.eye = eye;
  for (const Fibre& fibre : fibres) colouring.primaries_per_mm.push_back(fibre.absorption_per_mm.primaries);
  for (size_t k = 0; k < fibres.size(); ++k) {
    const Absorption& absorption = fibres[k].absorption_per_mm;
    if (!absorption.isSpectral()) continue;
    Spectrum bands = absorption.inBands();  // and its primaries, spread over them
    const Spectrum rest = mixed(colourPrimaries(), absorption.primaries);
    for (size_t j = 0; j < kBands; ++j) bands[j] += rest[j];
    colouring.setBands(k, bands);
  }
  return colouring;
}

}  // namespace

void Colouring::setBands(size_t material, const Spectrum& absorption_per_mm) {
  bands_per_mm.resize(primaries_per_mm.size());
  primaries_per_mm[material] = Rgb(0);
  bands_per_mm[material] = absorption_per_mm;
  static_assert(kMaxKinds <= 64, "each fibre of a fabric has a bit");
  knownInBands |= uint64_t{1} << material;
}

Colouring colouringOf(const Fabric& fabric) {
  return colouringOf(fabric.fibres, responseOf(fabric.light, fabric.render.observer));
}

Colouring colouringInDaylight(const Fabric& fabric) {
  Light daylight;
  daylight.kind = LightKind::dome;
  return colouringOf(fabric.fibres, responseOf(daylight, Observer::degrees2));
}

std::vector<Rgb> leastAbsorption_per_mm(const Colouring& colouring) {
  std::vector<Rgb> least = colouring.primaries_per_mm;
  if (!colouring.isSpectral()) return least;
  // Where primaries have hardly any light they say nothing; between, two of them do.
  constexpr size_t kBlueEnds = 15, kGreenBegins = 8, kGreenEnds = 24, kRedBegins = 19;
  for (size_t k = 0; k < least.size(); ++k) {
    const Spectrum& bands = colouring.bands_per_mm[k];
    const auto leastOf = [&](size_t begin, size_t end) {
      return *std::min_element(bands.begin() + static_cast<ptrdiff_t>(begin),
                               bands.begin() + static_cast<ptrdiff_t>(end));
    };
    least[k] += Rgb(leastOf(kRedBegins, kBands), leastOf(kGreenBegins, kGreenEnds), leastOf(0, kBlueEnds));
  }
  return least;
}

}  // namespace loomlight
