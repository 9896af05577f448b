#include "app/editor/controllers/profile_controller.h"

#include <gtest/gtest.h>

#include <atomic>
#include <latch>

#include "tests/support/colour_profiles.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/wakes.h"

namespace loomlight {
namespace {

using Source = DisplayColours::Source;

class ProfileControllerTest : public testing::Test {
 protected:
  /// Until something has come of it; what there is to say.
  template <class Condition>
  std::string until(ProfileController& profiles, const Condition& condition) {
    std::string problem;
    EXPECT_TRUE(wakes.until([&] {
      if (const auto said = profiles.follow()) problem = *said;
      return condition() || !problem.empty();
    }));
    return problem;
  }
  std::string fileOf(const char* name, const std::string& bytes) const {
    test::putBytes(folder.file(name), bytes);
    return folder.file(name);
  }
  static std::string wideDisplay() {
    return test::savedBytes(test::threePrimaries(test::kAdobe, 2.2, cmsSigDisplayClass));
  }

  test::ScratchFolder folder;
  Wakes wakes;
};

TEST_F(ProfileControllerTest, UsesTheSystemsUntilAFileIsChosen) {
  ProfileController profiles(DisplayColours{}, wakes.callback());
  EXPECT_EQ(profiles.displayCube(), nullptr);
  profiles.start(wideDisplay());
  EXPECT_EQ(until(profiles, [&] { return profiles.displayCube() != nullptr; }), "");
  const auto ofSystem = profiles.displayCube();
  const std::string file = fileOf("mine.icc", wideDisplay());
  profiles.open(file);
  EXPECT_EQ(until(profiles, [&] { return profiles.displayCube() != ofSystem; }), "");
  EXPECT_EQ(profiles.colours().source, Source::file);
  EXPECT_EQ(profiles.colours().displayFile, file);
  profiles.colours().source = Source::srgb;
  EXPECT_EQ(profiles.displayCube(), nullptr);
}

TEST_F(ProfileControllerTest, APrinterIsProofedAtOnce) {
  ProfileController profiles(DisplayColours{}, wakes.callback());
  EXPECT_EQ(profiles.proof().prints, nullptr);
  profiles.open(fileOf("paper.icm", test::palePrinterProfile()));
  EXPECT_EQ(until(profiles, [&] { return profiles.proof().prints != nullptr; }), "");
  EXPECT_EQ(profiles.displayCube(), nullptr) << "the window itself is not proofed";
  profiles.colours().proofs = false;
  EXPECT_EQ(profiles.proof().prints, nullptr);
}

TEST_F(ProfileControllerTest, WhatWasKeptIsThereAgainAsItWas) {
  DisplayColours kept;
  kept.source = Source::file;
  kept.displayFile = fileOf("mine.icc", wideDisplay());
  kept.printerFile = fileOf("paper.icc", test::palePrinterProfile());
  ProfileController profiles(kept, wakes.callback());
  profiles.start("");
  EXPECT_EQ(until(profiles, [&] { return profiles.displayCube() && profiles.knowsPrinter(); }), "");
  EXPECT_FALSE(profiles.colours().proofs) << "the proof was off";
}

/// The window may be slower than the disk.
TEST_F(ProfileControllerTest, AllThatWereKeptAreThereThoughNobodyLookedMeanwhile) {
  DisplayColours kept;
  kept.displayFile = fileOf("mine.icc", wideDisplay());
  kept.printerFile = fileOf("paper.icc", test::palePrinterProfile());
  std::atomic<int> came = 0;
  ProfileController profiles(kept, [&, wake = wakes.callback()] {
    ++came;
    wake();
  });
  profiles.start(wideDisplay());
  ASSERT_TRUE(wakes.until([&] { return came == 3; }));
  EXPECT_EQ(profiles.follow(), std::nullopt);
  const ProfileNames names = profiles.names();
  EXPECT_NE(names.system, "");
  EXPECT_NE(names.display, "");
  EXPECT_NE(names.printer, "");
}

TEST_F(ProfileControllerTest, EachThatIsGoneIsSaid) {
  DisplayColours kept;
  kept.displayFile = folder.file("gone.icc");
  kept.printerFile = folder.file("gone too.icc");
  std::atomic<int> came = 0;
  ProfileController profiles(kept, [&, wake = wakes.callback()] {
    ++came;
    wake();
  });
  profiles.start("");
  ASSERT_TRUE(wakes.until([&] { return came == 2; }));
  EXPECT_NE(profiles.follow().value_or("").find("gone.icc"), std::string::npos);
  EXPECT_NE(profiles.follow().value_or("").find("gone too.icc"), std::string::npos);
}

TEST_F(ProfileControllerTest, WhatCannotBeUsedIsSaidAndChangesNothing) {
  ProfileController profiles(DisplayColours{}, wakes.callback());
  profiles.start("no profile at all");
  const std::string file = fileOf("broken.icc", wideDisplay().substr(0, 200));
  profiles.open(file);
  const std::string problem = until(profiles, [] { return false; });
  EXPECT_NE(problem.find("broken.icc"), std::string::npos) << problem;
  EXPECT_EQ(profiles.displayCube(), nullptr);
  EXPECT_EQ(profiles.colours().source, Source::system);
  EXPECT_EQ(profiles.colours().displayFile, "");
}

/// A kept profile may lie on a disk that has gone to sleep.
TEST_F(ProfileControllerTest, WhatIsChosenStaysThoughWhatWasKeptIsReadLater) {
  DisplayColours kept;
  kept.displayFile = fileOf("kept.icc", wideDisplay());
  kept.printerFile = fileOf("kept paper.icc", test::palePrinterProfile());
  std::latch awake(1);
  ProfileController profiles(kept, wakes.callback(), [&](const std::string& file) {
    if (file == kept.displayFile || file == kept.printerFile) awake.wait();
    return readIccProfile(file);
  });
  profiles.start("");
  const std::string display = fileOf("mine.icc", wideDisplay());
  profiles.open(display);
  EXPECT_EQ(until(profiles, [&] { return profiles.displayCube() != nullptr; }), "");
  const auto mine = profiles.displayCube();
  awake.count_down();
  EXPECT_EQ(until(profiles, [&] { return profiles.knowsPrinter(); }), "") << "no printer was chosen instead";
  EXPECT_EQ(profiles.colours().displayFile, display);
  EXPECT_EQ(profiles.displayCube(), mine);
}

}  // namespace
}  // namespace loomlight
