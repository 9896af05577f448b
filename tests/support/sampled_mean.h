#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

namespace loomlight::test {

/// The mean of independent draws, and how well it is known (Welford 1962).
class SampledMean {
 public:
  void add(double value) {
    ++count_;
    const double change = value - mean_;
    mean_ += change / static_cast<double>(count_);
    squares_ += change * (value - mean_);
  }
  uint64_t count() const { return count_; }
  double mean() const { return mean_; }
  double variance() const { return squares_ / static_cast<double>(count_ - 1); }  ///< of one draw; from two draws on
  double standardError() const { return std::sqrt(variance() / static_cast<double>(count_)); }

 private:
  uint64_t count_ = 0;
  double mean_ = 0, squares_ = 0;
};

/// Probability that a normal deviate is at least so many standard deviations from its mean, on either side.
inline double normalTail(double deviations) {
  return std::erfc(std::abs(deviations) / std::sqrt(2.0));
}

/// Passes unless the value would be this far from what is expected, by chance, less often than once in 1/significance
/// runs of all the `runs` comparisons that are made together (Sidak's correction). A NaN fails, and what
/// has no noise must be equal.
inline testing::AssertionResult isWithinNoise(double value, double expected, double standardError, int runs,
                                              double significance = 1e-3) {
  const double deviations = (value - expected) / standardError;
  const double chance = normalTail(deviations), threshold = -std::expm1(std::log1p(-significance) / runs);
  if (value == expected || chance >= threshold) return testing::AssertionSuccess();
  return testing::AssertionFailure() << value << " instead of " << expected << ": " << deviations
                                     << " standard errors of " << standardError << ", p = " << chance << " < "
                                     << threshold;
}

}  // namespace loomlight::test
