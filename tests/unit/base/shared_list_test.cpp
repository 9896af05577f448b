#include "core/base/shared_list.h"

#include <gtest/gtest.h>

namespace loomlight {
namespace {

SharedList<int> counting(int count) {
  std::vector<std::shared_ptr<const int>> values;
  for (int i = 0; i < count; ++i) values.push_back(std::make_shared<const int>(i));
  return SharedList<int>(values);
}

TEST(SharedList, HoldsWhatItWasGiven) {
  for (const int count : {0, 1, 63, 64, 65, 300}) {
    const SharedList<int> list = counting(count);
    ASSERT_EQ(list.size(), static_cast<size_t>(count));
    for (int i = 0; i < count; ++i) EXPECT_EQ(*list[i], i);
    EXPECT_EQ(list.all().size(), list.size());
  }
}

TEST(SharedList, LeavesItsCopyAlone) {
  const SharedList<int> before = counting(300);
  SharedList<int> after = before;
  after.set(299, std::make_shared<const int>(-1));
  after.set(70, std::make_shared<const int>(-2));
  EXPECT_EQ(*before[299], 299);
  EXPECT_EQ(*after[299], -1);
  for (int i = 0; i < 300; ++i)
    if (i != 70 && i != 299) {
      EXPECT_EQ(after[i], before[i]);
    }
}

TEST(SharedList, TellsWhatAnotherLacks) {
  const SharedList<int> before = counting(300);
  SharedList<int> after = before;
  const auto beside = [](const SharedList<int>& list, const SharedList<int>& other) {
    std::vector<int> values;
    list.forEachBeside(other, [&](const auto& value) { values.push_back(*value); });
    return values;
  };
  EXPECT_TRUE(beside(after, before).empty());
  after.set(64, std::make_shared<const int>(-1));
  after.set(7, std::make_shared<const int>(-2));
  EXPECT_EQ(beside(after, before), (std::vector<int>{-2, -1}));
  EXPECT_EQ(beside(before, after), (std::vector<int>{7, 64}));
  const SharedList<int> some(std::vector{before[0], before[1]});
  EXPECT_EQ(beside(before, some).size(), 298u);
  EXPECT_TRUE(beside(some, before).empty());
}

}  // namespace
}  // namespace loomlight
