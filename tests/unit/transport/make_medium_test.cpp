#include "render/transport/make_medium.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "render/media/close_up_medium.h"
#include "render/media/fibre_medium.h"
#include "render/media/volume_medium.h"
#include "tests/support/every_medium.h"

namespace loomlight {
namespace {

Fabric smallCotton() {
  Fabric fabric = test::whiteCotton();
  fabric.drape.width_mm = fabric.drape.height_mm = 2;
  fabric.render.resolution = 2;
  return fabric;
}

std::unique_ptr<const Medium> made(const Scene& scene, MediumCost* cost = nullptr) {
  return makeMedium(scene, defaultMemoryLimit_bytes(), Task{}, cost);
}

TEST(MakeMedium, FollowsTheSettings) {
  Fabric fabric = smallCotton();
  MediumCost cost;
  const auto ours = test::sceneOf(fabric);
  EXPECT_NE(dynamic_cast<const CloseUpMedium*>(made(*ours).get()), nullptr);
  fabric.render.estimator = Estimator::none;
  const auto plain = test::sceneOf(fabric);
  EXPECT_NE(dynamic_cast<const VolumeMedium*>(made(*plain, &cost).get()), nullptr);
  EXPECT_EQ(cost.geometryBytes + cost.acceleratorBytes + cost.bvdfBytes, 0u);
  fabric.render.method = Method::fibres;
  const auto truth = test::sceneOf(fabric);
  EXPECT_NE(dynamic_cast<const FibreMedium*>(made(*truth, &cost).get()), nullptr);
  EXPECT_GT(cost.segments, 0u);
  EXPECT_GT(cost.geometryBytes, cost.segments * sizeof(glm::vec4));
  EXPECT_GT(cost.acceleratorBytes, 0u);
  EXPECT_THROW(makeMedium(*truth, 1e3, Task{}), InputError);
}

// Making fibres takes seconds, so looking from elsewhere or recolouring must not; but no medium may serve a cloth that
// it was not made of.
TEST(TraceData, IsSharedWhereLightCameraOrColourChangeOnly) {
  Fabric fabric = smallCotton();
  fabric.render.method = Method::fibres;
  const auto before = test::sceneOf(fabric);
  const auto keeps = [&](auto&& edit) {
    Fabric edited = fabric;
    edit(edited);
    return makeScene(std::make_shared<const Fabric>(edited), Task{}, before.get())->cloth == before->cloth;
  };
  EXPECT_TRUE(keeps([](Fabric& f) { f.camera.azimuth_deg += 10; }));
  EXPECT_TRUE(keeps([](Fabric& f) { f.light.kind = LightKind::dome; }));
  EXPECT_TRUE(keeps([](Fabric& f) { f.fibres[0].absorption_per_mm = Rgb(3.0f); }));
  EXPECT_FALSE(keeps([](Fabric& f) { f.fibres[0].refractiveIndex = 1.4; }));
  EXPECT_FALSE(keeps([](Fabric& f) { f.yarns[0].packing = 0.4; }));
  EXPECT_FALSE(keeps([](Fabric& f) { f.drape.width_mm = 3; }));
  EXPECT_FALSE(keeps([](Fabric& f) { f.drape.kind = DrapeKind::sphere; }));
  EXPECT_FALSE(keeps([](Fabric& f) { f.render.method = Method::volume; }));
  EXPECT_FALSE(keeps([](Fabric& f) { f.render.estimator = Estimator::none; }));
}

// A medium holds what it traces light through, so it may outlive the scene that it was made for.
TEST(TraceData, OutlivesItsSceneInTheMedium) {
  for (const test::MediumKind& kind : {test::kPlain, test::kReport, test::kLoomlight, test::kFibres}) {
    Fabric fabric = smallCotton();
    kind.askFor(fabric);
    auto scene = test::sceneOf(fabric);
    const std::weak_ptr<const Scene> watched = scene;
    const auto medium = kind.make(*scene);
    scene.reset();
    EXPECT_TRUE(watched.expired()) << kind;
    Random random(1);
    TraceCounts counts;
    const glm::vec3 down(0, 0, -1);
    MediumPath path = medium->path();
    for (int i = 0; i < 100; ++i) {
      path.begin({-5.0f * down, -1});
      (void)path.collide(down, random, counts);
    }
    EXPECT_GT(counts.events, 0u) << kind;
  }
}

}  // namespace
}  // namespace loomlight
