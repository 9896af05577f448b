#include "render/media/report_medium.h"

#include <gtest/gtest.h>

#include <cmath>

#include "render/bvdf/local_cell.h"
#include "render/media/volume_medium.h"
#include "tests/support/test_cloth.h"

namespace loomlight {
namespace {

/// A BVDF of one value: ratio 0 gives p = 0 everywhere; a large one p = 1 but at wi == wo.
std::shared_ptr<const BvdfSet> uniformBvdf(float ratio) {
  const BvdfResolution resolution{2, 2, 4, 4};
  auto set = std::make_shared<BvdfSet>();
  set->tables.emplace_back(resolution, HotSpot{5, 0.1f}, std::vector<float>(resolution.bins(), ratio));
  set->tableOfYarn = {0};
  return set;
}

ScenePoint aboveTheMiddle(const Scene& scene) {
  return {{0.03f, 0.01f, scene.cloth->shell->upper_mm().z + 1}, -1};
}

TEST(LocalCell, IsTwoLeavesWideHalfOpenAndCutByTheCrossing) {
  const auto scene = test::sceneOf(test::whiteCotton());
  const ClothVolume& volume = *scene->cloth->volume;
  const VoxelGrid& grid = volume.grid();
  for (int leaf = 0; leaf < 3 * grid.cell.x; ++leaf) {
    const glm::vec3 corner((static_cast<float>(leaf) + 0.5f) * grid.size_mm.x, 0.01f, 0);
    const LocalCell cell = LocalCell::around(corner, volume);
    const int inCrossing = leaf % grid.cell.x;
    EXPECT_NEAR(cell.lower.x, (leaf - inCrossing % 2) * grid.size_mm.x, 1e-5);
    const int width = inCrossing - inCrossing % 2 + 1 < grid.cell.x ? 2 : 1;
    EXPECT_NEAR(cell.upper.x - cell.lower.x, width * grid.size_mm.x, 1e-5);
  }
  // The same cells as the octree's: voxels of its first level above the leaves.
  const auto coarse = volume.atLevel(1, Task{});
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const glm::vec3 size = volume.upper_mm() - volume.lower_mm();
    const float u = random.uniform(), v = random.uniform(), w = random.uniform();
    const glm::vec3 point = volume.lower_mm() + glm::vec3(u, v, w) * size;
    const LocalCell cell = LocalCell::around(point, volume);
    VoxelContent here, there;
    coarse->contentAt(point, here);
    coarse->contentAt(glm::vec3(cell.lower * 0.999 + cell.upper * 0.001), there);
    EXPECT_EQ(here.voxel, there.voxel);
    coarse->contentAt(glm::vec3(cell.lower * 0.001 + cell.upper * 0.999), there);
    EXPECT_EQ(here.voxel, there.voxel);
  }
}

TEST(LocalCell, RaysLeaveItByTheFaceAhead) {
  const LocalCell cell{{0, 0, 0}, {1, 2, 3}};
  EXPECT_FLOAT_EQ(cell.exit({0.25f, 1, 1}, {1, 0, 0}), 0.75f);
  EXPECT_FLOAT_EQ(cell.exit({0.25f, 1, 1}, {-1, 0, 0}), 0.25f);
  EXPECT_FLOAT_EQ(cell.exit({0.25f, 1, 1}, {0.6f, 0, 0.8f}), 1.25f);
  EXPECT_FLOAT_EQ(cell.exit({1.5f, 1, 1}, {1, 0, 0}), 0.0f);
}

// p = 1 stops all direct light of the first event, but none that comes from the eye; later events do not feel it.
TEST(ReportMedium, ShadowsDirectLightOfTheFirstEventAlone) {
  const auto scene = test::sceneOf(test::whiteCotton());
  const ReportMedium dark(scene->cloth, uniformBvdf(1e6f)), open(scene->cloth, uniformBvdf(0));
  const VolumeMedium plain(scene->cloth);
  constexpr auto kFar = std::numeric_limits<float>::infinity();
  TraceCounts counts;
  Random random(3);
  const glm::vec3 wi = glm::normalize(glm::vec3(0.5f, 0.2f, 1)), up(0, 0, 1);
  double beyond = 0, whole = 0, fromEye = 0, openToEye = 0;
  int later = 0;
  for (int i = 0; i < 2000; ++i) {
    ReportMedium::Memory memory;
    const auto hit = dark.collide(aboveTheMiddle(*scene), memory, -up, random, counts);
    ASSERT_TRUE(hit);
    EXPECT_EQ(memory.events, 1);
    const ScenePoint& place = hit->place;
    EXPECT_EQ(dark.transmittance(place, memory, wi, kFar, random, counts), 0.0f);
    if (plain.transmittance(place, {}, up, kFar, random, counts) > 0.02f) {  // exact above that
      fromEye += dark.transmittance(place, memory, up, kFar, random, counts) / 2000;
      openToEye += open.transmittance(place, memory, up, kFar, random, counts) / 2000;
    }
    const float through = open.transmittance(place, memory, wi, kFar, random, counts);
    beyond += through / 2000;
    const float volume = plain.transmittance(place, {}, wi, kFar, random, counts);
    whole += volume / 2000;
    if (volume > 0.02f) {
      EXPECT_GE(through, volume * 0.999f);  // without the way through the cell
    }

    const auto second = dark.collide(place, memory, -up, random, counts);
    if (!second) continue;
    EXPECT_EQ(memory.events, 2);
    const float nothingNear = plain.transmittance(second->place, {}, wi, kFar, random, counts);
    if (nothingNear <= 0.02f) continue;
    EXPECT_NEAR(dark.transmittance(second->place, memory, wi, kFar, random, counts), nothingNear, 1e-5);
    ++later;
  }
  EXPECT_GT(beyond, whole + 0.05);
  EXPECT_NEAR(fromEye, openToEye, 1e-6);  // what is left is shadow from beyond the cell
  EXPECT_GT(fromEye, 0.5);
  EXPECT_GT(later, 100);
}

// On a drape the same cloth has the same cells and the same frames.
TEST(ReportMedium, WorksOnDrapes) {
  Fabric fabric = test::whiteCotton();
  fabric.drape.kind = DrapeKind::cylinder;
  const auto scene = test::sceneOf(fabric);
  const ReportMedium open(scene->cloth, uniformBvdf(0)), dark(scene->cloth, uniformBvdf(1e6f));
  const VolumeMedium plain(scene->cloth);
  const CameraRays camera(fabric.camera, 32, 32);
  constexpr auto kFar = std::numeric_limits<float>::infinity();
  TraceCounts counts;
  Random random(4);
  double beyond = 0, whole = 0;
  int hits = 0;
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x) {
      const Ray ray = camera.ray(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
      ReportMedium::Memory memory;
      const auto hit = open.collide({ray.origin, -1}, memory, ray.direction, random, counts);
      if (!hit) continue;
      ++hits;
      const glm::vec3 wi = glm::normalize(hit->normal - 0.3f * ray.direction);
      beyond += open.transmittance(hit->place, memory, wi, kFar, random, counts);
      whole += plain.transmittance(hit->place, {}, wi, kFar, random, counts);
      const glm::vec3 side =
          glm::normalize(hit->normal + 0.7f * glm::normalize(glm::cross(hit->normal, ray.direction)));
      EXPECT_EQ(dark.transmittance(hit->place, memory, side, kFar, random, counts), 0.0f);
    }
  EXPECT_GT(hits, 100);
  EXPECT_GT(beyond, 1.1 * whole);
}

}  // namespace
}  // namespace loomlight
