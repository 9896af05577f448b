#include "render/metrics/heat_map.h"

#include <gtest/gtest.h>

#include "render/colour/colour_space.h"

namespace loomlight {
namespace {

TEST(HeatMap, LightnessIsTheValue) {
  // Would fail where the path left the display's gamut and were cut.
  for (int i = 0; i <= 200; ++i) {
    const double value = i / 200.0;
    EXPECT_NEAR(labFromLinear(heatColour(value)).L, 100 * value, 1e-3) << value;
  }
}

TEST(HeatMap, StepsLookAboutEqual) {
  double least = 1e9, most = 0;
  for (int i = 0; i < 20; ++i) {
    const double step = ciede2000(labFromLinear(heatColour(i / 20.0)), labFromLinear(heatColour((i + 1) / 20.0)));
    least = std::min(least, step);
    most = std::max(most, step);
  }
  EXPECT_LT(most, 3.5 * least);
}

TEST(HeatMap, RunsFromBlackAtZeroToWhiteAtItsRange) {
  const Pixels8 pixels = heatMap({0, 0.1f, 0.2f, 7}, 2, 2, 0.2);
  ASSERT_EQ(pixels.bytes.size(), 12u);
  for (size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(pixels.bytes[i], 0);
    EXPECT_EQ(pixels.bytes[6 + i], 255);
    EXPECT_EQ(pixels.bytes[9 + i], 255);
  }
  EXPECT_GT(pixels.bytes[3], pixels.bytes[5] + 40);  // red in the middle
}

}  // namespace
}  // namespace loomlight
