#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

#include "core/geometry/cloth/cloth_geometry.h"

namespace loomlight::test {

/// Points on the axes of a cell's fibres, a fibre radius from one to the next, with their fibre: in the cell's frame,
/// (x, y, z), x along the weft.
struct FibrePoint {
  glm::vec3 at;
  size_t fibre;
};
inline std::vector<FibrePoint> pointsOf(const ClothGeometry& cloth, System system, int pick, int end, size_t& fibres) {
  const CellStrands cell = cloth.strands(cloth.key(system, pick, end));
  std::vector<FibrePoint> points;
  fibres = 0;
  for (const CellStrands::Strand& strand : cell.strands) {
    if (strand.loose) continue;
    for (uint32_t i = strand.first; i + 1 < strand.first + strand.count; ++i) {
      const glm::vec3 a = cell.points[i], b = cell.points[i + 1];
      const int steps = std::max(1, static_cast<int>(std::ceil(glm::distance(a, b) / cell.fibreRadius_mm)));
      for (int k = 0; k < steps; ++k) {
        const glm::vec3 p = glm::mix(a, b, (static_cast<float>(k) + 0.5f) / static_cast<float>(steps));
        points.push_back({system == System::warp ? p : glm::vec3(p.y, -p.x, p.z), fibres});
      }
    }
    ++fibres;
  }
  return points;
}

/// Of all pairs of a warp and a weft fibre in a crossing, the share that come closer than so many fibre radii, of which
/// one is the mean of both.
inline double sharePressedTogether(const ClothGeometry& cloth, int pick, int end, double radii) {
  size_t warpFibres = 0, weftFibres = 0;
  const auto warp = pointsOf(cloth, System::warp, pick, end, warpFibres);
  const auto weft = pointsOf(cloth, System::weft, pick, end, weftFibres);
  const auto fibreRadius_mm = [&](System system) { return cloth.strands(cloth.key(system, pick, end)).fibreRadius_mm; };
  const double near_mm = radii * 0.5 * (fibreRadius_mm(System::warp) + fibreRadius_mm(System::weft));
  const auto bucketOf = [near_mm](glm::vec3 p) { return glm::ivec3(glm::floor(glm::dvec3(p) / near_mm)); };
  const auto name = [](glm::ivec3 b) { return std::tuple(b.x, b.y, b.z); };
  std::map<std::tuple<int, int, int>, std::vector<FibrePoint>> buckets;
  for (const FibrePoint& p : warp) buckets[name(bucketOf(p.at))].push_back(p);
  std::vector<uint8_t> close(warpFibres * weftFibres);
  for (const FibrePoint& p : weft)
    for (int i = 0; i < 27; ++i) {
      const auto found = buckets.find(name(bucketOf(p.at) + glm::ivec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1)));
      if (found == buckets.end()) continue;
      for (const FibrePoint& q : found->second)
        if (glm::distance(p.at, q.at) < near_mm) close[q.fibre * weftFibres + p.fibre] = 1;
    }
  double pairs = 0;
  for (const uint8_t pair : close) pairs += pair;
  return pairs / static_cast<double>(close.size());
}

}  // namespace loomlight::test
