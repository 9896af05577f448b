#include "app/bench/studies/convergence_study.h"

#include <gtest/gtest.h>

#include "render/transport/make_medium.h"
#include "tests/support/test_cloth.h"

namespace loomlight {
namespace {

class ConvergenceTest : public testing::Test {
 protected:
  double errorOf(const std::string& name, LightKind light) {
    Fabric fabric = test::whiteCotton();
    fabric.render.resolution = 2;
    fabric.drape.width_mm = fabric.drape.height_mm = 6;
    fabric.camera.distance_mm = 9;
    fabric.fibres[0].absorption_per_mm = Rgb(4, 2, 1);
    fabric.light.kind = light;
    fabric.render.width = 24;
    fabric.render.height = 16;
    const auto scene = test::sceneOf(fabric);
    const auto medium = makeMedium(*scene, 1e9, Task{});
    const Task task;
    const ConvergenceStudy study(*scene, *medium, 256, 2, task);
    for (const SamplingVariant& variant : samplingVariants())
      if (variant.name == name) return study.measure(variant, 64).back().error;
    throw std::logic_error("no variant " + name);
  }
};

TEST_F(ConvergenceTest, StratifiedPathsAreNearerWithTheSameSamples) {
  EXPECT_LT(errorOf("all on", LightKind::dome), 0.9 * errorOf("not stratified", LightKind::dome));
}

TEST_F(ConvergenceTest, LampsAreWorthLookingFor) {
  EXPECT_LT(errorOf("all on", LightKind::sky), errorOf("lamps not looked for", LightKind::sky));
}

}  // namespace
}  // namespace loomlight
