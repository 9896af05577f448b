#include "app/bench/studies/report_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "core/base/file.h"
#include "core/base/random.h"

namespace loomlight {
namespace {

using testing::ElementsAre;

Pixels8 noise(int side) {
  Pixels8 picture{side, side, 3, {}};
  Random random(1);
  for (int i = 0; i < side * side * 3; ++i) picture.bytes.push_back(static_cast<uint8_t>(random.below(256)));
  return picture;
}

TEST(ReportPage, SmallPicturesAreSmall) {
  const std::string folder =
      std::filesystem::temp_directory_path() / ("loomlight-report-page-test-" + std::to_string(getpid()));
  ReportPage page(folder, "page", "Title");
  page.picture("noise", noise(512), "noise");
  page.table("table", {"a", "b"}, {{"1, 2", "3"}});
  EXPECT_GT(std::filesystem::file_size(folder + "/noise.png"), ReportPage::kSmall_bytes);
  EXPECT_LE(std::filesystem::file_size(folder + "/small/noise.png"), ReportPage::kSmall_bytes);
  EXPECT_EQ(readPng(folder + "/small/noise.png").width, 128);
  EXPECT_EQ(readFile(folder + "/table.csv", 1000), "a,b\n\"1, 2\",3\n");
  EXPECT_THAT(readFile(page.finish(), 1000), testing::HasSubstr("| 1, 2 | 3 |"));
  std::filesystem::remove_all(folder);
}

TEST(Halved, IsTheMeanOfFour) {
  const Pixels8 half = halved({3, 2, 1, {10, 20, 99, 30, 40, 99}});
  EXPECT_EQ(half.width, 1);
  EXPECT_EQ(half.height, 1);
  EXPECT_THAT(half.bytes, ElementsAre(25));
}

TEST(Magnified, RepeatsEveryPixel) {
  const Pixels8 large = magnified({2, 1, 1, {7, 9}}, 2);
  EXPECT_EQ(large.width, 4);
  EXPECT_EQ(large.height, 2);
  EXPECT_THAT(large.bytes, ElementsAre(7, 7, 9, 9, 7, 7, 9, 9));
}

}  // namespace
}  // namespace loomlight
