#include "core/shell/mesh_topology.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace loomlight {

std::vector<uint32_t> weldByPosition(std::span<const glm::vec3> positions) {
  const auto key = [&](uint32_t i) { return std::tie(positions[i].x, positions[i].y, positions[i].z); };
  std::vector<uint32_t> order(positions.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) {
    return std::tuple_cat(key(a), std::tie(a)) < std::tuple_cat(key(b), std::tie(b));
  });

  std::vector<uint32_t> welded(positions.size());
  for (size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && key(order[i]) == key(order[i - 1]);
    welded[order[i]] = same ? welded[order[i - 1]] : order[i];
  }
  return welded;
}

std::vector<TriangleSide> sortedSides(std::span<const glm::uvec3> triangles, std::span<const uint32_t> welded) {
  std::vector<TriangleSide> sides;
  sides.reserve(3 * triangles.size());
  for (uint32_t triangle = 0; triangle < triangles.size(); ++triangle) {
    for (uint8_t corner = 0; corner < 3; ++corner) {
      const uint32_t from = welded[triangles[triangle][corner]];
      const uint32_t to = welded[triangles[triangle][(corner + 1) % 3]];
      sides.push_back({std::min(from, to), std::max(from, to), triangle, corner, from < to});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const TriangleSide& a, const TriangleSide& b) {
    return std::tie(a.low, a.high, a.triangle, a.corner) < std::tie(b.low, b.high, b.triangle, b.corner);
  });
  return sides;
}

}  // namespace loomlight
