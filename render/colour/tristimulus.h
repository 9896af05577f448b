#pragma once

#include <array>
#include <glm/glm.hpp>

#include "core/base/spectrum.h"
#include "render/colour/illuminants.h"
#include "render/colour/observer.h"

namespace loomlight {

/// Three rows, one for each of X, Y and Z: a reflectance weighted() by them is its CIE XYZ under a light.
struct TristimulusWeights {
  std::array<Spectrum, 3> rows;
};

/// The same to linear Rec. 709: r, g and b.
struct LinearWeights {
  std::array<Spectrum, 3> rows;
};

/// The weights of ASTM E308 for reflectances at 10 nm, without correction for the width of the instrument's bands, from
/// 380 to 730 nm; what lies beyond is added to the first and the last band. A perfect diffuser has Y = 1.
TristimulusWeights tristimulusWeights(const Illuminant& illuminant, Observer observer);

/// XYZ under the illuminant, adapted to D65 (Bradford), as linear Rec. 709: the perfect diffuser is (1, 1, 1) under
/// every light, and each row sums to 1.
LinearWeights linearWeights(const Illuminant& illuminant, Observer observer);

/// What takes XYZ seen under one white to the XYZ that looks alike under another: von Kries in the cone space of Lam
/// (Bradford; ICC.1:2022, annex E).
glm::dmat3 bradford(const glm::dvec3& fromWhite, const glm::dvec3& toWhite);

/// Row by row the sum over the bands of weight and value.
glm::dvec3 weighted(const std::array<Spectrum, 3>& rows, const Spectrum& values);
inline glm::dvec3 weighted(const TristimulusWeights& weights, const Spectrum& reflectance) {
  return weighted(weights.rows, reflectance);
}
inline glm::dvec3 weighted(const LinearWeights& weights, const Spectrum& reflectance) {
  return weighted(weights.rows, reflectance);
}

/// XYZ of the perfect diffuser, Y = 1.
glm::dvec3 whiteXyz(const TristimulusWeights& weights);

}  // namespace loomlight
