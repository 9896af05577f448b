#include <gtest/gtest.h>

#include "app/live/live_renderer.h"
#include "tests/support/test_cloth.h"
#include "tests/unit/live/small_view.h"
#include "tests/unit/live/worker_window.h"

namespace loomlight {
namespace {

using Window = test::WorkerWindow;

Fabric redCotton() {
  Fabric fabric = test::whiteCotton();
  fabric.render.resolution = 4;
  fabric.drape.width_mm = fabric.drape.height_mm = 6;
  fabric.camera.distance_mm = 9;
  fabric.light.kind = LightKind::dome;
  fabric.fibres[0].absorption_per_mm = Rgb(20, 4, 2);
  return fabric;
}

class LiveRecolour : public testing::Test {
 protected:
  void show(const Fabric& fabric, uint64_t generation) { renderer.request(test::smallView(fabric, generation)); }
  bool waitFor(uint64_t generation, int samples) {
    return window.waitFor([&] {
      const auto frame = renderer.frame();
      return frame && frame->generation == generation && frame->samples >= samples;
    });
  }
  Window window;
  LiveRenderer renderer{window.waker(), 1};
};

TEST_F(LiveRecolour, AColourIsShownOnTheFinishedPictureAndTracedAnewBehind) {
  Fabric fabric = redCotton();
  show(fabric, 1);
  ASSERT_TRUE(waitFor(1, 16));
  for (uint64_t generation = 2; generation < 10; ++generation) {
    fabric.fibres[0].absorption_per_mm.primaries *= 0.9f;
    show(fabric, generation);
    ASSERT_TRUE(window.waitFor([&] { return renderer.frame()->generation == generation; }));
    EXPECT_EQ(renderer.frame()->divider, 1) << "never coarse again";
    EXPECT_GE(renderer.frame()->samples, 4);
  }
  EXPECT_TRUE(window.waitFor([&] { return renderer.frame()->quality != PreviewQuality::recoloured; }));
  EXPECT_GE(renderer.frame()->samples, 4);
}

TEST_F(LiveRecolour, BackInItsOwnColoursThePictureGoesOn) {
  const Fabric fabric = redCotton();
  show(fabric, 1);
  ASSERT_TRUE(waitFor(1, 16));
  Fabric darker = fabric;
  darker.fibres[0].absorption_per_mm = Rgb(200, 150, 20);
  darker.light.intensity = 2;
  show(darker, 2);
  ASSERT_TRUE(window.waitFor([&] { return renderer.frame()->generation == 2; }));
  show(fabric, 3);
  ASSERT_TRUE(window.waitFor([&] { return renderer.frame()->generation == 3; }));
  // Of the picture in these colours or, where the one in darker colours has become as clear by then, of that.
  EXPECT_GE(renderer.frame()->samples, 4);
  Fabric renamed = fabric;
  renamed.name = "another name";
  const int samples = renderer.frame()->samples;
  show(renamed, 4);
  ASSERT_TRUE(window.waitFor([&] { return renderer.frame()->generation == 4; }));
  EXPECT_GE(renderer.frame()->samples, samples) << "a name is no reason to begin anew";
}

TEST_F(LiveRecolour, BackInItsOwnColoursThePictureRestsWhereItIsWantedByNow) {
  const Fabric fabric = redCotton();
  renderer.restAt(16);
  show(fabric, 1);
  ASSERT_TRUE(waitFor(1, 16));
  Fabric darker = fabric;
  darker.fibres[0].absorption_per_mm = Rgb(200, 150, 20);
  show(darker, 2);
  ASSERT_TRUE(window.waitFor([&] { return renderer.frame()->generation == 2; }));
  renderer.restAt(64);
  show(fabric, 3);
  EXPECT_TRUE(waitFor(3, 64));
}

TEST_F(LiveRecolour, WhatIsNoColourIsTracedAnew) {
  Fabric fabric = redCotton();
  show(fabric, 1);
  ASSERT_TRUE(waitFor(1, 16));
  fabric.fibres[0].refractiveIndex += 0.1;
  show(fabric, 2);
  ASSERT_TRUE(window.waitFor([&] { return renderer.frame()->generation == 2; }));
  EXPECT_NE(renderer.frame()->quality, PreviewQuality::recoloured);
}

}  // namespace
}  // namespace loomlight
