#include "render/display/reframe.h"

#include <gtest/gtest.h>

namespace loomlight {
namespace {

constexpr int kOldYarn = 0, kFreshYarn = 1;

Frame pictureOf(int width, int height, int divider, int yarn) {
  Frame frame;
  frame.width = (width + divider - 1) / divider;
  frame.height = (height + divider - 1) / divider;
  frame.divider = divider;
  frame.window = {0, 0, frame.width * divider, frame.height * divider};
  const size_t pixels = static_cast<size_t>(frame.width) * static_cast<size_t>(frame.height);
  frame.rgba.assign(pixels, glm::vec4(yarn == kOldYarn ? 0.2f : 0.8f));
  frame.hits.assign(pixels, {yarn, 0, 0, 25});
  return frame;
}

TEST(Reframed, KeepsTheOldPictureInTheMiddleOfAWiderOne) {
  for (const int divider : {1, 4}) {
    Frame fresh = pictureOf(101, 40, divider, kFreshYarn);
    fresh.generation = 7;
    const Frame whole = reframed(fresh, pictureOf(61, 40, 1, kOldYarn), 101, 40, 1);
    EXPECT_EQ(whole.generation, 7u);
    EXPECT_EQ(whole.divider, 1);
    ASSERT_EQ(whole.rgba.size(), 101u * 40);
    ASSERT_EQ(whole.hits.size(), whole.rgba.size());
    for (size_t i = 0; i < whole.rgba.size(); ++i) {
      const int x = static_cast<int>(i % 101), beside = std::max(20 - x, x - 80);  // > 0: outside of the old one
      SCOPED_TRACE(testing::Message() << x << " at 1/" << divider);
      if (beside > 0) {
        EXPECT_FLOAT_EQ(whole.rgba[i].r, 0.8f);
        EXPECT_EQ(whole.hits[i].yarn, kFreshYarn);
      } else if (beside <= -8) {
        EXPECT_FLOAT_EQ(whole.rgba[i].r, 0.2f);
        EXPECT_EQ(whole.hits[i].yarn, kOldYarn);
      } else {  // no border is a line
        EXPECT_GE(whole.rgba[i].r, 0.2f);
        EXPECT_LE(whole.rgba[i].r, 0.8f);
      }
    }
  }
}

TEST(Reframed, IsAsHighAsTheViewportAndLeavesOutWhatIsBesideIt) {
  const int width = 50, height = 30;
  Frame old = pictureOf(140, 60, 1, kOldYarn);  // twice as high: 20 of its pixels to each side are seen no more
  for (int y = 0; y < 60; ++y)
    for (int x = 0; x < 140; ++x) old.rgba[static_cast<size_t>(y) * 140 + static_cast<size_t>(x)].g = 0.01f * x;
  const Frame whole = reframed(pictureOf(width, height, 2, kFreshYarn), old, width, height, 1);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const size_t i = static_cast<size_t>(y) * width + static_cast<size_t>(x);
      EXPECT_FLOAT_EQ(whole.rgba[i].r, 0.2f) << "nothing of the new one is needed";
      EXPECT_NEAR(whole.rgba[i].g, 0.01f * (20.5f + 2 * x), 1e-4f) << x;
    }
}

}  // namespace
}  // namespace loomlight
