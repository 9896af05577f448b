#pragma once

#include <vector>

namespace loomlight {

/// The value that this part of the others lies below, nearest rank: 0.5 is the median. 0 of no values.
double quantile(std::vector<double> values, double part);

}  // namespace loomlight
