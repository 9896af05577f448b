#include <gtest/gtest.h>

#include <array>

#include "app/live/live_renderer.h"
#include "core/fabric/model/booth_lamps.h"
#include "render/display/booth.h"
#include "tests/support/narrow_dye.h"
#include "tests/support/test_cloth.h"
#include "tests/unit/live/small_view.h"
#include "tests/unit/live/worker_window.h"

namespace loomlight {
namespace {

Fabric dyedCloth() {
  Fabric fabric = test::whiteCotton();
  fabric.render.resolution = 2;
  fabric.drape.width_mm = fabric.drape.height_mm = 6;
  fabric.camera.distance_mm = 9;
  fabric.light.kind = LightKind::dome;
  fabric.fibres[0].absorption_per_mm = Absorption(test::narrowDye(60));
  return fabric;
}

class LiveBooth : public testing::Test {
 protected:
  using Light4 = std::array<Rgb, kBoothLamps.size()>;

  void show(const Fabric& fabric) { renderer.request(test::smallView(fabric, ++generation)); }
  template <class Condition>
  bool waitFor(const Condition& condition) {
    return window.waitFor([&] {
      const auto frame = renderer.frame();
      return frame && frame->generation == generation && condition(*frame);
    });
  }
  /// Of each quarter, the mean.
  static Light4 lightOf(const Frame& frame) {
    Light4 sums{};
    std::array<float, kBoothLamps.size()> counts{};
    size_t i = 0;
    for (int y = 0; y < frame.height; ++y)
      for (int x = 0; x < frame.width; ++x, ++i) {
        const size_t lamp = boothPixel(x, y, frame.width, frame.height).lamp;
        sums[lamp] += Rgb(frame.shown()[i]);
        ++counts[lamp];
      }
    for (size_t lamp = 0; lamp < sums.size(); ++lamp) sums[lamp] /= counts[lamp];
    return sums;
  }
  /// Of the piece that quarters show, the mean where the cloth is traced under that lamp.
  Rgb tracedUnder(StandardIlluminant lamp) {
    Fabric fabric = dyedCloth();
    fabric.light = underLamp(fabric.light, lamp);
    LiveRenderer alone(window.waker(), 1);
    alone.request(test::smallView(fabric, 1));
    EXPECT_TRUE(window.waitFor([&] { return alone.frame() && alone.frame()->samples >= 32; }));
    const auto frame = alone.frame();
    const PixelRect piece = boothPiece(frame->width, frame->height);
    Rgb sum(0);
    for (int y = piece.y; y < piece.y + piece.height; ++y)
      for (int x = piece.x; x < piece.x + piece.width; ++x)
        sum += Rgb(frame->rgba[static_cast<size_t>(y) * static_cast<size_t>(frame->width) + static_cast<size_t>(x)]);
    return sum / static_cast<float>(piece.width * piece.height);
  }

  test::WorkerWindow window;
  LiveRenderer renderer{window.waker(), 1};
  uint64_t generation = 0;
};

// Each quarter is nearer to what is traced under its lamp than half of the way to any other lamp's.
TEST_F(LiveBooth, EachQuarterIsThePictureUnderItsLamp) {
  Light4 traced;
  for (size_t i = 0; i < traced.size(); ++i) traced[i] = tracedUnder(kBoothLamps[i]);
  renderer.booth(true);
  show(dyedCloth());
  ASSERT_TRUE(waitFor([](const Frame& frame) { return frame.isDivided() && frame.samples >= 32; }));
  const Light4 quarters = lightOf(*renderer.frame());
  for (size_t i = 0; i < quarters.size(); ++i)
    for (size_t k = 0; k < traced.size(); ++k) {
      if (k == i) continue;
      EXPECT_LT(2 * glm::length(quarters[i] - traced[i]), glm::length(traced[k] - traced[i])) << i << k;
    }
}

// The lamp of the cloth is no matter: a booth has its own.
TEST_F(LiveBooth, IsTheSameUnderWhateverLampTheClothIsTraced) {
  renderer.booth(true);
  show(dyedCloth());
  ASSERT_TRUE(waitFor([](const Frame& frame) { return frame.isDivided() && frame.samples >= 16; }));
  const Light4 before = lightOf(*renderer.frame());
  Fabric inShop = dyedCloth();
  inShop.light = underLamp(inShop.light, StandardIlluminant::f11);
  show(inShop);
  ASSERT_TRUE(waitFor([](const Frame& frame) { return frame.isDivided(); }));
  const Light4 after = lightOf(*renderer.frame());
  for (size_t i = 0; i < before.size(); ++i)
    for (size_t k = 0; k < before.size(); ++k) {
      if (k == i) continue;
      EXPECT_LT(2 * glm::length(after[i] - before[i]), glm::length(before[k] - before[i])) << i << k;
    }
}

// From the one tracing that goes on: no sample is traced again, and what was traced stays as it is beside it.
TEST_F(LiveBooth, IsShownAtOnceAndTakenAwayAgain) {
  show(dyedCloth());
  ASSERT_TRUE(waitFor([](const Frame& frame) { return frame.samples >= 16; }));
  const int before = renderer.frame()->samples;
  renderer.booth(true);
  ASSERT_TRUE(waitFor([](const Frame& frame) { return frame.isDivided(); }));
  EXPECT_GE(renderer.frame()->samples, before);
  EXPECT_EQ(renderer.frame()->shown().size(), renderer.frame()->rgba.size());
  renderer.booth(false);
  ASSERT_TRUE(waitFor([](const Frame& frame) { return !frame.isDivided(); }));
  EXPECT_GE(renderer.frame()->samples, before);
}

// While the camera moves: the first coarse pass is divided already, by the paths of its own.
TEST_F(LiveBooth, TheFirstPassIsDivided) {
  renderer.booth(true);
  Fabric fabric = dyedCloth();
  for (int i = 0; i < 3; ++i) {
    fabric.camera.azimuth_deg += 20;
    show(fabric);
    ASSERT_TRUE(waitFor([](const Frame&) { return true; }));
    const auto first = renderer.frame();
    ASSERT_TRUE(first->isDivided());
    const Light4 quarters = lightOf(*first);
    for (size_t k = 1; k < quarters.size(); ++k) EXPECT_GT(glm::length(quarters[k] - quarters[0]), 0.005f) << k;
  }
}

}  // namespace
}  // namespace loomlight
