#include "core/shell/drape_mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/base/error.h"
#include "core/shell/drape_grid.h"

namespace loomlight {
namespace {

using testing::HasSubstr;

Drape drapeOf(DrapeKind kind, double width, double height, double radius) {
  Drape drape;
  drape.kind = kind;
  drape.width_mm = width;
  drape.height_mm = height;
  drape.radius_mm = radius;
  return drape;
}

/// Length in the world of the image of the straight line in the cloth that runs along one row or column of the grid.
double lengthAlong(const DrapeMesh& mesh, int axis, float across) {
  std::vector<std::pair<float, glm::vec3>> points;
  for (size_t i = 0; i < mesh.positions.size(); ++i)
    if (std::abs(mesh.uv_mm[i][1 - axis] - across) < 1e-4f) points.emplace_back(mesh.uv_mm[i][axis], mesh.positions[i]);
  std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  double length = 0;
  for (size_t i = 1; i < points.size(); ++i) length += glm::distance(points[i].second, points[i - 1].second);
  return length;
}

void expectSound(const DrapeMesh& mesh) {
  glm::vec3 lower(1e9f), upper(-1e9f);
  for (size_t i = 0; i < mesh.positions.size(); ++i) {
    lower = glm::min(lower, mesh.positions[i]);
    upper = glm::max(upper, mesh.positions[i]);
    EXPECT_NEAR(glm::length(mesh.normals[i]), 1, 1e-5);
  }
  EXPECT_LT(glm::length(lower + upper), 1e-2f * glm::length(upper - lower)) << "not centred";
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::vec3 normal =
        glm::cross(mesh.positions[t[1]] - mesh.positions[t[0]], mesh.positions[t[2]] - mesh.positions[t[0]]);
    const glm::vec2 u1 = mesh.uv_mm[t[1]] - mesh.uv_mm[t[0]], u2 = mesh.uv_mm[t[2]] - mesh.uv_mm[t[0]];
    ASSERT_GT(u1.x * u2.y - u1.y * u2.x, 0) << "mirrored";
    for (int k = 0; k < 3; ++k) ASSERT_GT(glm::dot(glm::normalize(normal), mesh.normals[t[k]]), 0.99f);
  }
}

TEST(Drape, FlatLiesFaceUp) {
  const DrapeMesh mesh = makeDrape(drapeOf(DrapeKind::flat, 20, 10, 6));
  expectSound(mesh);
  EXPECT_EQ(mesh.triangles.size(), 2u);
  EXPECT_EQ(mesh.normals[0], glm::vec3(0, 0, 1));
  EXPECT_NEAR(lengthAlong(mesh, 0, 0), 20, 1e-5);
  EXPECT_NEAR(lengthAlong(mesh, 1, 0), 10, 1e-5);
}

TEST(Drape, CylinderIsIsometric) {
  const DrapeMesh mesh = makeDrape(drapeOf(DrapeKind::cylinder, 20, 24, 6));
  expectSound(mesh);
  EXPECT_TRUE(mesh.repairs.empty());
  // A facet that turns by an angle a is shorter than its arc by 1 - sinc(a / 2), which is below a^2 / 24.
  const double shorter = std::pow(facetAcross(6) / 6, 2) / 24;
  EXPECT_LT(shorter, 3e-4);
  EXPECT_NEAR(lengthAlong(mesh, 1, 0), 24, 24 * shorter + 1e-4);
  EXPECT_NEAR(lengthAlong(mesh, 0, 0), 20, 1e-4);
  for (const glm::uvec3& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) {
      const uint32_t a = t[k], b = t[(k + 1) % 3];
      EXPECT_NEAR(glm::distance(mesh.positions[a], mesh.positions[b]) / glm::distance(mesh.uv_mm[a], mesh.uv_mm[b]), 1,
                  shorter + 1e-5);
    }
}

TEST(Drape, CylinderShowsItsFaceUpwardsAndTheWarpRunsRound) {
  const DrapeMesh mesh = makeDrape(drapeOf(DrapeKind::cylinder, 20, 20, 6));
  const auto top = std::max_element(mesh.positions.begin(), mesh.positions.end(),
                                    [](glm::vec3 a, glm::vec3 b) { return a.z < b.z; }) -
                   mesh.positions.begin();
  EXPECT_GT(mesh.normals[static_cast<size_t>(top)].z, 0.999f);
  EXPECT_NEAR(mesh.uv_mm[static_cast<size_t>(top)].y, 10, 0.2);
  for (size_t i = 0; i < mesh.positions.size(); ++i) EXPECT_NEAR(mesh.positions[i].x, mesh.uv_mm[i].x - 10, 1e-4);
}

TEST(Drape, CylinderIsCutToOneTurnAndSaysSo) {
  const DrapeMesh mesh = makeDrape(drapeOf(DrapeKind::cylinder, 5, 100, 6));
  expectSound(mesh);
  ASSERT_EQ(mesh.repairs.size(), 1u);
  EXPECT_THAT(mesh.repairs[0], HasSubstr("cut to 37.7 mm"));
  EXPECT_NEAR(lengthAlong(mesh, 1, 0), 2 * kPi * 6, 2 * kPi * 6 * std::pow(facetAcross(6) / 6, 2) / 24 + 1e-4);
  // The ends meet exactly, so that the shell closes.
  const auto lastRow =
      std::find_if(mesh.uv_mm.begin(), mesh.uv_mm.end(), [&](glm::vec2 uv) { return uv.y == mesh.uv_mm.back().y; });
  EXPECT_EQ(mesh.positions.front(), mesh.positions[static_cast<size_t>(lastRow - mesh.uv_mm.begin())]);
}

/// How the surface of a triangle runs along the weft and the warp of its cloth.
struct Ways {
  glm::dvec3 weft, warp;
};

Ways waysOf(const DrapeMesh& mesh, const glm::uvec3& t) {
  const glm::dvec3 a = mesh.positions[t[1]] - mesh.positions[t[0]], b = mesh.positions[t[2]] - mesh.positions[t[0]];
  const glm::dvec2 u = mesh.uv_mm[t[1]] - mesh.uv_mm[t[0]], v = mesh.uv_mm[t[2]] - mesh.uv_mm[t[0]];
  const double area = u.x * v.y - u.y * v.x;
  return {(a * v.y - b * u.y) / area, (b * u.x - a * v.x) / area};
}

// The surface stays, and on it the warp goes to the left by that angle, which is counter-clockwise seen from the face.
TEST(Drape, GrainTurnsTheClothOnItsSurface) {
  for (const DrapeKind kind : {DrapeKind::cylinder, DrapeKind::sphere, DrapeKind::folds, DrapeKind::cushion,
                               DrapeKind::skirt, DrapeKind::mesh})
    for (const double grain_deg : {-90.0, -17.0, 45.0, 90.0}) {
      SCOPED_TRACE(testing::Message() << static_cast<int>(kind) << ", " << grain_deg);
      Drape drape = drapeOf(kind, 60, 40, 6);
      drape.file = LOOMLIGHT_SAMPLES "/folded_cloth.obj";
      const DrapeMesh straight = makeDrape(drape);
      drape.grain_deg = grain_deg;
      const DrapeMesh turned = makeDrape(drape);
      EXPECT_EQ(turned.positions, straight.positions);
      EXPECT_EQ(turned.normals, straight.normals);
      EXPECT_EQ(turned.triangles, straight.triangles);
      const double cosine = std::cos(grain_deg * kPi / 180), sine = std::sin(grain_deg * kPi / 180);
      for (const glm::uvec3& t : straight.triangles) {
        const Ways before = waysOf(straight, t), after = waysOf(turned, t);
        // Coordinates of some 100 mm in floats of 24 bits, over sides of some .1 mm.
        ASSERT_LT(glm::distance(after.warp, cosine * before.warp - sine * before.weft), 1e-3);
        ASSERT_LT(glm::distance(after.weft, sine * before.warp + cosine * before.weft), 1e-3);
      }
      glm::vec2 lower = turned.uv_mm.front();
      for (const glm::vec2 uv : turned.uv_mm) lower = glm::min(lower, uv);
      EXPECT_EQ(lower, glm::vec2(0));
    }
}

TEST(Drape, GrainLeavesWhatIsFlat) {
  Drape drape = drapeOf(DrapeKind::flat, 20, 10, 6);
  drape.grain_deg = 30;
  EXPECT_EQ(makeDrape(drape).uv_mm, makeDrape(drapeOf(DrapeKind::flat, 20, 10, 6)).uv_mm);
}

TEST(Drape, SphereKeepsLengthsThroughItsMiddle) {
  const DrapeMesh mesh = makeDrape(drapeOf(DrapeKind::sphere, 14, 14, 6));
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::vec2 u1 = mesh.uv_mm[t[1]] - mesh.uv_mm[t[0]], u2 = mesh.uv_mm[t[2]] - mesh.uv_mm[t[0]];
    ASSERT_GT(u1.x * u2.y - u1.y * u2.x, 0);
  }
  const glm::vec3 centre = mesh.positions[0] - 6.0f * mesh.normals[0];
  for (size_t i = 0; i < mesh.positions.size(); ++i) {
    EXPECT_NEAR(glm::distance(mesh.positions[i], centre), 6, 1e-4);
    // Exponential map: the angle from the top is the distance from the swatch's middle over the radius.
    const double angle = std::acos(std::clamp(mesh.normals[i].z, -1.0f, 1.0f));
    EXPECT_NEAR(angle * 6, glm::distance(mesh.uv_mm[i], glm::vec2(7, 7)), 5e-3);
  }
}

