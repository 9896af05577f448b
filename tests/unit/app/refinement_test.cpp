#include "app/workers/refinement.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "render/trace/make_medium.h"
#include "render/trace/path_tracer.h"
#include "tests/support/test_cloth.h"

namespace loomlight {
namespace {

constexpr int kWidth = 60, kHeight = 44;

class RefinementTest : public testing::Test {
 protected:
  static Traceable makeCloth() {
    Fabric fabric = test::whiteCotton();
    fabric.render.resolution = 2;
    fabric.drape.width_mm = fabric.drape.height_mm = 6;
    fabric.camera.distance_mm = 8;
    Traceable made;
    made.scene = made.mediumScene = test::sceneOf(fabric);
    made.medium = makeMedium(*made.scene, 1e9, Task{});
    return made;
  }
  static void refine(Refinement& refinement, uint32_t samples) {
    while (refinement.samples() < samples) ASSERT_TRUE(refinement.advance(Task{{}, {}, 1}));
  }
  const Traceable cloth = makeCloth();
};

TEST_F(RefinementTest, TheWholeHasTheSamplesOfTheRenderer) {
  Refinement refinement(cloth, kWidth, kHeight, 0);
  EXPECT_FALSE(refinement.begun());
  refine(refinement, 1);
  Film film(kWidth, kHeight);
  renderUpTo(refinement.samples(), *cloth.scene, *cloth.medium,
             CameraRays(cloth.scene->fabric->camera, kWidth, kHeight), film, Task{});
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) EXPECT_EQ(refinement.film().mean(x, y), film.mean(x, y));
  const Frame frame = refinement.frame(true);
  EXPECT_EQ(frame.hits.size(), static_cast<size_t>(kWidth) * kHeight);
  EXPECT_EQ(frame.samples, static_cast<int>(refinement.samples()));
}

TEST_F(RefinementTest, AWindowTracesItsPixelsOnlyAndFindsThemAgain) {
  Refinement refinement(cloth, kWidth, kHeight, 0);
  const PixelRect first{4, 6, 20, 16}, second{30, 20, 20, 16};
  refinement.look(first);
  refine(refinement, 2);
  const uint32_t had = refinement.samples();
  EXPECT_EQ(refinement.film().samples(4, 6), had);
  EXPECT_EQ(refinement.film().samples(3, 6), 0u);
  EXPECT_EQ(refinement.film().samples(24, 21), 0u);

  refinement.look(second);
  EXPECT_FALSE(refinement.begun());
  refine(refinement, 1);
  const PixelRect between{10, 10, 30, 14};  // parts of both, and what neither has seen
  refinement.look(between);
  EXPECT_FALSE(refinement.begun());
  ASSERT_TRUE(refinement.advance(Task{{}, {}, 1}));
  const Frame frame = refinement.frame(false);
  EXPECT_EQ(frame.rgba.size(), 30u * 14u);
  EXPECT_TRUE(frame.hits.empty());
  const auto seen = std::count_if(frame.rgba.begin(), frame.rgba.end(), [](const glm::vec4& p) { return p.a > 0; });
  EXPECT_GT(seen, 0.8 * 30 * 14) << "coarse pixels stand in, but for a few that look between the yarns";

  refinement.look(first);
  EXPECT_TRUE(refinement.begun());
  EXPECT_EQ(refinement.samples(), had);
}

TEST_F(RefinementTest, ACoarseWindowCoversAllThatWasAskedFor) {
  Refinement refinement(cloth, kWidth, kHeight, 1e-3);  // so slow a cloth begins coarsely
  const PixelRect window{13, 7, 30, 22};
  refinement.look(window);
  ASSERT_TRUE(refinement.advance(Task{{}, {}, 1}));
  const Frame frame = refinement.frame(false);
  ASSERT_GT(frame.divider, 1);
  EXPECT_LE(frame.window.x, window.x);
  EXPECT_LE(frame.window.y, window.y);
  EXPECT_GE(frame.window.x + frame.window.width, window.x + window.width);
  EXPECT_GE(frame.window.y + frame.window.height, window.y + window.height);
  EXPECT_EQ(frame.window.width, frame.width * frame.divider);
  EXPECT_EQ(frame.rgba.size(), static_cast<size_t>(frame.width) * frame.height);
}

TEST_F(RefinementTest, AStoppedPassLosesNothing) {
  Refinement refinement(cloth, kWidth, kHeight, 0);
  refine(refinement, 1);
  const uint32_t had = refinement.samples();
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(refinement.advance(Task{stop.get_token(), {}, 1}));
  EXPECT_EQ(refinement.samples(), had);
  refine(refinement, had + 1);
  EXPECT_GT(refinement.spent_s(), 0);
}

}  // namespace
}  // namespace loomlight
