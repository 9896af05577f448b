#include "render/transport/half_dome.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

#include "render/media/volume_medium.h"
#include "tests/support/batch_around.h"
#include "tests/support/sampled_mean.h"
#include "tests/support/test_cloth.h"
#include "tests/support/white_light.h"

namespace loomlight {
namespace {

/// No cloth at all: it only looks at where the rays of cameras go, and counts those that it does not like.
class Onlooker final : public Medium {
 public:
  explicit Onlooker(const Scene& scene) : volume_(scene.cloth), upper_mm_(scene.cloth->shell->upper_mm()) {}

  std::unique_ptr<MediumBatch> batch(size_t paths) const override { return std::make_unique<Batch>(*this, paths); }

  mutable std::atomic<int> wrong{0};

 private:
  class Batch final : public test::BatchAround {
   public:
    Batch(const Onlooker& medium, size_t paths) : BatchAround(medium.volume_.batch(paths)), onlooker_(medium) {}

   private:
    std::optional<Collision> fly(const PathRay& pathRay, TraceCounts&) override {
      const float half = onlooker_.upper_mm_.z;
      const glm::vec3 o = place(pathRay.path).world, d = pathRay.direction;
      const glm::vec2 in = glm::vec2(o) + (half - o.z) / d.z * glm::vec2(d);
      const glm::vec2 out = glm::vec2(o) + (-half - o.z) / d.z * glm::vec2(d);
      const glm::vec2 room = glm::vec2(onlooker_.upper_mm_) - 4 * half;
      const bool inside =
          std::abs(in.x) < room.x && std::abs(in.y) < room.y && std::abs(out.x) < room.x && std::abs(out.y) < room.y;
      onlooker_.wrong += !(o.z > half && d.z < 0 && inside);
      return std::nullopt;
    }

    const Onlooker& onlooker_;
  };

  VolumeMedium volume_;
  glm::vec3 upper_mm_;
};

TEST(HalfDome, CamerasStandOverThePatchAndSeeNoEdge) {
  for (const HalfDomeGrid grid : {HalfDomeGrid{8, 3}, HalfDomeGrid{6, 24}}) {
    const auto scene = test::sceneOf(halfDomePatch(test::whiteCotton(), grid));
    const Onlooker onlooker(*scene);
    const auto measure = measureHalfDome(*scene, onlooker, grid, 200, Task{});
    ASSERT_TRUE(measure);
    EXPECT_EQ(onlooker.wrong, 0);
    EXPECT_GE(measure->counts.paths, 200 * grid.size());
  }
}

// The light is looked for at every event, as that of any measurement is.
TEST(HalfDome, WhiteClothInAFurnaceReflectsAsPaperDoes) {
  const HalfDomeGrid grid{4, 3};
  Fabric closed = test::whiteCotton();
  closed.yarns[0].count_tex = 40;
  closed.ends_per_cm = closed.picks_per_cm = 40;  // through holes one would see the darkness behind
  Fabric fabric = halfDomePatch(closed, grid);
  fabric.light.kind = LightKind::furnace;
  const double paper = paperRadiance(fabric.light);
  const test::WhiteLight white;
  white.shineOn(fabric);
  const auto scene = test::sceneOf(fabric);
  ASSERT_TRUE(scene->lighting->wantsSampling());
  const auto measure = measureHalfDome(*scene, VolumeMedium(scene->cloth), grid, 4000, Task{});
  ASSERT_TRUE(measure);
  test::SampledMean factor;
  for (const Rgb& seen : measure->radiance) {
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(seen[c] / paper, 1, 0.02);
    factor.add(seen.g / paper);
  }
  EXPECT_LT(factor.standardError(), 0.002);
  EXPECT_TRUE(test::isWithinNoise(factor.mean(), 1, factor.standardError(), 1));
}

TEST(HalfDome, IsTheSameForAnyNumberOfThreads) {
  const HalfDomeGrid grid{4, 2};
  const auto scene = test::sceneOf(halfDomePatch(test::whiteCotton(), grid));
  const VolumeMedium medium(scene->cloth);
  Task one, three;
  one.threads = 1;
  three.threads = 3;
  const auto a = measureHalfDome(*scene, medium, grid, 50, one), b = measureHalfDome(*scene, medium, grid, 50, three);
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a->radiance, b->radiance);
}

TEST(HalfDome, PaperUnderParallelLightGoesWithTheCosine) {
  Light light;
  light.kind = LightKind::directional;
  light.elevation_deg = 30;
  EXPECT_NEAR(paperRadiance(light), 0.5, 1e-12);
  light.elevation_deg = -30;
  EXPECT_NEAR(paperRadiance(light), 0.5, 1e-12);
  light.kind = LightKind::dome;
  light.intensity = 3;
  EXPECT_DOUBLE_EQ(paperRadiance(light), 3);
}

}  // namespace
}  // namespace loomlight
