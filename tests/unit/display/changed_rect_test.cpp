#include "render/display/changed_rect.h"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace loomlight {
namespace {

PixelRect changed(const std::vector<int>& before, const std::vector<int>& now, int width) {
  return changedRect<int>(before, now, width, std::equal_to<int>());
}

TEST(ChangedRect, HoldsWhatChangedAndNoMore) {
  const std::vector<int> before(7 * 5, 1);
  EXPECT_EQ(changed(before, before, 7), PixelRect{});
  std::vector<int> now = before;
  now[2 * 7 + 3] = 2;
  EXPECT_EQ(changed(before, now, 7), (PixelRect{3, 2, 1, 1}));
  now[4 * 7 + 1] = 2;
  EXPECT_EQ(changed(before, now, 7), (PixelRect{1, 2, 3, 3}));
  now[0] = now[6] = 2;
  EXPECT_EQ(changed(before, now, 7), (PixelRect{0, 0, 7, 5}));
}

TEST(ChangedRect, IsTheWholeOfAnotherSize) {
  EXPECT_EQ(changed(std::vector<int>(7), std::vector<int>(14), 7), (PixelRect{0, 0, 7, 2}));
  EXPECT_EQ(changed({}, {}, 0), PixelRect{});
}

}  // namespace
}  // namespace loomlight
