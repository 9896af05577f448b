#include <gtest/gtest.h>

#include <algorithm>

#include "core/geometry/cloth/cloth_geometry.h"
#include "tests/unit/geometry/cloths.h"

namespace loomlight {
namespace {

struct EndPoint {
  glm::dvec2 place;      ///< (u, z)
  glm::dvec3 direction;  ///< along +s
  int ply;
};

/// Where strands cross the cell's end at s = side * pitch / 2.
std::vector<EndPoint> crossings(const CellStrands& cell, double pitch_mm, int side) {
  const float edge = static_cast<float>(0.5 * pitch_mm) * static_cast<float>(side);
  std::vector<EndPoint> found;
  for (const CellStrands::Strand& strand : cell.strands) {
    const auto visit = [&](uint32_t at, uint32_t neighbour) {
      const glm::dvec3 p = cell.points[at], q = cell.points[neighbour];
      if (cell.points[at].y != edge) return;
      const glm::dvec3 d = glm::normalize(side > 0 ? p - q : q - p);
      found.push_back({{p.x, p.z}, d, strand.ply});
    };
    visit(strand.first, strand.first + 1);
    visit(strand.first + strand.count - 1, strand.first + strand.count - 2);
  }
  return found;
}

/// Most that any fibre turns between two of its segments, as the distance of unit directions: what a polyline owes to
/// its chords.
double sharpestTurn(const CellStrands& cell) {
  double most = 0;
  for (const CellStrands::Strand& strand : cell.strands)
    for (uint32_t i = strand.first + 1; i + 1 < strand.first + strand.count; ++i) {
      const glm::dvec3 before = glm::dvec3(cell.points[i]) - glm::dvec3(cell.points[i - 1]);
      const glm::dvec3 after = glm::dvec3(cell.points[i + 1]) - glm::dvec3(cell.points[i]);
      most = std::max(most, glm::distance(glm::normalize(before), glm::normalize(after)));
    }
  return most;
}

/// Every strand that leaves one cell enters the next at the same place, in the same direction up to a turn that it also
/// makes at its stations, and nothing else enters.
void expectJoin(const ClothGeometry& cloth, const YarnCellKey& from, const YarnCellKey& to) {
  const double pitch = cloth.yarn(from.system, from.yarn).pitch_mm;
  const CellStrands first = cloth.strands(from), second = cloth.strands(to);
  const std::vector<EndPoint> leave = crossings(first, pitch, 1), enter = crossings(second, pitch, -1);
  ASSERT_GE(leave.size(), first.strands.size() / 2);
  ASSERT_EQ(leave.size(), enter.size());
  double furthest = 0, mostTurned = 0;
  for (size_t i = 0; i < leave.size(); ++i) {
    furthest = std::max(furthest, glm::distance(leave[i].place, enter[i].place));
    mostTurned = std::max(mostTurned, glm::distance(leave[i].direction, enter[i].direction));
    ASSERT_EQ(leave[i].ply, enter[i].ply);
  }
  ASSERT_LT(furthest, 1e-6);
  // Rounding of the ends of a short cut segment turns it by some 1e-7 mm over its length: hence the second term.
  ASSERT_LT(mostTurned, std::max(sharpestTurn(first), sharpestTurn(second)) + 0.01);
}

TEST(CellContinuity, FibresGoOnInTheNextCell) {
  for (const Fabric& fabric : cloths::all()) {
    SCOPED_TRACE(fabric.name);
    const ClothGeometry cloth(fabric, 40, 40);
    for (const System system : {System::warp, System::weft}) {
      const bool warp = system == System::warp;
      // Two periods along a few yarns: all neighbours of the repeat, and phases that wrap.
      for (int across = 0; across < 5; ++across)
        for (int along = -3; along < 29; ++along) {
          const YarnCellKey from = warp ? cloth.key(system, along, across) : cloth.key(system, across, along);
          const YarnCellKey to = warp ? cloth.key(system, along + 1, across) : cloth.key(system, across, along + 1);
          ASSERT_EQ(to.phase, (from.phase + 1) % cloth.yarn(system, from.yarn).period);
          expectJoin(cloth, from, to);
          if (HasFatalFailure()) return;
        }
    }
  }
}

TEST(PathContinuity, TransitionsAreSmooth) {
  for (const Fabric& fabric : cloths::all()) {
    SCOPED_TRACE(fabric.name);
    const ClothGeometry cloth(fabric, 8, 8);
    for (int pick = 0; pick < 8; ++pick) {
      const YarnCellKey key = cloth.key(System::warp, pick, 1);
      const double span = spanBetween_mm(key.here, key.next, cloth.yarn(System::warp, key.yarn).pitch_mm);
      const Transition path(key.here, key.next, span);
      const AxisPoint start = path.at(0), end = path.at(path.length_mm());
      EXPECT_NEAR(start.z_mm, key.here.height_mm, 1e-9);
      EXPECT_NEAR(start.angle, 0, 1e-9);
      EXPECT_NEAR(end.s_mm, span, 1e-6);
      EXPECT_NEAR(end.z_mm, key.next.height_mm, 1e-6);
      EXPECT_NEAR(end.angle, 0, 1e-6);
      for (size_t i = 1; i < path.pieces().size(); ++i) {
        const auto &a = path.pieces()[i - 1], &b = path.pieces()[i];
        EXPECT_NEAR(a.start.angle + a.curvature_per_mm * a.length_mm, b.start.angle, 1e-9);
      }
      // lengthTo() is the inverse of at().s.
      for (const double share : {0.1, 0.37, 0.5, 0.81})
        EXPECT_NEAR(path.at(path.lengthTo(share * span)).s_mm, share * span, 1e-9);
    }
  }
}

}  // namespace
}  // namespace loomlight
