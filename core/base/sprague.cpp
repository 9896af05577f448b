#include "core/base/sprague.h"

#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>

// How it works. Between two samples the polynomial is given by the three on either side. The first and the last
// interval lack two of them; these are extrapolated from the six at that end (CIE 167:2005).

namespace loomlight {
namespace {

using Six = std::array<double, 6>;

constexpr Six kOneBeyond{508, -540, 488, -367, 144, -24}, kTwoBeyond{884, -1960, 3033, -2648, 1080, -180};
constexpr double kBeyondOver = 209;

/// Powers of the distance from the third of six samples, times 24.
constexpr std::array<Six, 6> kPowers{{{0, 0, 24, 0, 0, 0},
                                      {2, -16, 0, 16, -2, 0},
                                      {-1, 16, -30, 16, -1, 0},
                                      {-9, 39, -70, 66, -33, 7},
                                      {13, -64, 126, -124, 61, -12},
                                      {-5, 25, -50, 50, -25, 5}}};

double sampleAt(std::span<const double> samples, ptrdiff_t i) {
  const ptrdiff_t last = static_cast<ptrdiff_t>(samples.size()) - 1;
  if (i >= 0 && i <= last) return samples[i];
  const ptrdiff_t beyond = i < 0 ? -i : i - last;
  const Six& factors = beyond == 1 ? kOneBeyond : kTwoBeyond;
  double sum = 0;
  for (ptrdiff_t k = 0; k < 6; ++k) sum += factors[k] * samples[i < 0 ? k : last - k];
  return sum / kBeyondOver;
}

}  // namespace

double sprague(std::span<const double> samples, double at) {
  assert(samples.size() >= kSpragueSamples && at >= 0 && at <= static_cast<double>(samples.size() - 1));
  const auto before = static_cast<ptrdiff_t>(std::floor(at));
  const double x = at - static_cast<double>(before);
  if (x == 0) return samples[before];
  double value = 0;
  for (size_t power = 6; power-- > 0;) {
    double factor = 0;
    for (ptrdiff_t k = 0; k < 6; ++k) factor += kPowers[power][k] * sampleAt(samples, before - 2 + k);
    value = value * x + factor / 24;
  }
  return value;
}

}  // namespace loomlight
