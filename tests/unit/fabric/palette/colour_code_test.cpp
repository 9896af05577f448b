#include "core/fabric/palette/colour_code.h"

#include <gtest/gtest.h>

#include "core/base/rgb.h"

namespace loomlight {
namespace {

TEST(ColourCode, HexadecimalIsSrgb) {
  for (const char* text : {"#1a2b3C", "1A2b3c", "  #1a2b3c "}) {
    const auto colour = colourFromCode(text);
    ASSERT_TRUE(colour) << text;
    for (int c = 0; c < 3; ++c)
      EXPECT_FLOAT_EQ(colour->linear[c], decodeSrgb(static_cast<float>(0x1a + 0x11 * c) / 255.0f)) << text;
    EXPECT_FALSE(colour->lab || colour->reflectance);
  }
}

TEST(ColourCode, LabIsOfDaylight) {
  for (const char* text : {"Lab 52.5 40 -12", "lab 52.5, 40, -12", "LAB 52.5; 40; -12 "}) {
    const auto colour = colourFromCode(text);
    ASSERT_TRUE(colour && colour->lab) << text;
    EXPECT_EQ(colour->lab->L, 52.5);
    EXPECT_EQ(colour->lab->a, 40);
    EXPECT_EQ(colour->lab->b, -12);
    EXPECT_EQ(colour->lab->illuminant, "D65");
    EXPECT_EQ(colour->lab->observer_degrees, 2);
  }
}

TEST(ColourCode, AnythingElseIsNone) {
  for (const char* text : {"", " ", "#", "#12345", "#1234567", "#12345g", "navy", "Lab", "Lab 50 10", "Lab 50 10 10 10",
                           "Lab 101 0 0", "Lab -1 0 0", "Lab 50 201 0", "Lab 50 nan 0", "Lab50 1 2", "50 10 10"})
    EXPECT_FALSE(colourFromCode(text)) << text;
}

}  // namespace
}  // namespace loomlight
