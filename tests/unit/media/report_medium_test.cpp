#include "render/media/report_medium.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

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

constexpr float kFar = std::numeric_limits<float>::infinity();

/// Several media that paths fly through alike: with the same numbers they meet the same fibres.
struct PathsAlike {
  const Scene& scene;
  const ReportMedium dark{scene.cloth, uniformBvdf(1e6f)}, open{scene.cloth, uniformBvdf(0)};
  const VolumeMedium plain{scene.cloth};
  MediumPath ofDark = dark.path(), ofOpen = open.path(), ofPlain = plain.path();
  TraceCounts counts{};

  void begin(const ScenePoint& from) {
    ofDark.begin(from);
    ofOpen.begin(from);
  }
  /// The next fibre on both ways, from where light goes on; the plain path begins there.
  std::optional<Collision> collide(glm::vec3 direction, Random& random) {
    Random same = random;
    const auto met = ofDark.collide(direction, random, counts), alike = ofOpen.collide(direction, same, counts);
    EXPECT_EQ(met.has_value(), alike.has_value());
    if (!met || !alike) return std::nullopt;
    EXPECT_EQ(met->place.world, alike->place.world);
    ofDark.leave(*met, -direction, 0);
    ofOpen.leave(*alike, -direction, 0);
    ofPlain.begin(met->place);
    return met;
  }
};

// p = 1 stops all direct light of the first event, but none that comes from the eye; later events do not feel it.
TEST(ReportMedium, ShadowsDirectLightOfTheFirstEventAlone) {
  const auto scene = test::sceneOf(test::whiteCotton());
  PathsAlike paths{*scene};
  TraceCounts counts;
  Random random(3);
  const glm::vec3 wi = glm::normalize(glm::vec3(0.5f, 0.2f, 1)), up(0, 0, 1);
  const auto seen = [&](MediumPath& path, glm::vec3 to) { return path.transmittance(to, kFar, random, counts); };
  double beyond = 0, whole = 0, fromEye = 0, openToEye = 0;
  int later = 0;
  for (int i = 0; i < 2000; ++i) {
    paths.begin(aboveTheMiddle(*scene));
    ASSERT_TRUE(paths.collide(-up, random));
    EXPECT_EQ(seen(paths.ofDark, wi), 0.0f);
    if (seen(paths.ofPlain, up) > 0.02f) {  // exact above that
      fromEye += seen(paths.ofDark, up) / 2000;
      openToEye += seen(paths.ofOpen, up) / 2000;
    }
    const float through = seen(paths.ofOpen, wi), volume = seen(paths.ofPlain, wi);
    beyond += through / 2000;
    whole += volume / 2000;
    if (volume > 0.02f) {
      EXPECT_GE(through, volume * 0.999f);  // without the way through the cell
    }

    if (!paths.collide(-up, random)) continue;
    const float nothingNear = seen(paths.ofPlain, wi);
    if (nothingNear <= 0.02f) continue;
    EXPECT_NEAR(seen(paths.ofDark, wi), nothingNear, 1e-5);
    ++later;
  }
  EXPECT_GT(beyond, whole + 0.05);
  EXPECT_NEAR(fromEye, openToEye, 1e-6);  // what is left is shadow from beyond the cell
  EXPECT_GT(fromEye, 0.5);
  EXPECT_GT(later, 100);
}

// A path that goes on as a copy of another has met what that has, and one that begins anew has met nothing.
TEST(ReportMedium, CopiesRememberWhatTheirPathHasMet) {
  const auto scene = test::sceneOf(test::whiteCotton());
  const ReportMedium dark(scene->cloth, uniformBvdf(1e6f));
  const auto batch = dark.batch(2);
  TraceCounts counts;
  Random random(3);
  const glm::vec3 down(0, 0, -1), wi = glm::normalize(glm::vec3(0.5f, 0.2f, 1));
  const PathRay pathRay{0, down, &random};
  std::optional<Collision> met;
  batch->begin(0, aboveTheMiddle(*scene), {});
  batch->collide({&pathRay, 1}, {&met, 1}, counts);
  ASSERT_TRUE(met);
  batch->leave(0, *met, wi, 0);
  batch->copy(0, 1);
  batch->begin(0, aboveTheMiddle(*scene), {});
  std::array<ShadowRay, 2> rays{ShadowRay{0, wi, kFar, &random}, ShadowRay{1, wi, kFar, &random}};
  batch->transmit(rays, counts);
  EXPECT_EQ(rays[0].visible, 1.0f) << "from above the cloth";
  EXPECT_EQ(rays[1].visible, 0.0f);
}

// On a drape the same cloth has the same cells and the same frames.
TEST(ReportMedium, WorksOnDrapes) {
  Fabric fabric = test::whiteCotton();
  fabric.drape.kind = DrapeKind::cylinder;
  const auto scene = test::sceneOf(fabric);
  PathsAlike paths{*scene};
  const CameraRays camera(fabric.camera, 32, 32);
  TraceCounts counts;
  Random random(4);
  double beyond = 0, whole = 0;
  int hits = 0;
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x) {
      const Ray ray = camera.ray(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
      paths.begin({ray.origin, -1});
      const auto hit = paths.collide(ray.direction, random);
      if (!hit) continue;
      ++hits;
      const glm::vec3 wi = glm::normalize(hit->normal - 0.3f * ray.direction);
      beyond += paths.ofOpen.transmittance(wi, kFar, random, counts);
      whole += paths.ofPlain.transmittance(wi, kFar, random, counts);
      const glm::vec3 side =
          glm::normalize(hit->normal + 0.7f * glm::normalize(glm::cross(hit->normal, ray.direction)));
      EXPECT_EQ(paths.ofDark.transmittance(side, kFar, random, counts), 0.0f);
    }
  EXPECT_GT(hits, 100);
  EXPECT_GT(beyond, 1.1 * whole);
}

}  // namespace
}  // namespace loomlight
