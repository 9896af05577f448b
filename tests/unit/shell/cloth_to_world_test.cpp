#include "core/shell/cloth_to_world.h"

#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/shell/drape_surface.h"

namespace loomlight {
namespace {

constexpr double kHalfThickness_mm = 0.1;

TEST(ClothToWorld, IsTheInverseOfTheWayToCloth) {
  Drape drape;
  drape.kind = DrapeKind::folds;
  const Shell shell(DrapeSurface(makeDrape(drape)), kHalfThickness_mm);
  const ClothToWorld toWorld(shell);
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const auto tet = static_cast<int>(random.below(static_cast<uint32_t>(shell.tets().size())));
    glm::vec3 point(0);
    for (const uint32_t vertex : shell.tets()[tet].vertex) point += 0.25f * shell.vertices()[vertex];
    const auto found = toWorld(shell.toCloth(tet, point));
    ASSERT_TRUE(found);
    EXPECT_LT(glm::distance(found->world, point), 1e-3f);
  }
}

/// As where somebody has given every face of a mesh the whole texture. Each face would touch the cells of all others.
TEST(ClothToWorld, FacesMayAllLieOnEachOther) {
  constexpr uint32_t kFaces = 70'000;  // of which each with each would be more than 32 bits can count
  DrapeMesh mesh;
  for (uint32_t i = 0; i < kFaces; ++i) {
    const glm::vec3 at(3.0f * static_cast<float>(i % 300), 3.0f * static_cast<float>(i / 300), 0);
    for (const glm::vec2 corner : {glm::vec2(0, 0), glm::vec2(2, 0), glm::vec2(0, 2)}) {
      mesh.positions.push_back(at + glm::vec3(corner, 0));
      mesh.normals.emplace_back(0, 0, 1);
      mesh.uv_mm.push_back(corner);
    }
    mesh.triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
  }
  const Shell shell(DrapeSurface(mesh), kHalfThickness_mm);
  const ClothToWorld toWorld(shell);
  const glm::vec3 cloth(0.5f, 0.5f, 0);
  const auto found = toWorld(cloth);
  ASSERT_TRUE(found);
  EXPECT_LT(glm::distance(shell.toCloth(found->tet, found->world), cloth), 1e-4f);
  EXPECT_FALSE(toWorld(glm::vec3(1.5f, 1.5f, 0))) << "it is beyond the edge of all of them";
}

}  // namespace
}  // namespace loomlight
