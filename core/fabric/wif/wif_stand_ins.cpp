#include "core/fabric/wif/wif_stand_ins.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace loomlight {

double distanceOf(const YarnPoint& a, const YarnPoint& b) {
  double sum = 0;
  for (size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum);
}

std::vector<size_t> standIns(std::span<const YarnPoint> points, size_t most) {
  std::vector<size_t> standIn(points.size(), 0);
  std::vector<double> distance(points.size(), std::numeric_limits<double>::infinity());
  size_t next = 0;
  for (size_t kept = 0; kept < most; ++kept) {
    for (size_t i = 0; i < points.size(); ++i) {
      const double to = distanceOf(points[i], points[next]);
      if (to >= distance[i]) continue;
      distance[i] = to;
      standIn[i] = next;
    }
    next = static_cast<size_t>(std::max_element(distance.begin(), distance.end()) - distance.begin());
    if (distance[next] == 0) break;
  }
  return standIn;
}

}  // namespace loomlight
