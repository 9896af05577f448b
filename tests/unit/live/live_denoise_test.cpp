#include <gtest/gtest.h>

#include "app/live/live_renderer.h"
#include "tests/support/test_cloth.h"
#include "tests/unit/live/small_view.h"
#include "tests/unit/live/worker_window.h"

namespace loomlight {
namespace {

constexpr size_t kPixels = 64 * 48;
constexpr int kClear = 16;  // samples from which on pictures are shown as they are

class LiveDenoise : public testing::Test {
 protected:
  LiveDenoise() {
    fabric.render.resolution = 4;
    fabric.drape.width_mm = fabric.drape.height_mm = 6;
    fabric.light.kind = LightKind::dome;
    fabric.fibres[0].absorption_per_mm = Rgb(20, 4, 2);
  }
  void show(uint64_t generation) { renderer.request(test::smallView(fabric, generation)); }
  template <class Condition>
  bool waitForFrame(Condition&& condition) {
    return window.waitFor([&] {
      frame = renderer.frame();
      return frame && condition(*frame);
    });
  }
  Fabric fabric = test::whiteCotton();
  test::WorkerWindow window;
  LiveRenderer renderer{window.waker(), 1};
  std::shared_ptr<const Frame> frame;
};

TEST_F(LiveDenoise, IsACopyForTheDisplayWhereItIsWanted) {
  show(1);
  ASSERT_TRUE(waitForFrame([](const Frame& f) { return f.samples >= kClear; }));
  EXPECT_TRUE(frame->denoised.empty());
  EXPECT_EQ(frame->shown().data(), frame->plain().data());
  renderer.denoise(true);
  ASSERT_TRUE(waitForFrame([](const Frame& f) { return !f.denoised.empty(); }));
  EXPECT_EQ(frame->denoised.size(), kPixels);
  EXPECT_EQ(frame->shown().data(), frame->denoised.data());
  EXPECT_NE(frame->denoised, frame->rgba);
  renderer.denoise(false);
  EXPECT_TRUE(waitForFrame([](const Frame& f) { return f.denoised.empty(); }));
}

TEST_F(LiveDenoise, AnswersWhileNothingIsTraced) {
  show(1);
  ASSERT_TRUE(waitForFrame([](const Frame& f) { return f.samples >= 2; }));
  renderer.pause(true);
  renderer.denoise(true);
  EXPECT_TRUE(waitForFrame([](const Frame& f) { return !f.denoised.empty(); }));
  renderer.denoise(false);
  EXPECT_TRUE(waitForFrame([](const Frame& f) { return f.denoised.empty(); }));
}

TEST_F(LiveDenoise, GoesOnFromCoarsePicturesToRecolouredOnes) {
  renderer.denoise(true);
  show(1);
  ASSERT_TRUE(waitForFrame([](const Frame&) { return true; }));
  EXPECT_EQ(frame->denoised.size(), frame->rgba.size());
  ASSERT_TRUE(waitForFrame([](const Frame& f) { return f.samples >= 8; }));
  fabric.light.temperature_K = 2700;
  show(2);
  ASSERT_TRUE(waitForFrame([](const Frame& f) { return f.generation == 2; }));
  EXPECT_EQ(frame->denoised.size(), kPixels);
}

}  // namespace
}  // namespace loomlight
