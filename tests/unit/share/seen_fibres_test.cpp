#include "render/share/seen_fibres.h"

#include <gtest/gtest.h>

namespace loomlight {
namespace {

const CellMeans::Mean kDark{Rgb(0.2f), 0.2f}, kBright{Rgb(0.6f), 1.2f};

TEST(SeenFibres, AtARimShowAsMuchOfTheClothAsThereIs) {
  SeenFibres seen(2, 1);
  seen.meets(0, kDark);
  seen.meets(0, kBright);
  seen.misses(0, false);
  seen.misses(0, false);
  seen.misses(1, false);
  const SharedPicture picture = seen.picture(1);
  EXPECT_FLOAT_EQ(picture.alpha[0], 0.5f);
  EXPECT_FLOAT_EQ(picture.light[0].g, 0.5f * 0.4f);
  // A path has the square of a fibre's light, (.2 + 1.2) / 2 at the mean, or none; less the square of its mean.
  EXPECT_FLOAT_EQ(picture.variances[0], 0.5f * 0.7f - 3 * 0.2f * 0.2f);
  EXPECT_EQ(picture.alpha[1], 0) << "beside the cloth";
}

TEST(SeenFibres, OfAPixelThatSeesNoneAreThoseAround) {
  SeenFibres seen(3, 1);
  seen.misses(0, true);
  seen.misses(1, true);
  seen.meets(1, kBright);
  seen.meets(2, kDark);
  const SharedPicture picture = seen.picture(1);
  ASSERT_GT(picture.alpha[0], 0);
  EXPECT_FLOAT_EQ(picture.light[0].r / picture.alpha[0], kBright.colour.r) << "the nearest alone";
}

}  // namespace
}  // namespace loomlight
