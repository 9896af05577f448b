#include "render/display/despeckle.h"

#include <gtest/gtest.h>

#include <vector>

namespace loomlight {
namespace {

TEST(Despeckle, TamesASpeckAndKeepsItsHueAndAlpha) {
  std::vector<glm::vec4> rgba(25, {0.5f, 0.25f, 0.125f, 1.0f});
  rgba[12] = {40, 20, 10, 0.5f};
  despeckle(rgba, 5, 5, 2);
  EXPECT_FLOAT_EQ(rgba[12].r, 1.0f);
  EXPECT_FLOAT_EQ(rgba[12].g, 0.5f);
  EXPECT_FLOAT_EQ(rgba[12].b, 0.25f);
  EXPECT_FLOAT_EQ(rgba[12].a, 0.5f);
  for (size_t i = 0; i < rgba.size(); ++i) {
    if (i != 12) {
      EXPECT_EQ(rgba[i], glm::vec4(0.5f, 0.25f, 0.125f, 1.0f));
    }
  }
}

TEST(Despeckle, LeavesEdgesAlone) {
  // Half dark, half bright: the median of either side is of that side.
  std::vector<glm::vec4> rgba;
  for (int y = 0; y < 6; ++y)
    for (int x = 0; x < 6; ++x) rgba.emplace_back(glm::vec3(x < 3 ? 0.01f : 1.0f), 1.0f);
  const auto before = rgba;
  despeckle(rgba, 6, 6, 2);
  EXPECT_EQ(rgba, before);
}

TEST(Despeckle, TakesPicturesOfAnySize) {
  for (const auto& [width, height] : std::vector<std::pair<int, int>>{{0, 0}, {1, 1}, {1, 7}, {2, 2}}) {
    std::vector<glm::vec4> rgba(static_cast<size_t>(width) * height, glm::vec4(1));
    despeckle(rgba, width, height, 2);
    for (const glm::vec4& pixel : rgba) EXPECT_EQ(pixel, glm::vec4(1));
  }
}

TEST(Soften, KeepsTheLightAndHidesTheTiles) {
  std::vector<glm::vec4> picture(25, glm::vec4(0));
  picture[12] = glm::vec4(16, 8, 4, 1);
  soften(picture, 5, 5);
  glm::vec4 sum(0);
  for (const glm::vec4& pixel : picture) sum += pixel;
  EXPECT_EQ(sum, glm::vec4(16, 8, 4, 1));
  EXPECT_EQ(picture[12], glm::vec4(4, 2, 1, 0.25f));
  EXPECT_EQ(picture[11], glm::vec4(2, 1, 0.5f, 0.125f));
  EXPECT_EQ(picture[6], glm::vec4(1, 0.5f, 0.25f, 0.0625f));
}

TEST(Soften, LeavesAnEvenPictureAlone) {
  std::vector<glm::vec4> picture(12, glm::vec4(0.5f, 0.25f, 1, 1));
  soften(picture, 4, 3);
  for (const glm::vec4& pixel : picture) EXPECT_EQ(pixel, glm::vec4(0.5f, 0.25f, 1, 1));
}

}  // namespace
}  // namespace loomlight
