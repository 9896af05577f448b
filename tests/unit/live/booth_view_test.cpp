#include "app/live/booth_view.h"

#include <gtest/gtest.h>

#include "tests/support/refining_test.h"

namespace loomlight {
namespace {

class BoothOfRefinement : public test::RefiningTest {};

// Whoever asks for the booth while a picture is young need not wait for its first sample: each pass that has filled it
// says how light changes.
TEST_F(BoothOfRefinement, DividesAPictureFromItsFirstPassOn) {
  Refinement picture(cloth, kWidth, kHeight, {.paths_bytes = size_t{64} << 20});
  int passes = 0;
  while (picture.samples() == 0) {
    const int before = picture.divider();
    ASSERT_TRUE(picture.advance(Task{{}, {}, 1}));
    if (picture.divider() == before) continue;  // some buckets of a pass
    BoothView view;
    view.follow(picture, 1);
    EXPECT_EQ(view.divided(picture.frame()).size(), picture.frame().rgba.size()) << "1/" << picture.divider();
    ++passes;
  }
  EXPECT_GE(passes, 2) << "a coarse one, and the first sample";
}

}  // namespace
}  // namespace loomlight
