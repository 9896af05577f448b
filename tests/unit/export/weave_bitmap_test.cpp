#include "app/export/weave_bitmap.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "core/base/error.h"
#include "render/film/image.h"

namespace loomlight {
namespace {

class WeaveBitmap : public testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove(file_); }
  const std::string file_ = testing::TempDir() + "weave-bitmap-" + std::to_string(getpid()) + ".png";
};

TEST_F(WeaveBitmap, ComesBackAsItWas) {
  const Weave weave({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {0, 0, 0}});
  writeWeaveBitmap(file_, weave);
  EXPECT_TRUE(readWeaveBitmap(file_) == weave);
}

TEST_F(WeaveBitmap, FirstPickIsAtTheBottomAndDarkIsWarp) {
  const Weave weave({{1, 0}, {0, 0}, {0, 0}});
  writeWeaveBitmap(file_, weave);
  const Pixels8 pixels = readPng(file_);
  ASSERT_EQ(pixels.width, 2);
  ASSERT_EQ(pixels.height, 3);
  const auto* corner = &pixels.bytes[static_cast<size_t>(2) * 2 * pixels.channels];
  EXPECT_EQ(corner[0], 0);
  EXPECT_EQ(pixels.bytes[0], 255);
}

TEST_F(WeaveBitmap, WhatIsNoPictureIsRefusedByName) {
  std::ofstream(file_) << "no picture";
  try {
    readWeaveBitmap(file_);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(file_), std::string::npos);
  }
}

}  // namespace
}  // namespace loomlight
