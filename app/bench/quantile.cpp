#include "app/bench/quantile.h"

#include <algorithm>
#include <cmath>

namespace loomlight {

double quantile(std::vector<double> values, double part) {
  if (values.empty()) return 0;
  const auto nth = values.begin() + std::lround(part * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), nth, values.end());
  return *nth;
}

}  // namespace loomlight
