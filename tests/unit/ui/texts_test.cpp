#include <gtest/gtest.h>

#include <tuple>

#include "core/base/error.h"
#include "ui/count_text.h"
#include "ui/thread_order.h"

namespace loomlight {
namespace {

TEST(ThreadOrder, ReadsBackWhatItWrites) {
  const std::vector<int> sequences[] = {{0}, {0, 0, 0, 1, 1}, {2, 0, 2, 2}, {25, 26, 26, 51, 0}};
  for (const std::vector<int>& sequence : sequences)
    EXPECT_EQ(threadOrderFromText(threadOrderText(sequence), 64, 100), sequence) << threadOrderText(sequence);
}

TEST(ThreadOrder, ReadsWhatWeaversWrite) {
  EXPECT_EQ(threadOrderFromText(" 2a b,3C ", 3, 100), (std::vector<int>{0, 0, 1, 2, 2, 2}));
  EXPECT_EQ(threadOrderFromText("4A2B", 2, 100), (std::vector<int>{0, 0, 0, 0, 1, 1}));
}

TEST(ThreadOrder, GroupsRepeat) {
  EXPECT_EQ(threadOrderFromText("2(A 2B) C", 3, 100), (std::vector<int>{0, 1, 1, 0, 1, 1, 2}));
  EXPECT_EQ(threadOrderFromText("2 ( 2(A B)C )", 3, 100), (std::vector<int>{0, 1, 0, 1, 2, 0, 1, 0, 1, 2}));
  for (const char* text : {"2(A", "A)", "()", "3()", "99(2A)", "9999999(9999999(9999999A))", "((((((((((A))))))))))"})
    EXPECT_THROW(threadOrderFromText(text, 2, 100), InputError) << text;
}

TEST(ThreadOrder, RefusesWhatIsNone) {
  for (const char* text : {"", "   ", "4", "0A", "4C", "4A ?", "99999999999A", "AAAAAAAAAAAAAAAAAAAAAAAA", "101A"})
    EXPECT_THROW(threadOrderFromText(text, 2, 100), InputError) << text;
}

void expectCount(const char* text, double tex, std::optional<int> plies, CountSystem usual = CountSystem::tex) {
  const auto entry = countFromText(text, usual);
  ASSERT_TRUE(entry.has_value()) << text;
  EXPECT_NEAR(entry->tex, tex, 1e-9) << text;
  EXPECT_EQ(entry->plies, plies) << text;
}

TEST(CountText, KnowsTheSystemsOfSpinners) {
  expectCount("19.7 tex", 19.7, {});
  expectCount("19.7", 19.7, {});
  expectCount("30 Ne", 590.5 / 30, {});
  expectCount("Ne 30", 590.5 / 30, {});
  expectCount("30", 590.5 / 30, {}, CountSystem::cotton);
  expectCount("150den", 150 / 9.0, {});
  expectCount("167 DTEX", 16.7, {});
  expectCount("40 NeL", 1653.5 / 40, {});
}

TEST(CountText, KnowsPlies) {
  expectCount("30/2 Ne", 2 * 590.5 / 30, 2);
  expectCount("Ne 30/2", 2 * 590.5 / 30, 2);
  expectCount("2/60 Nm", 1000.0 / 30, 2);
  expectCount("30/1", 590.5 / 30, 1, CountSystem::cotton);
  expectCount("20 tex x 2", 40, 2);
  expectCount("20x3 tex", 60, 3);
  expectCount("R 40 tex/2", 40, 2);
}

TEST(CountText, KnowsCables) {
  for (const char* text : {"20/2/3 Ne", "Ne 20/2/3", "20 Ne x 2 x 3"}) {
    const auto entry = countFromText(text, CountSystem::tex);
    ASSERT_TRUE(entry.has_value()) << text;
    EXPECT_NEAR(entry->tex, 6 * 590.5 / 20, 1e-9) << text;
    EXPECT_EQ(entry->plies, 2) << text;
    EXPECT_EQ(entry->cords, 3) << text;
  }
  const auto entry = countFromText("R 180 tex/2/3", CountSystem::cotton);
  ASSERT_TRUE(entry.has_value());
  EXPECT_EQ(std::tuple(entry->tex, *entry->plies, *entry->cords), std::tuple(180.0, 2, 3));
  EXPECT_EQ(countFromText("30/2 Ne", CountSystem::tex)->cords, 1);
}

TEST(CountText, RefusesWhatIsNone) {
  for (const char* text :
       {"", "Ne", "30/2", "30/0 Ne", "-5 tex", "30/2 tex", "nan tex", "20 stone", "30 Ne x", "30/2/7 Ne", "30/2/2/2 Ne",
        "30/2/2 tex", "20 tex x 9", "2.5/60 Nm", "Ne 30 Nm", "x 2 tex", "20 tex x 2 /2"})
    EXPECT_FALSE(countFromText(text, CountSystem::tex).has_value()) << text;
}

TEST(TwistText, KnowsTurnsPerMetrePerInchAndMultipliers) {
  EXPECT_NEAR(twistFromText("780 t/m", 20).value(), 780, 1e-12);
  EXPECT_NEAR(twistFromText("20tpi", 20).value(), 20 / 0.0254, 1e-9);
  EXPECT_NEAR(twistFromText("4 TM", 590.5 / 25).value(), 20 / 0.0254, 1.5);
  for (const char* text : {"", "20", "20 turns", "-3 tpi", "4 TM x"})
    EXPECT_FALSE(twistFromText(text, 20).has_value()) << text;
}

}  // namespace
}  // namespace loomlight
