#include "tests/bench/cloth_drop.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "core/shell/drape_surface.h"
#include "core/shell/shell.h"

namespace loomlight {
namespace {

/// Length of the grid's edges against those in the cloth, the threads' own directions only.
void expectUnstretched(const DrapeMesh& mesh, double mean, double most) {
  double sum = 0;
  int count = 0;
  for (const glm::uvec3& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) {
      const uint32_t a = t[k], b = t[(k + 1) % 3];
      const glm::vec2 thread = glm::abs(mesh.uv_mm[a] - mesh.uv_mm[b]);
      if (std::min(thread.x, thread.y) > 1e-4f) continue;
      const double stretch = glm::distance(mesh.positions[a], mesh.positions[b]) / glm::length(thread) - 1;
      EXPECT_LT(std::abs(stretch), most);
      sum += std::abs(stretch);
      ++count;
    }
  EXPECT_LT(sum / count, mean);
}

/// Parts that are far apart in the cloth stay apart in the world.
void expectNoContact(const DrapeMesh& mesh, float farInCloth, float gap) {
  for (size_t i = 0; i < mesh.positions.size(); ++i) {
    for (size_t j = 0; j < i; ++j) {
      if (glm::distance(mesh.uv_mm[i], mesh.uv_mm[j]) < farInCloth) continue;
      ASSERT_GT(glm::distance(mesh.positions[i], mesh.positions[j]), gap);
    }
  }
}

TEST(ClothDrop, HangsOverTheBallUnstretched) {
  ClothDrop drop;
  drop.cells = 40;
  drop.seconds = 0.5;
  const DrapeMesh mesh = dropCloth(drop);
  EXPECT_EQ(mesh.positions.size(), 41u * 41u);
  EXPECT_EQ(mesh.triangles.size(), 2u * 40u * 40u);
  expectUnstretched(mesh, 0.03, 0.25);
  float lower = 0, upper = 0;
  for (const glm::vec3& p : mesh.positions) {
    lower = std::min(lower, p.z);
    upper = std::max(upper, p.z);
  }
  EXPECT_GT(upper - lower, 15) << "it hangs down";
  for (const glm::vec3& p : mesh.positions) EXPECT_GT(glm::length(p), drop.ballRadius_mm) << "outside of the ball";
}

TEST(ClothDrop, IsAFunctionOfItsNumbers) {
  ClothDrop drop;
  drop.cells = 20;
  drop.seconds = 0.1;
  EXPECT_EQ(toObj(dropCloth(drop)), toObj(dropCloth(drop)));
}

TEST(FoldedCloth, SampleIsClothWithRoomForItsThickness) {
  const DrapeMesh mesh = loadDrapeMesh(LOOMLIGHT_SAMPLES "/folded_cloth.obj", 1.0);
  EXPECT_THAT(mesh.repairs, testing::IsEmpty());
  EXPECT_EQ(mesh.positions.size(), 101u * 101u);
  expectUnstretched(mesh, 0.02, 0.15);
  expectNoContact(mesh, 6, 1.0f);
  const Shell shell(DrapeSurface(mesh), 0.4);
  EXPECT_THAT(shell.repairs(), testing::IsEmpty());
  EXPECT_EQ(shell.uvUpper_mm() - shell.uvLower_mm(), glm::vec2(60, 60));
}

}  // namespace
}  // namespace loomlight
