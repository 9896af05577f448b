#include "app/cli/progress.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>

namespace loomlight {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

TEST(Progress, DurationsReadWell) {
  EXPECT_EQ(durationText(0), "0.0 s");
  EXPECT_EQ(durationText(2.44), "2.4 s");
  EXPECT_EQ(durationText(9.97), "10 s");
  EXPECT_EQ(durationText(59.7), "1 min 00 s");
  EXPECT_EQ(durationText(65), "1 min 05 s");
  EXPECT_EQ(durationText(3600 * 3 + 60 * 20 + 5), "3 h 20 min");
}

TEST(Progress, BarSaysHowFarAndHowLong) {
  EXPECT_THAT(
      progressBar("rendering", 0.5, 12, 80),
      AllOf(HasSubstr("rendering"), HasSubstr("50 %"), HasSubstr("12 s left"), HasSubstr("#."), Not(HasSubstr("\n"))));
  EXPECT_THAT(progressBar("rendering", 0, 12, 80), Not(HasSubstr("left")));
  EXPECT_THAT(progressBar("rendering", 1, 12, 80), AllOf(HasSubstr("100 %"), Not(HasSubstr(".]"))));
}

TEST(Progress, BarFitsAnyTerminal) {
  for (int columns = 0; columns <= 200; ++columns)
    for (const double fraction : {0.0, 0.001, 0.37, 1.0})
      EXPECT_LE(static_cast<int>(progressBar("rendering", fraction, 1e5, columns).size()), std::max(0, columns - 1))
          << columns;
}

TEST(Progress, ALogHasNoControlCharacters) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> log(std::tmpfile(), &std::fclose);
  ASSERT_TRUE(log);
  {
    Progress progress("rendering", ProgressStyle::plain, log.get());
    for (int i = 0; i <= 1000; ++i) progress.update(i / 1000.0);
  }
  std::rewind(log.get());
  for (int c; (c = std::fgetc(log.get())) != EOF;) EXPECT_TRUE(c == '\n' || c >= ' ');
}

}  // namespace
}  // namespace loomlight