TEST(Drape, SphereIsCutToWhatFits) {
  const DrapeMesh mesh = makeDrape(drapeOf(DrapeKind::sphere, 100, 50, 6));
  ASSERT_EQ(mesh.repairs.size(), 1u);
  EXPECT_THAT(mesh.repairs[0], HasSubstr("does not fit on a sphere"));
  float lowest = 1;
  for (const glm::vec3& normal : mesh.normals) lowest = std::min(lowest, normal.z);
  EXPECT_NEAR(lowest, std::cos(0.8 * kPi), 1e-4);
}

/// Largest change of length of any side of any triangle, as a share.
double worstStretch(const DrapeMesh& mesh) {
  double worst = 0;
  for (const glm::uvec3& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) {
      const uint32_t a = t[k], b = t[(k + 1) % 3];
      const double flat = glm::distance(mesh.uv_mm[a], mesh.uv_mm[b]);
      worst = std::max(worst, std::abs(glm::distance(mesh.positions[a], mesh.positions[b]) / flat - 1));
    }
  return worst;
}

TEST(Drape, FoldsAndSkirtsAreIsometric) {
  for (const Drape& drape : {drapeOf(DrapeKind::folds, 40, 30, 2), drapeOf(DrapeKind::skirt, 20, 40, 12)}) {
    const DrapeMesh mesh = makeDrape(drape);
    expectSound(mesh);
    EXPECT_LT(worstStretch(mesh), 1e-3);  // chords of facets
  }
}

