#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>

namespace loomlight {

/// A triangle's prism as three tetrahedra. Corners 0, 1, 2 are the triangle's, sorted by welded vertex index, on the
/// lower side; 3, 4, 5 the same on the upper side. The diagonal of the side between corners i < j runs from lower i to
/// upper j, whatever the prism: neighbours that see the same two vertices split their common side alike.
inline constexpr int kPrismTets[3][4] = {{0, 1, 2, 5}, {0, 1, 4, 5}, {0, 3, 4, 5}};

/// Sign of det(v1 - v0, v2 - v0, v3 - v0) of each tetrahedron, when the sorted corners are counter-clockwise from
/// above.
inline constexpr double kPrismTetSign[3] = {1, -1, 1};

/// Where a face of a tetrahedron leads: to a tetrahedron of the same prism, across a side, or out of the cloth.
struct PrismFace {
  enum class Kind : uint8_t { inner, side, outer };
  Kind kind;
  uint8_t target;  ///< inner: tetrahedron 0..2; side: 0 (corners 0-1), 1 (1-2), 2 (0-2)
  uint8_t upper;   ///< side: 0 the triangle with two lower vertices, 1 the one with two upper vertices
};

/// kPrismFaces[tetrahedron][i]: the face opposite vertex i.
inline constexpr PrismFace kPrismFaces[3][4] = {{{PrismFace::Kind::side, 1, 0},
                                                 {PrismFace::Kind::side, 2, 0},
                                                 {PrismFace::Kind::inner, 1, 0},
                                                 {PrismFace::Kind::outer, 0, 0}},
                                                {{PrismFace::Kind::side, 1, 1},
                                                 {PrismFace::Kind::inner, 2, 0},
                                                 {PrismFace::Kind::inner, 0, 0},
                                                 {PrismFace::Kind::side, 0, 0}},
                                                {{PrismFace::Kind::outer, 0, 1},
                                                 {PrismFace::Kind::inner, 1, 0},
                                                 {PrismFace::Kind::side, 2, 1},
                                                 {PrismFace::Kind::side, 0, 1}}};

/// The tetrahedron of a prism that holds the lower (0) or upper (1) triangle of a side.
inline constexpr int kSideTets[3][2] = {{1, 2}, {0, 1}, {0, 2}};

/// The corners (0..2) of a triangle in the order of their welded vertices.
inline std::array<int, 3> sortedCorners(const glm::uvec3& triangle, std::span<const uint32_t> welded) {
  std::array<int, 3> order{0, 1, 2};
  const auto swapIfBelow = [&](int i, int j) {
    if (welded[triangle[order[j]]] < welded[triangle[order[i]]]) std::swap(order[i], order[j]);
  };
  swapIfBelow(0, 1);
  swapIfBelow(1, 2);
  swapIfBelow(0, 1);
  return order;
}

/// +1 if sorting the corners kept the triangle's orientation, -1 if it turned it over.
inline double orientation(const std::array<int, 3>& order) {
  return (order[0] + 1) % 3 == order[1] ? 1.0 : -1.0;
}

/// Index of the side (as in PrismFace) that joins two positions in the sorted order.
inline int sideBetween(int i, int j) {
  return i + j == 1 ? 0 : (i + j == 3 ? 1 : 2);
}

}  // namespace loomlight
