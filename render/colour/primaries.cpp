#include "render/colour/primaries.h"

#include <algorithm>

#include "render/colour/illuminant_tables.h"
#include "render/colour/illuminants.h"
#include "render/colour/tristimulus.h"

// How it works. The reflectances of red and green are a table: of all triples that are nowhere negative, sum to 1 and
// are the primaries of Rec. 709 under D65, the one with the smallest steps between bands (Mallett and Yuksel 2019);
// blue is what they leave of 1. tests/references/colour_primaries.py finds them.
//
// Daylight of any colour is a sum of three components. Those of D65's power, seen as reflectances under D65, have three
// colours; the inverse of the matrix of these says how much of each makes a light red, green or blue.

namespace loomlight {
namespace {

constexpr Spectrum kRed = {0.02088531f, 0.02087701f, 0.02084673f, 0.02071965f, 0.02025896f, 0.01902460f,
                           0.01768878f, 0.02028953f, 0.03407078f, 0.01379303f, 0.00000000f, 0.00000000f,
                           0.00000000f, 0.00000000f, 0.00000000f, 0.00000000f, 0.00000000f, 0.00000000f,
                           0.00000000f, 0.03255720f, 0.21853465f, 0.47562823f, 0.72583113f, 0.91092326f,
                           1.00000000f, 1.00000000f, 1.00000000f, 1.00000000f, 1.00000000f, 1.00000000f,
                           1.00000000f, 1.00000000f, 1.00000000f, 1.00000000f, 1.00000000f, 1.00000000f};
constexpr Spectrum kGreen = {0.00000000f, 0.00000000f, 0.00000000f, 0.00000000f, 0.00000000f, 0.00000000f,
                             0.00000000f, 0.00000000f, 0.00266231f, 0.12285931f, 0.30661292f, 0.51038435f,
                             0.70856063f, 0.87401769f, 0.97892262f, 1.00000000f, 1.00000000f, 1.00000000f,
                             1.00000000f, 0.92447656f, 0.73211773f, 0.48950965f, 0.25925839f, 0.08801289f,
                             0.00000000f, 0.00000000f, 0.00000000f, 0.00000000f, 0.00000000f, 0.00000000f,
                             0.00000000f, 0.00000000f, 0.00000000f, 0.00000000f, 0.00000000f, 0.00000000f};

Primaries reflectances() {
  Primaries primaries{kRed, kGreen, {}};
  for (size_t j = 0; j < kBands; ++j) primaries[2][j] = std::max(0.0f, 1 - kRed[j] - kGreen[j]);
  return primaries;
}

/// The components of daylight over the power of D65, in every band.
Primaries daylightComponents() {
  const Illuminant d65 = illuminantNamed("D65");
  Primaries components;
  for (size_t j = 0; j < kBands; ++j) {
    const int nm = bandWavelength_nm(j), i = (nm - kFirstVisible_nm) / kDaylightStep_nm;
    const std::array parts{kDaylightS0[i], kDaylightS1[i], kDaylightS2[i]};
    for (size_t k = 0; k < 3; ++k) components[k][j] = static_cast<float>(parts[k] / d65.power[nm - kFirstVisible_nm]);
  }
  return components;
}

Primaries daylights() {
  const LinearWeights weights = linearWeights(illuminantNamed("D65"), Observer::degrees2);
  const Primaries components = daylightComponents();
  glm::dmat3 colours;  // columns: of each component
  for (int k = 0; k < 3; ++k) colours[k] = weighted(weights, components[k]);
  const glm::dmat3 amounts = glm::inverse(colours);  // columns: of each colour
  Primaries primaries;
  for (size_t j = 0; j < kBands; ++j) {
    const glm::dvec3 parts(components[0][j], components[1][j], components[2][j]);
    for (int c = 0; c < 3; ++c) primaries[c][j] = static_cast<float>(glm::dot(parts, amounts[c]));
  }
  return primaries;
}

}  // namespace

const Primaries& colourPrimaries() {
  static const Primaries kPrimaries = reflectances();
  return kPrimaries;
}

const Primaries& daylightPrimaries() {
  static const Primaries kPrimaries = daylights();
  return kPrimaries;
}

Spectrum mixed(const Primaries& primaries, const Rgb& amounts) {
  Spectrum sum;
  for (size_t j = 0; j < kBands; ++j)
    sum[j] = amounts.r * primaries[0][j] + amounts.g * primaries[1][j] + amounts.b * primaries[2][j];
  return sum;
}

}  // namespace loomlight
