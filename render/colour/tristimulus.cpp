#include "render/colour/tristimulus.h"

#include <algorithm>
#include <vector>

#include "render/colour/colour_space.h"

// How it works. XYZ is a sum over every nm of power, matching function and reflectance; the reflectance between two
// bands is the cubic through the two on either side, the parabola through three in the first and the last interval.
// Each reflectance in that sum is a sum of bands, so what multiplies a band can be gathered once (ASTM E2022). That is
// done from 360 to 780 nm, where the functions are; the weights of bands that no instrument has go to its first and
// last.

namespace loomlight {
namespace {

constexpr int kIntervals = (kLastVisible_nm - kFirstVisible_nm) / kBandStep_nm;

/// One unit of light at `at` bands from the first, shared among the bands by Lagrange's polynomial.
template <class Add>
void share(double at, Add&& add) {
  const int interval = std::min(static_cast<int>(at), kIntervals - 1);
  const int first = interval == 0 ? 0 : interval - 1;
  const int last = interval == kIntervals - 1 ? kIntervals : interval + 2;
  for (int i = first; i <= last; ++i) {
    double factor = 1;
    for (int k = first; k <= last; ++k)
      if (k != i) factor *= (at - k) / (i - k);
    add(i, factor);
  }
}

size_t bandOf(int i) {
  constexpr int kBefore = (kFirstBand_nm - kFirstVisible_nm) / kBandStep_nm;
  return static_cast<size_t>(std::clamp(i - kBefore, 0, static_cast<int>(kBands) - 1));
}

std::array<glm::dvec3, kBands> gathered(const Illuminant& illuminant, Observer observer) {
  const PerNm<glm::dvec3>& functions = matchingFunctions(observer);
  std::array<glm::dvec3, kBands> weights{};
  double whole = 0;
  for (size_t i = 0; i < kVisible; ++i) {
    const glm::dvec3 light = illuminant.power[i] * functions[i];
    whole += light.y;
    share(static_cast<double>(i) / kBandStep_nm,
          [&](int band, double factor) { weights[bandOf(band)] += factor * light; });
  }
  for (glm::dvec3& weight : weights) weight /= whole;
  return weights;
}

std::array<Spectrum, 3> rowsOf(const std::array<glm::dvec3, kBands>& columns) {
  std::array<Spectrum, 3> rows;
  for (int row = 0; row < 3; ++row)
    for (size_t j = 0; j < kBands; ++j) rows[row][j] = static_cast<float>(columns[j][row]);
  return rows;
}

}  // namespace

TristimulusWeights tristimulusWeights(const Illuminant& illuminant, Observer observer) {
  return {rowsOf(gathered(illuminant, observer))};
}

LinearWeights linearWeights(const Illuminant& illuminant, Observer observer) {
  std::array<glm::dvec3, kBands> weights = gathered(illuminant, observer);
  glm::dvec3 white(0);
  for (const glm::dvec3& weight : weights) white += weight;
  const glm::dvec3 d65 = d65Xyz();
  const glm::dmat3 adapted = bradford(white, d65);
  for (glm::dvec3& weight : weights) weight = linearFromWhiteXyz(adapted * weight / d65);
  return {rowsOf(weights)};
}

glm::dmat3 bradford(const glm::dvec3& fromWhite, const glm::dvec3& toWhite) {
  const glm::dmat3 cones{{0.8951, -0.7502, 0.0389}, {0.2664, 1.7135, -0.0685}, {-0.1614, 0.0367, 1.0296}};
  const glm::dvec3 gain = (cones * toWhite) / (cones * fromWhite);
  glm::dmat3 scaled = cones;
  for (int column = 0; column < 3; ++column) scaled[column] *= gain;
  return glm::inverse(cones) * scaled;
}

glm::dvec3 weighted(const std::array<Spectrum, 3>& rows, const Spectrum& values) {
  glm::dvec3 sums(0);
  for (int row = 0; row < 3; ++row)
    for (size_t j = 0; j < kBands; ++j) sums[row] += double(rows[row][j]) * values[j];
  return sums;
}

glm::dvec3 whiteXyz(const TristimulusWeights& weights) {
  Spectrum ones;
  ones.fill(1);
  return weighted(weights, ones);
}

}  // namespace loomlight
