#include "core/shell/shell.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/shell/drape_grid.h"
#include "core/shell/drape_surface.h"

namespace loomlight {
namespace {

constexpr double kHalf = 0.3;

DrapeMesh cylinder(double width, double height, double radius) {
  Drape drape;
  drape.kind = DrapeKind::cylinder;
  drape.width_mm = width;
  drape.height_mm = height;
  drape.radius_mm = radius;
  return makeDrape(drape);
}

DrapeMesh sphere(double size, double radius) {
  Drape drape;
  drape.kind = DrapeKind::sphere;
  drape.width_mm = drape.height_mm = size;
  drape.radius_mm = radius;
  return makeDrape(drape);
}

double volumeOf(const Shell& shell, const Shell::Tet& tet) {
  const glm::dvec3 a = shell.vertices()[tet.vertex[0]];
  return std::abs(glm::determinant(glm::dmat3(glm::dvec3(shell.vertices()[tet.vertex[1]]) - a,
                                              glm::dvec3(shell.vertices()[tet.vertex[2]]) - a,
                                              glm::dvec3(shell.vertices()[tet.vertex[3]]) - a))) /
         6;
}

glm::vec3 pointOf(const Shell& shell, const Shell::Tet& tet, glm::vec4 weight) {
  glm::vec3 point(0);
  for (int i = 0; i < 4; ++i) point += weight[i] * shell.vertices()[tet.vertex[i]];
  return point;
}

/// Random weights of the four vertices; `without` >= 0: on the face opposite that vertex.
glm::vec4 randomWeights(Random& random, int without) {
  glm::vec4 weight;
  for (int i = 0; i < 4; ++i) weight[i] = i == without ? 0 : -std::log(1 - random.uniform());
  return weight / (weight.x + weight.y + weight.z + weight.w);
}

using Corner = std::array<float, 3>;
Corner cornerAt(glm::vec3 p) {
  return {p.x, p.y, p.z};
}

class ShellOf : public testing::TestWithParam<const char*> {
 protected:
  ShellOf() : mesh_(meshOf(GetParam())), shell_(DrapeSurface(mesh_), kHalf) {}
  static DrapeMesh meshOf(const std::string& name) {
    if (name == "sphere") return sphere(12, 6);
    return name == "coil" ? cylinder(10, 2 * kPi * 6, 6) : cylinder(10, 20, 6);
  }
  bool continuousTexture() const { return GetParam() != std::string("coil"); }
  DrapeMesh mesh_;
  Shell shell_;
};

TEST_P(ShellOf, NeighboursShareAFaceAndItsPlane) {
  const auto tets = shell_.tets();
  for (size_t i = 0; i < tets.size(); ++i) {
    for (int face = 0; face < 4; ++face) {
      const int32_t other = tets[i].neighbour[face];
      if (other < 0) continue;
      const Shell::Tet& there = tets[static_cast<size_t>(other)];
      const auto back = std::find(there.neighbour, there.neighbour + 4, static_cast<int32_t>(i)) - there.neighbour;
      ASSERT_LT(back, 4) << "neighbourhood is mutual";
      ASSERT_EQ(tets[i].plane[face], -there.plane[back]) << "bitwise, or rays slip through";
      std::set<Corner> here, beyond;
      for (int k = 0; k < 4; ++k) {
        if (k != face) here.insert(cornerAt(shell_.vertices()[tets[i].vertex[k]]));
        if (k != back) beyond.insert(cornerAt(shell_.vertices()[there.vertex[k]]));
      }
      ASSERT_EQ(here, beyond);
    }
  }
}

TEST_P(ShellOf, EveryFaceIsInnerOrOfTheBoundary) {
  size_t inner = 0;
  for (const Shell::Tet& tet : shell_.tets())
    for (int face = 0; face < 4; ++face) inner += tet.neighbour[face] >= 0;
  EXPECT_EQ(inner + shell_.boundary().size(), 4 * shell_.tets().size());
  // The boundary is closed: every edge in it is run once each way.
  std::map<std::pair<Corner, Corner>, int> balance;
  for (const Shell::BoundaryFace& face : shell_.boundary())
    for (int k = 0; k < 3; ++k) {
      const Corner a = cornerAt(shell_.vertices()[face.vertex[k]]),
                   b = cornerAt(shell_.vertices()[face.vertex[(k + 1) % 3]]);
      balance[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
    }
  for (const auto& [edge, count] : balance) ASSERT_EQ(count, 0);
}

TEST_P(ShellOf, BoundaryFacesLookOutwards) {
  for (const Shell::BoundaryFace& face : shell_.boundary()) {
    const glm::vec3 a = shell_.vertices()[face.vertex[0]];
    const glm::vec3 normal =
        glm::normalize(glm::cross(shell_.vertices()[face.vertex[1]] - a, shell_.vertices()[face.vertex[2]] - a));
    const glm::vec3 middle = pointOf(shell_, shell_.tets()[face.tet], glm::vec4(0.25f));
    ASSERT_LT(glm::dot(normal, middle - a), 0);
  }
}

TEST_P(ShellOf, VolumeIsAreaTimesThickness) {
  double volume = 0, area = 0;
  for (const Shell::Tet& tet : shell_.tets()) volume += volumeOf(shell_, tet);
  for (const glm::uvec3& t : mesh_.triangles)
    area += 0.5 * glm::length(glm::cross(glm::dvec3(mesh_.positions[t[1]] - mesh_.positions[t[0]]),
                                         glm::dvec3(mesh_.positions[t[2]] - mesh_.positions[t[0]])));
  // A slab of half thickness h bent to Gaussian curvature K has 2 h (1 + K h^2 / 3) per area: nothing on a cylinder.
  const double curvature = GetParam() == std::string("sphere") ? 1.0 / 36 : 0.0;
  const double expected = area * 2 * kHalf * (1 + curvature * kHalf * kHalf / 3);
  // Layers lie along the normals of vertices, which lean against that of a facet by up to 1 / sqrt(2) of its angle.
  const double angle = facetAcross(6) / 6;
  EXPECT_NEAR(volume, expected, (angle * angle / 4 + 1e-4) * expected);
}

TEST_P(ShellOf, ClothCoordinatesAreThoseOfTheVertices) {
  for (size_t i = 0; i < shell_.tets().size(); ++i) {
    const Shell::Tet& tet = shell_.tets()[i];
    for (const uint32_t vertex : tet.vertex) {
      const glm::vec3 expected(mesh_.uv_mm[vertex / 2] - shell_.uvLower_mm(), vertex % 2 ? kHalf : -kHalf);
      ASSERT_LT(glm::distance(shell_.toCloth(static_cast<int>(i), shell_.vertices()[vertex]), expected), 2e-4f);
    }
    ASSERT_GT(glm::determinant(tet.toCloth), 0) << "right-handed";
  }
}

TEST_P(ShellOf, ClothCoordinatesContinueAcrossFaces) {
  if (!continuousTexture()) {
    // Only the seam may jump, and by the whole turn.
    size_t jumps = 0;
    for (const Shell::Tet& tet : shell_.tets())
      for (int face = 0; face < 4; ++face) {
        if (tet.neighbour[face] < 0) continue;
        const glm::vec3 point =
            pointOf(shell_, tet, glm::vec4(1 / 3.0f) * glm::vec4(face != 0, face != 1, face != 2, face != 3));
        const glm::vec3 here = tet.toCloth * point + tet.offset, there = shell_.toCloth(tet.neighbour[face], point);
        if (glm::distance(here, there) < 1e-3f) continue;
        ++jumps;
        EXPECT_NEAR(std::abs(here.y - there.y), 2 * kPi * 6, 1e-2);
      }
    EXPECT_GT(jumps, 0u);
    return;
  }
  Random random(3);
  for (size_t i = 0; i < shell_.tets().size(); ++i)
    for (int face = 0; face < 4; ++face) {
      const int32_t other = shell_.tets()[i].neighbour[face];
      if (other < 0) continue;
      const glm::vec3 point = pointOf(shell_, shell_.tets()[i], randomWeights(random, face));
      ASSERT_LT(glm::distance(shell_.toCloth(static_cast<int>(i), point), shell_.toCloth(other, point)), 2e-4f);
    }
}

TEST_P(ShellOf, FramesContinueAcrossFaces) {
  Random random(4);
  for (size_t i = 0; i < shell_.tets().size(); ++i)
    for (int face = 0; face < 4; ++face) {
      const int32_t other = shell_.tets()[i].neighbour[face];
      if (other < 0) continue;
      const glm::vec3 point = pointOf(shell_, shell_.tets()[i], randomWeights(random, face));
      const glm::mat3 a = shell_.frame(static_cast<int>(i), point), b = shell_.frame(other, point);
      // Across the coil's seam too, where the tangents come from two one-sided means.
      for (int column = 0; column < 3; ++column) ASSERT_LT(glm::distance(a[column], b[column]), 1e-3f);
    }
}

INSTANTIATE_TEST_SUITE_P(Drapes, ShellOf, testing::Values("cylinder", "coil", "sphere"),
                         [](const auto& info) { return std::string(info.param); });

TEST(Shell, FramesOfACylinderAreExact) {
  const Shell shell(DrapeSurface(cylinder(10, 20, 6)), kHalf);
  // Half way over a facet its plane lies below the arc, and the mean of two unit vectors is shorter than they are, both
  // by an eighth of the angle's square; a volume has all three.
  const double angle = facetAcross(6) / 6, sag = angle * angle / 8 * (1 + kHalf / 6) + 5e-4;
  Random random(5);
  for (int i = 0; i < 2000; ++i) {
    const int tet = static_cast<int>(random.below(static_cast<uint32_t>(shell.tets().size())));
    const glm::vec3 point = pointOf(shell, shell.tets()[static_cast<size_t>(tet)], randomWeights(random, -1));
    const glm::vec3 cloth = shell.toCloth(tet, point);
    const float turn = (cloth.y - 10) / 6, stretch = 1 + cloth.z / 6;
    const glm::mat3 expected(1, 0, 0, 0, stretch * std::cos(turn), -stretch * std::sin(turn), 0, std::sin(turn),
                             std::cos(turn));
    const glm::mat3 frame = shell.frame(tet, point);
    for (int column = 0; column < 3; ++column) ASSERT_LT(glm::distance(frame[column], expected[column]), 2 * sag);
    EXPECT_NEAR(glm::determinant(frame), stretch, 3 * sag);
  }
}

TEST(Shell, FrameInvertsTheMapToCloth) {
  const double half = 0.06, radius = 6;
  const Shell shell(DrapeSurface(sphere(8, radius)), half);
  // A tetrahedron may have the stretch of either layer all through, and its facet is off by half a facet's angle.
  const double tolerance = 2 * half / radius + facetAcross(radius) / radius / 2;
  Random random(6);
  for (int i = 0; i < 1000; ++i) {
    const int tet = static_cast<int>(random.below(static_cast<uint32_t>(shell.tets().size())));
    const Shell::Tet& t = shell.tets()[static_cast<size_t>(tet)];
    const glm::mat3 product = shell.frame(tet, pointOf(shell, t, glm::vec4(0.25f))) * t.toCloth;
    for (int column = 0; column < 3; ++column)
      for (int row = 0; row < 3; ++row) EXPECT_NEAR(product[column][row], column == row, tolerance);
  }
}

TEST(Shell, ACoilIsClosed) {
  // Only the two ends of the tube and its two faces bound it: the seam does not.
  const DrapeMesh mesh = cylinder(10, 2 * kPi * 6, 6);
  const Shell shell(DrapeSurface(mesh), kHalf);
  for (const Shell::BoundaryFace& face : shell.boundary()) {
    const glm::vec3 a = shell.vertices()[face.vertex[0]];
    const glm::vec3 normal =
        glm::normalize(glm::cross(shell.vertices()[face.vertex[1]] - a, shell.vertices()[face.vertex[2]] - a));
    const bool end = std::abs(normal.x) > 0.99f;
    const bool alongSurface = std::abs(glm::dot(normal, glm::normalize(glm::vec3(0, a.y, a.z)))) > 0.99f;
    EXPECT_TRUE(end || alongSurface);
  }
}

TEST(Shell, SharpBendsAreThinnedUntilNothingIsInsideOut) {
  const double half = 1.0;  // on a radius of 0.6: the inner layer would pass the axis
  const Shell shell(DrapeSurface(cylinder(3, 3, 0.6)), half);
  ASSERT_EQ(shell.repairs().size(), 1u);
  EXPECT_THAT(shell.repairs()[0], testing::AllOf(testing::StartsWith("drape: "), testing::HasSubstr("thinned")));
  for (const Shell::Tet& tet : shell.tets()) ASSERT_GT(glm::determinant(tet.toCloth), 0);
  // Still the whole cloth, to its two faces.
  for (size_t i = 0; i < shell.tets().size(); ++i)
    for (const uint32_t vertex : shell.tets()[i].vertex)
      EXPECT_NEAR(std::abs(shell.toCloth(static_cast<int>(i), shell.vertices()[vertex]).z), half, 1e-2);
}

// What is left out leaves nothing behind: the rest is linked as if it had never been there.
TEST(Shell, IsThatOfTheTrianglesThatCarryCloth) {
  DrapeMesh mesh = cylinder(3, 3, 5);
  const uint32_t creased = mesh.triangles[mesh.triangles.size() / 2][1];
  mesh.normals[creased] *= -1.0f;
  DrapeMesh rest = mesh;
  std::erase_if(rest.triangles, [&](glm::uvec3 t) { return t.x == creased || t.y == creased || t.z == creased; });
  const Shell shell(DrapeSurface(mesh), 0.1), expected(DrapeSurface(rest), 0.1);
  ASSERT_LT(rest.triangles.size(), mesh.triangles.size());
  ASSERT_EQ(shell.tets().size(), expected.tets().size());
  ASSERT_EQ(shell.boundary().size(), expected.boundary().size());
  for (size_t i = 0; i < shell.tets().size(); ++i)
    for (int k = 0; k < 4; ++k) {
      EXPECT_EQ(shell.tets()[i].vertex[k], expected.tets()[i].vertex[k]);
      EXPECT_EQ(shell.tets()[i].neighbour[k], expected.tets()[i].neighbour[k]);
    }
}

TEST(Shell, CreasesNoThicknessCanSaveAreLeftOut) {
  DrapeMesh mesh = cylinder(3, 3, 5);
  mesh.normals[mesh.triangles[0][1]] *= -1.0f;
  const Shell shell(DrapeSurface(mesh), 0.1);
  EXPECT_LT(shell.tets().size(), 3 * mesh.triangles.size());
  ASSERT_FALSE(shell.repairs().empty());
  EXPECT_THAT(shell.repairs().back(), testing::HasSubstr("left out"));
  for (glm::vec3& normal : mesh.normals) normal = -normal;
  for (glm::vec2& uv : mesh.uv_mm) uv.x = -uv.x;
  EXPECT_THROW(Shell(DrapeSurface(mesh), 0.1), InputError);
}

TEST(Shell, FlatIsATranslation) {
  const Shell shell = Shell::flat(20, 10, 0.25);
  EXPECT_TRUE(shell.isFlat());
  EXPECT_EQ(shell.lower_mm(), glm::vec3(-10, -5, -0.25f));
  EXPECT_EQ(shell.upper_mm(), glm::vec3(10, 5, 0.25f));
  EXPECT_EQ(shell.uvUpper_mm() - shell.uvLower_mm(), glm::vec2(20, 10));
  EXPECT_EQ(shell.toCloth(0, {1, 2, 0.1f}), glm::vec3(11, 7, 0.1f));
  EXPECT_EQ(shell.frame(0, {1, 2, 0}), glm::mat3(1));
  int face = -1;
  EXPECT_FLOAT_EQ(shell.exit(0, {1, 2, 0}, {1, 0, 0}, face), 9);
  EXPECT_FLOAT_EQ(shell.exit(0, {1, 2, 0}, {0, -1, 0}, face), 7);
}

}  // namespace
}  // namespace loomlight
