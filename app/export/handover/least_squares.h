#pragma once

#include <functional>
#include <span>
#include <vector>

namespace loomlight {

/// One unknown of a fit: where it begins, and between which values it stays.
struct Unknown {
  double start = 0, low = 0, high = 1;
};

struct LeastSquares {
  std::vector<double> values;  ///< of the unknowns, within their bounds
  double sum = 0;              ///< of the squares of the residuals there
  int steps = 0;               ///< that were taken
};

/// The unknowns for which the squares of the residuals sum up to least, near where they begin: the method of Levenberg
/// and Marquardt with differences for derivatives, each step cut at the bounds. `residuals`: always as many, finite
/// numbers, a smooth function. Ends after `mostSteps`, or once a step gains less than a millionth.
LeastSquares leastSquares(std::span<const Unknown> unknowns,
                          const std::function<std::vector<double>(std::span<const double>)>& residuals,
                          int mostSteps = 60);

}  // namespace loomlight
