#include "app/editor/display/keyboard_layout.h"

#include <gtest/gtest.h>

namespace loomlight {
namespace {

TEST(KeyboardLayout, LettersAreWhereTheUserHasThem) {
  EXPECT_EQ(keyOnLayout('Y', "z"), 'Z') << "QWERTZ";
  EXPECT_EQ(keyOnLayout('Z', "y"), 'Y');
  EXPECT_EQ(keyOnLayout('Q', "a"), 'A') << "AZERTY";
  EXPECT_EQ(keyOnLayout(';', "m"), 'M');
  EXPECT_EQ(keyOnLayout('Q', "Q"), 'Q');
}

TEST(KeyboardLayout, OtherKeysStay) {
  constexpr int kEscape = 256;  // as GLFW
  EXPECT_EQ(keyOnLayout(kEscape, nullptr), kEscape);
  EXPECT_EQ(keyOnLayout(kEscape, ""), kEscape);
  EXPECT_EQ(keyOnLayout('1', "&"), '1');
  EXPECT_EQ(keyOnLayout('M', ","), 'M');
  EXPECT_EQ(keyOnLayout('Z', "\u044F"), 'Z') << "a Russian keyboard";
  EXPECT_EQ(keyOnLayout('[', "\u00FC"), '[');
}

}  // namespace
}  // namespace loomlight
