#pragma once

#include <vector>

namespace loomlight {

/// The value that this part of the others, 0..1, lies below: 0.5 is the median. Between two of them it is on a line
/// (Hyndman and Fan 1996, type 7). 0 of no values.
double quantile(std::vector<double> values, double part);

}  // namespace loomlight
