#include <gtest/gtest.h>

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

TEST(ThreadOrder, RefusesWhatIsNone) {
  for (const char* text : {"", "   ", "4", "0A", "4C", "4A ?", "99999999999A", "AAAAAAAAAAAAAAAAAAAAAAAA", "101A"})
    EXPECT_THROW(threadOrderFromText(text, 2, 100), InputError) << text;
}

TEST(CountText, KnowsTheSystemsOfSpinners) {
  EXPECT_DOUBLE_EQ(texFromText("19.7 tex").value(), 19.7);
  EXPECT_NEAR(texFromText("30 Ne").value(), 590.5 / 30, 1e-2);
  EXPECT_NEAR(texFromText("30/2 Ne").value(), 2 * 590.5 / 30, 1e-2);
  EXPECT_NEAR(texFromText("2/60 Nm").value(), 1000.0 / 30, 1e-6);
  EXPECT_NEAR(texFromText("150den").value(), 150 / 9.0, 1e-6);
  EXPECT_NEAR(texFromText("167 DTEX").value(), 16.7, 1e-6);
}

TEST(CountText, RefusesWhatIsNone) {
  for (const char* text : {"", "30", "Ne", "30/2", "30/0 Ne", "-5 tex", "30/2 tex", "nan tex", "20 stone"})
    EXPECT_FALSE(texFromText(text).has_value()) << text;
}

}  // namespace
}  // namespace loomlight
