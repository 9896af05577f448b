#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/fabric/weave/yarn_order.h"
#include "core/fabric/weave/yarn_sequence.h"

namespace loomlight {
namespace {

using testing::ElementsAre;

TEST(Stripes, AreTheOrderAndBack) {
  const std::vector<int> order = {0, 0, 1, 2, 2, 2, 0};
  EXPECT_THAT(stripesOf(order), ElementsAre(Stripe{0, 2}, Stripe{1, 1}, Stripe{2, 3}, Stripe{0, 1}));
  EXPECT_EQ(sequenceOf(stripesOf(order)), order);
}

TEST(Stripes, TheLastOneIsMadeLongerToRepeatWithTheWeave) {
  EXPECT_THAT(balanced({0, 0, 1}, 4), ElementsAre(0, 0, 1, 1));
  EXPECT_THAT(balanced({0, 0, 1, 1}, 4), ElementsAre(0, 0, 1, 1));
  EXPECT_THAT(balanced({0, 1, 1}, 1), ElementsAre(0, 1, 1));
}

TEST(YarnOrder, GroupsStayGroups) {
  for (const char* text : {"4(2A 2B) 3A 4B", "10A 2B 8C 2B 6D 2B 8E 2B", "2(3(A B) 4C)", "6A 4B", "3(4A 2B)"})
    EXPECT_EQ(yarnOrderText(yarnOrderFromText(text, 5, 1000)), text);
}

}  // namespace
}  // namespace loomlight
