#include "ui/viewport/snapshot_options.h"

#include <gtest/gtest.h>

namespace loomlight {
namespace {

TEST(SnapshotOptions, PrintsHaveThePixelsOfTheirSize) {
  EXPECT_EQ(pixelsOfPrint(25.4, 300), 300);
  EXPECT_EQ(pixelsOfPrint(210, 300), 2480);  // the width of A4
  EXPECT_EQ(pixelsOfPrint(0.001, 72), 1);
  EXPECT_EQ(pixelsOfPrint(2000, 2400), 16384) << "no picture is wider";
}

}  // namespace
}  // namespace loomlight
