#include "app/export/weave_bitmap.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <map>

#include "app/export/loom_bitmap.h"
#include "core/base/error.h"
#include "render/film/image.h"

namespace loomlight {
namespace {

Fabric withWeave(const Weave& weave) {
  Fabric fabric;
  fabric.weave = weave;
  return fabric;
}

class WeaveBitmap : public testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove(file_); }
  const std::string file_ = testing::TempDir() + "weave-bitmap-" + std::to_string(getpid()) + ".png";
};

TEST_F(WeaveBitmap, ComesBackAsItWas) {
  const Weave weave({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {0, 0, 0}});
  writeWeaveBitmap(file_, withWeave(weave));
  EXPECT_TRUE(readWeaveBitmap(file_) == weave);
}

TEST_F(WeaveBitmap, FirstPickIsAtTheBottomAndDarkIsWarp) {
  const Weave weave({{1, 0}, {0, 0}, {0, 0}});
  writeWeaveBitmap(file_, withWeave(weave));
  const Pixels8 pixels = readPng(file_);
  ASSERT_EQ(pixels.width, 2);
  ASSERT_EQ(pixels.height, 3);
  const auto* corner = &pixels.bytes[static_cast<size_t>(2) * 2 * pixels.channels];
  EXPECT_EQ(corner[0], 0);
  EXPECT_EQ(pixels.bytes[0], 255);
}

size_t number(const std::string& bytes, size_t at, int length) {
  size_t value = 0;
  for (int i = 0; i < length; ++i) value |= static_cast<size_t>(static_cast<uint8_t>(bytes[at + i])) << (8 * i);
  return value;
}

/// Ten ends, so that a row is more than a byte; the first pick raises the first end and the last two.
Fabric forLoom() {
  Fabric fabric = withWeave(
      Weave({{1, 0, 0, 0, 0, 0, 0, 0, 1, 1}, {0, 1, 0, 0, 0, 0, 0, 0, 0, 0}, {0, 0, 1, 0, 0, 0, 0, 0, 0, 0}}));
  fabric.ends_per_cm = 24;
  fabric.picks_per_cm = 18.5;
  return fabric;
}

TEST(LoomBitmap, ATiffHasTheLastPickFirstAndASetBitIsARaisedEnd) {
  const std::string tiff = tiffOf(forLoom());
  ASSERT_EQ(tiff.substr(0, 4), std::string("II*\0", 4));
  std::map<size_t, size_t> tags;
  const size_t directory = number(tiff, 4, 4), entries = number(tiff, directory, 2);
  size_t last = 0;
  for (size_t i = 0; i < entries; ++i) {
    const size_t entry = directory + 2 + 12 * i, tag = number(tiff, entry, 2);
    EXPECT_GT(tag, last) << "tags ascend";
    last = tag;
    tags[tag] = number(tiff, entry + 8, 4);
  }
  EXPECT_EQ(tags[256], 10u);
  EXPECT_EQ(tags[257], 3u);
  EXPECT_EQ(tags[258], 1u);
  EXPECT_EQ(tags[259], 1u);
  EXPECT_EQ(tags[262], 0u);
  EXPECT_EQ(tags[279], 6u);
  ASSERT_EQ(tags[273] + tags[279], tiff.size());
  EXPECT_EQ(tiff.substr(tags[273]), std::string("\x20\0\x40\0\x80\xC0", 6));
  EXPECT_EQ(number(tiff, tags[283], 4) / static_cast<double>(number(tiff, tags[283] + 4, 4)), 18.5);
}

TEST(LoomBitmap, ABmpHasTheFirstPickFirstInRowsOfFourBytes) {
  const std::string bmp = bmpOf(forLoom());
  ASSERT_EQ(bmp.substr(0, 2), "BM");
  EXPECT_EQ(number(bmp, 2, 4), bmp.size());
  EXPECT_EQ(number(bmp, 18, 4), 10u);
  EXPECT_EQ(number(bmp, 22, 4), 3u);
  EXPECT_EQ(number(bmp, 28, 2), 1u);
  EXPECT_EQ(number(bmp, 38, 4), 2400u);
  EXPECT_EQ(bmp.substr(54, 8), std::string("\xFF\xFF\xFF\0\0\0\0\0", 8));
  ASSERT_EQ(number(bmp, 10, 4), 62u);
  EXPECT_EQ(bmp.substr(62), std::string("\x80\xC0\0\0\x40\0\0\0\x20\0\0\0", 12));
}

TEST_F(WeaveBitmap, OtherEndingsAreRefused) {
  EXPECT_THROW(writeWeaveBitmap(file_ + ".ep", forLoom()), InputError);
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
