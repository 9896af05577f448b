#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace loomlight {

/// For every vertex the first one at the very same position, so that seams in texture space are none in the world.
/// Positions are finite.
std::vector<uint32_t> weldByPosition(std::span<const glm::vec3> positions);

/// One side of one triangle, as an undirected edge between welded vertices, low < high.
struct TriangleSide {
  uint32_t low, high;
  uint32_t triangle;
  uint8_t corner;  ///< the side runs from this corner to the next one
  bool forward;    ///< from low to high
};

/// All sides of all triangles, sorted so that the sides of one edge are neighbours in the list, in order of triangles.
std::vector<TriangleSide> sortedSides(std::span<const glm::uvec3> triangles, std::span<const uint32_t> welded);

/// Calls visit(span of sides) for every edge.
template <class Visit>
void forEachEdge(std::span<const TriangleSide> sides, Visit visit) {
  for (size_t first = 0, last = 0; first < sides.size(); first = last) {
    while (last < sides.size() && sides[last].low == sides[first].low && sides[last].high == sides[first].high) ++last;
    visit(sides.subspan(first, last - first));
  }
}

}  // namespace loomlight
