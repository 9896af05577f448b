#include "app/editor/model/picture_label.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace loomlight {
namespace {

Pixels8 black(int width, int height) {
  return {width, height, 3, std::vector<uint8_t>(static_cast<size_t>(3 * width * height), 0)};
}

uint8_t at(const Pixels8& pixels, int x, int y) {
  return pixels.bytes[static_cast<size_t>(3 * (y * pixels.width + x))];
}

TEST(PictureLabel, AnEmptyOneChangesNothing) {
  const Pixels8 picture = black(80, 60);
  EXPECT_EQ(labelled(picture, {}, 0.01).bytes, picture.bytes);
}

TEST(PictureLabel, ThePictureStaysAsItIsAboveTheBand) {
  const Pixels8 picture = black(400, 300), with = labelled(picture, {true, "Blue twill"}, 0.01);
  EXPECT_EQ(with.width, 400);
  EXPECT_GT(with.height, 300);
  EXPECT_TRUE(std::equal(picture.bytes.begin(), picture.bytes.end(), with.bytes.begin()));
}

TEST(PictureLabel, TheBarHasARoundLength) {
  // A fifth of 400 pixels of 0.016 mm is 1.28 mm: the bar is 1 mm, 62.5 pixels.
  const Pixels8 with = labelled(black(400, 300), {true, ""}, 0.016);
  const int y = 300 + (with.height - 300) / 2;
  int first = 0, last = 0;
  for (int x = 0; x < 120; ++x)
    if (at(with, x, y) == 250) {
      if (first == 0) first = x;
      last = x;
      if (at(with, x + 1, y) != 250) break;
    }
  EXPECT_NEAR(last + 1 - first, 62.5, 1);
  EXPECT_DOUBLE_EQ(roundLength(1.28), 1);
  EXPECT_DOUBLE_EQ(roundLength(4.9), 2);
  EXPECT_DOUBLE_EQ(roundLength(0.0731), 0.05);
}

TEST(PictureLabel, ALongCaptionIsCutToItsRoom) {
  const std::string endless(5000, 'W');
  const Pixels8 with = labelled(black(200, 100), {true, endless}, 0.01);
  bool written = false;
  for (int y = 100; y < with.height; ++y) {
    EXPECT_EQ(at(with, 199, y), 118) << "nothing runs out of the picture";
    for (int x = 100; x < 199; ++x) written |= at(with, x, y) > 200;
  }
  EXPECT_TRUE(written);
}

TEST(PictureLabel, BytesThatAreNoTextDoNoHarm) {
  EXPECT_EQ(labelled(black(64, 64), {false, "\xFF\xC3 \xE2\x80 ok"}, 0.01).width, 64);
  EXPECT_EQ(labelled(black(1, 1), {true, "x"}, 1e-6).width, 1);
}

}  // namespace
}  // namespace loomlight
