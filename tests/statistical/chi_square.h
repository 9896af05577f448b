#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/random.h"
#include "core/base/units.h"

/// Does a sampler really draw from the density it claims? Pearson's chi-square test on an interval and on the sphere.
///
///   const ChiSquare test = chiSquareOnSphere([&](Random& random) { return lobe.sample(random); },
///                                            [&](glm::vec3 w) { return lobe.pdf(w); });
///   EXPECT_TRUE(fits(test, runs));  // runs: how many such tests the whole TEST makes
namespace loomlight::test {

struct ChiSquare {
  double statistic = 0;
  int freedom = 0;      ///< degrees of freedom: bins after pooling, less one
  double pValue = 1;    ///< probability of a statistic at least this large if the sampler is right
  double integral = 1;  ///< of the density over the whole domain
};

struct ChiSquareSettings {
  int samples = 100000;
  int bins = 33;       ///< along the interval, or along the polar axis of the sphere; twice as many around it
  int quadrature = 2;  ///< panels per bin and axis, each with four Gauss points; more for narrow or kinked densities
  uint64_t seed = 1;
  glm::vec3 axis{0, 0, 1};  ///< unit; polar axis of the sphere's bins
};

/// Upper tail of the chi-square distribution, Q(freedom / 2, statistic / 2): series below the mean, Lentz's continued
/// fraction above it (Abramowitz & Stegun 6.5.29, 6.5.31).
inline double chiSquareTail(double statistic, int freedom) {
  const double a = 0.5 * freedom, x = 0.5 * statistic;
  if (freedom <= 0 || !(x > 0)) return std::isnan(x) ? 0.0 : 1.0;
  const double front = std::exp(a * std::log(x) - x - std::lgamma(a));
  if (x < a + 1) {
    double term = 1 / a, sum = term;
    for (int n = 1; n < 100000 && term > sum * 1e-15; ++n) sum += term *= x / (a + n);
    return 1 - front * sum;
  }
  double b = x + 1 - a, c = 1e300, d = 1 / b, fraction = d;
  for (int n = 1; n < 100000; ++n) {
    const double an = -n * (n - a);
    b += 2;
    d = 1 / (an * d + b);
    c = b + an / c;
    fraction *= c * d;
    if (std::abs(c * d - 1) < 1e-14) break;
  }
  return front * fraction;
}

/// Pearson's test of counts against expected counts. Bins are pooled, smallest expectation first, until each pool
/// expects at least five, below which the statistic is not chi-square distributed.
inline ChiSquare chiSquare(const std::vector<double>& observed, const std::vector<double>& expected) {
  std::vector<size_t> order(expected.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::sort(order.begin(), order.end(), [&](size_t i, size_t j) { return expected[i] < expected[j]; });
  ChiSquare test;
  double o = 0, e = 0, lastObserved = 0, lastExpected = 0;
  int pools = 0;
  const auto term = [](double count, double mean) { return (count - mean) * (count - mean) / mean; };
  for (const size_t i : order) {
    o += observed[i];
    e += expected[i];
    if (e < 5) continue;
    test.statistic += term(o, e);
    lastObserved = std::exchange(o, 0);
    lastExpected = std::exchange(e, 0);
    ++pools;
  }
  if (pools > 0 && (o > 0 || e > 0)) {  // what is left over is too small for a pool of its own
    test.statistic += term(lastObserved + o, lastExpected + e) - term(lastObserved, lastExpected);
  }
  test.freedom = pools - 1;
  test.pValue = chiSquareTail(test.statistic, test.freedom);
  return test;
}

/// The integral of f over [low, high]: `panels` equal panels of four Gauss-Legendre points.
template <class Function>
double integrate(Function&& f, double low, double high, int panels) {
  constexpr std::array<double, 2> x{0.339981043584856265, 0.861136311594052575};
  constexpr std::array<double, 2> w{0.652145154862546143, 0.347854845137453857};
  const double half = 0.5 * (high - low) / panels;
  double sum = 0;
  for (int i = 0; i < panels; ++i) {
    const double middle = low + (2 * i + 1) * half;
    for (size_t k = 0; k < 2; ++k) sum += w[k] * (f(middle - half * x[k]) + f(middle + half * x[k]));
  }
  return sum * half;
}

namespace detail {

/// `counts` and `mass` have one bin more than the domain: draws that gave nothing.
inline ChiSquare finish(const std::vector<double>& counts, std::vector<double> mass, int samples) {
  const double integral = std::accumulate(mass.begin(), mass.end(), 0.0);
  mass.back() = std::max(0.0, 1 - integral);
  for (double& m : mass) m *= samples;
  ChiSquare test = chiSquare(counts, mass);
  test.integral = integral;
  return test;
}

inline size_t binOf(double fraction, int bins) {
  return static_cast<size_t>(std::clamp(static_cast<int>(fraction * bins), 0, bins - 1));
}

}  // namespace detail

/// sampler(Random&) gives a number in [low, high], or an empty std::optional where it finds nothing (the density then
/// integrates to less than one); pdf(double) its density.
template <class Sampler, class Pdf>
ChiSquare chiSquareOnInterval(double low, double high, Sampler&& sampler, Pdf&& pdf, ChiSquareSettings settings = {}) {
  const int bins = settings.bins;
  const double width = (high - low) / bins;
  std::vector<double> counts(static_cast<size_t>(bins) + 1), mass(counts.size());
  for (int i = 0; i < bins; ++i)
    mass[static_cast<size_t>(i)] = integrate(pdf, low + i * width, low + (i + 1) * width, settings.quadrature);
  Random random(settings.seed);
  for (int i = 0; i < settings.samples; ++i) {
    const std::optional<double> x = sampler(random);
    counts[x ? detail::binOf((*x - low) / (high - low), bins) : counts.size() - 1] += 1;
  }
  return detail::finish(counts, std::move(mass), settings.samples);
}

/// sampler(Random&) gives a unit vector, or an empty std::optional where it finds nothing; pdf(glm::vec3) its density
/// per solid angle. Bins are equal in the angle from `axis` and in the angle about it.
template <class Sampler, class Pdf>
ChiSquare chiSquareOnSphere(Sampler&& sampler, Pdf&& pdf, ChiSquareSettings settings = {}) {
  const glm::dvec3 axis = glm::normalize(glm::dvec3(settings.axis));
  const glm::dvec3 other = std::abs(axis.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 u = glm::normalize(glm::cross(axis, other)), v = glm::cross(axis, u);
  const int rows = settings.bins, columns = 2 * settings.bins;
  const double dtheta = kPi / rows, dphi = 2 * kPi / columns;
  std::vector<double> counts(static_cast<size_t>(rows) * static_cast<size_t>(columns) + 1), mass(counts.size());
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const auto ring = [&](double theta) {
        const auto point = [&](double phi) {
          const glm::dvec3 around = std::cos(phi) * u + std::sin(phi) * v;
          return static_cast<double>(pdf(glm::vec3(std::cos(theta) * axis + std::sin(theta) * around)));
        };
        const double low = -kPi + column * dphi;
        return std::sin(theta) * integrate(point, low, low + dphi, settings.quadrature);
      };
      mass[static_cast<size_t>(row) * static_cast<size_t>(columns) + static_cast<size_t>(column)] =
          integrate(ring, row * dtheta, (row + 1) * dtheta, settings.quadrature);
    }
  }
  Random random(settings.seed);
  for (int i = 0; i < settings.samples; ++i) {
    const std::optional<glm::vec3> w = sampler(random);
    size_t bin = counts.size() - 1;
    if (w) {
      const glm::dvec3 d(*w);
      const double phi = std::atan2(glm::dot(d, v), glm::dot(d, u));
      const double theta = std::acos(std::clamp(glm::dot(d, axis), -1.0, 1.0));
      bin = detail::binOf(theta / kPi, rows) * static_cast<size_t>(columns) +
            detail::binOf((phi + kPi) / (2 * kPi), columns);
    }
    counts[bin] += 1;
  }
  return detail::finish(counts, std::move(mass), settings.samples);
}

/// Passes unless the sampler would look this bad by chance less often than once in 1/significance runs of the whole
/// TEST, which makes `runs` such tests (Sidak's correction).
inline testing::AssertionResult fits(const ChiSquare& test, int runs = 1, double significance = 1e-3) {
  const double threshold = -std::expm1(std::log1p(-significance) / runs);
  if (test.freedom < 1) return testing::AssertionFailure() << "fewer than two bins expect any samples";
  if (test.pValue >= threshold) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "chi-square " << test.statistic << " with " << test.freedom
                                     << " degrees of freedom: p = " << test.pValue << " < " << threshold
                                     << "; the density integrates to " << test.integral;
}

}  // namespace loomlight::test