TEST(Drape, SkirtClosesAndIsACircleOfCloth) {
  const DrapeMesh mesh = makeDrape(drapeOf(DrapeKind::skirt, 20, 40, 12));
  double least = 1e9, most = 0;
  for (const glm::vec2& uv : mesh.uv_mm) {
    const double radius = glm::distance(uv, glm::vec2(52));
    least = std::min(least, radius);
    most = std::max(most, radius);
  }
  EXPECT_NEAR(least, 12, 1e-3);
  EXPECT_NEAR(most, 52, 1e-3);
  const size_t perRow = 1 + static_cast<size_t>(std::count_if(
                                mesh.uv_mm.begin() + 1, mesh.uv_mm.end(),
                                [&](glm::vec2 uv) { return uv.y == mesh.uv_mm[0].y && uv.x > mesh.uv_mm[0].x; })) /
                                2;
  for (size_t i = 0; i < perRow; ++i) EXPECT_EQ(mesh.positions[i], mesh.positions[mesh.positions.size() - perRow + i]);
}

TEST(Drape, CushionKeepsLengthsThroughItsMiddleAndIsAsHighAsAsked) {
  const DrapeMesh mesh = makeDrape(drapeOf(DrapeKind::cushion, 40, 30, 6));
  expectSound(mesh);
  EXPECT_NEAR(lengthAlong(mesh, 0, 15), 40, 0.02);
  EXPECT_NEAR(lengthAlong(mesh, 1, 20), 30, 0.02);
  float lowest = 0, highest = 0;
  for (const glm::vec3& p : mesh.positions) {
    lowest = std::min(lowest, p.z);
    highest = std::max(highest, p.z);
  }
  EXPECT_NEAR(highest - lowest, 6, 0.25);  // the seam lies a little above where the halves would meet
  EXPECT_THAT(makeDrape(drapeOf(DrapeKind::cushion, 40, 30, 60)).repairs, testing::Contains(HasSubstr("at most")));
}

TEST(Drape, StaysSmallWhateverIsAsked) {
  for (const DrapeKind kind : {DrapeKind::cylinder, DrapeKind::sphere})
    for (const double radius : {0.5, 10000.0})
      for (const double width : {1.0, 10000.0})
        for (const double height : {1.0, 10000.0}) {
          const DrapeMesh mesh = makeDrape(drapeOf(kind, width, height, radius));
          EXPECT_LE(mesh.triangles.size(), 410000u);
          EXPECT_GE(mesh.triangles.size(), 2u);
        }
}

TEST(Drape, RefusesSizesThatAreNone) {
  EXPECT_THROW(makeDrape(drapeOf(DrapeKind::flat, 0, 10, 6)), InputError);
  EXPECT_THROW(makeDrape(drapeOf(DrapeKind::cylinder, 10, 10, -1)), InputError);
  EXPECT_THROW(makeDrape(drapeOf(DrapeKind::sphere, 10, std::nan(""), 6)), InputError);
}

}  // namespace
}  // namespace loomlight
