#include <gtest/gtest.h>

#include "app/live/tracer.h"
#include "render/transport/make_medium.h"
#include "tests/support/test_cloth.h"
#include "tests/unit/live/worker_window.h"

namespace loomlight {
namespace {

constexpr int kWidth = 64, kHeight = 48;

double brightness(const Frame& frame) {
  double sum = 0;
  for (const glm::vec4& pixel : frame.rgba) sum += pixel.g;
  return sum / static_cast<double>(frame.rgba.size());
}

/// Sketches are black here and the cloth is white, so that one is never taken for the other.
class PreviewSink : public testing::Test {
 protected:
  static Fabric white() {
    Fabric fabric = test::whiteCotton();
    fabric.render.resolution = 2;
    fabric.drape.width_mm = fabric.drape.height_mm = 6;
    fabric.camera.distance_mm = 6;
    fabric.light.kind = LightKind::dome;
    return fabric;
  }
  static Fabric black() {
    Fabric fabric = white();
    fabric.fibres[0].absorption_per_mm = Rgb(5000);
    return fabric;
  }
  static Traceable traceable(const Fabric& fabric) {
    const std::shared_ptr<const Scene> scene = test::sceneOf(fabric);
    return {scene, makeMedium(*scene, 1e9, Task{})};
  }
  void show(const Fabric& fabric, uint64_t generation, bool sketch) {
    tracer.show({traceable(fabric), kWidth, kHeight, generation, sketch});
  }
  bool waitFor(uint64_t generation, int samples) {
    return window.waitFor([&] {
      const auto frame = tracer.frame();
      return frame && frame->generation == generation && frame->samples >= samples;
    });
  }
  test::WorkerWindow window;
  Tracer tracer{window.waker(), 1};
};

TEST_F(PreviewSink, IsMarkedUntilNothingOfItIsLeft) {
  show(black(), 1, true);
  ASSERT_TRUE(waitFor(1, 0));
  const auto sketch = tracer.frame();
  EXPECT_EQ(sketch->quality, PreviewQuality::sketch);
  show(white(), 1, false);
  std::vector<std::shared_ptr<const Frame>> frames;
  ASSERT_TRUE(window.waitFor([&] {
    frames.push_back(tracer.frame());
    return frames.back()->quality != PreviewQuality::sketch;
  }));
  const double cloth = brightness(*frames.back());
  EXPECT_GT(cloth, 2 * brightness(*sketch));
  ASSERT_TRUE(waitFor(1, frames.back()->samples + 64));
  EXPECT_NEAR(brightness(*tracer.frame()), cloth, 0.05 * cloth);
}

TEST_F(PreviewSink, IsNeverRecoloured) {
  show(white(), 1, true);
  ASSERT_TRUE(waitFor(1, 0));
  show(black(), 2, false);
  ASSERT_TRUE(window.waitFor([&] { return tracer.frame()->generation == 2; }));
  EXPECT_NE(tracer.frame()->quality, PreviewQuality::recoloured);
  EXPECT_NE(tracer.frame()->quality, PreviewQuality::sketch);
}

TEST_F(PreviewSink, IsNotWhatAStrokeLeavesAsItWas) {
  show(black(), 1, true);
  ASSERT_TRUE(waitFor(1, 0));
  const double sketch = brightness(*tracer.frame());
  Fabric painted = white();
  painted.weave = painted.weave.with(0, 0, !painted.weave.at(0, 0));
  show(painted, 2, false);
  ASSERT_TRUE(window.waitFor([&] { return tracer.frame()->generation == 2; }));
  EXPECT_NE(tracer.frame()->quality, PreviewQuality::sketch);
  EXPECT_GT(brightness(*tracer.frame()), 2 * sketch);
}

}  // namespace
}  // namespace loomlight
