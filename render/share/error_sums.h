#pragma once

#include <algorithm>
#include <cmath>

namespace loomlight {

/// What the error of the cells is read off: how much further than noise explains the film is apart from them. Over the
/// whole picture, or a few lucky paths would vouch for each other.
struct ErrorSums {
  double apart2 = 0;  ///< the film from the cells, squared
  double noise = 0;   ///< of that, as the cells let expect it
  double light2 = 0;  ///< of the cells, squared
  double count = 0;

  void operator+=(const ErrorSums& other) {
    apart2 += other.apart2;
    noise += other.noise;
    light2 += other.light2;
    count += other.count;
  }

  /// The square of the error, as a share of the square of the cells' light. So much more noise than expected as there
  /// may be by chance is no error. `variesBy`: the variance of one square, in squares of its mean.
  float relativeError2(double variesBy) const {
    if (light2 <= 0) return 0;
    const double chance = 1 + 3 * std::sqrt(variesBy / count);
    return static_cast<float>(std::max(0.0, apart2 - chance * noise) / light2);
  }
};

}  // namespace loomlight
