#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "core/base/sprague.h"

// Why a build is called checked; only such a build has these tests. A flag that is lost would show nowhere else: an
// assertion that is compiled out cannot fail.

namespace loomlight {
namespace {

class Checked : public testing::Test {
 protected:
  void SetUp() override { GTEST_FLAG_SET(death_test_style, "threadsafe"); }
};

TEST_F(Checked, OurAssertionsAreOn) {
  const std::array<double, kSpragueSamples> samples{};
  EXPECT_DEATH(sprague(samples, kSpragueSamples), "sprague.cpp.*Assertion");
}

TEST_F(Checked, TheStandardLibrarysAssertionsAreOn) {
  const std::vector<int> none;
  const volatile size_t first = 0;
  EXPECT_DEATH(static_cast<void>(none[first]), "Assertion");
}

}  // namespace
}  // namespace loomlight
