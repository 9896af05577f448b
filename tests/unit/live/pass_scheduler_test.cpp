#include "app/live/pass_scheduler.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace loomlight {
namespace {

/// Plays the scheduler against a machine that traces a path in `secondsPerPath`.
std::vector<PassPlan> play(int width, int height, double secondsPerPath, uint32_t wanted, bool known,
                           bool waitsForFibres = false) {
  PassHistory history{width, height};
  history.waitsForFibres = waitsForFibres;
  if (known) history.secondsPerPath = secondsPerPath;
  std::vector<PassPlan> plans;
  while (plans.size() < 10000) {
    const PassPlan plan = nextPass(history, wanted);
    if (plan.samples == 0) break;
    plans.push_back(plan);
    const int columns = width / plan.divider, rows = height / plan.divider;
    const double paths = static_cast<double>(columns) * rows * (plan.divider == 1 ? plan.samples - history.samples : 1);
    history.seconds += paths * secondsPerPath;
    history.secondsPerPath = secondsPerPath;
    history.divider = plan.divider;
    history.coarseSamples = plan.divider > 1 ? plan.samples : 0;
    if (plan.divider == 1) history.samples = plan.samples;
  }
  return plans;
}

TEST(PassScheduler, FirstPictureIsQuick) {
  for (const double secondsPerPath : {1e-6, 5e-6, 2e-5}) {
    const PassPlan first = nextPass({800, 600, secondsPerPath}, 64);
    const double seconds = 800.0 * 600 / (first.divider * first.divider) * secondsPerPath;
    EXPECT_LE(seconds, 0.025) << secondsPerPath;
    if (first.divider > 1) {
      EXPECT_GT(seconds, 0.015) << "coarser than need be: " << secondsPerPath;
    }
  }
}

TEST(PassScheduler, BeginsNoCoarserThanIsLegible) {
  PassHistory slow{800, 600, 1e-3};
  EXPECT_GT(nextPass(slow, 64).divider, 8);
  slow.first.coarsest = 8;
  slow.first.patience_s = 10;
  EXPECT_EQ(nextPass(slow, 64), (PassPlan{8, 1}));
}

TEST(PassScheduler, IsCoarserThanIsLegibleRatherThanSlow) {
  constexpr double kPerPath_s = 1e-5, kAtMost_s = 0.1;
  for (const int height : {600, 1080, 2160}) {
    const int width = 16 * height / 9;
    PassHistory history{width, height, kPerPath_s};
    history.first.coarsest = 12;
    history.first.patience_s = kAtMost_s;
    const auto seconds = [&](int divider) {
      const int columns = width / divider, rows = height / divider;
      return kPerPath_s * columns * rows;
    };
    const int divider = nextPass(history, 64).divider;
    EXPECT_GE(divider, 12);
    EXPECT_LE(seconds(divider), kAtMost_s) << width;
    if (divider > 12) {
      EXPECT_GT(seconds(divider - 1), 0.9 * kAtMost_s) << "coarser than need be: " << width;
    }
  }
}

TEST(PassScheduler, DividesAFirstPassSoThatAFinerPictureHasWholePixels) {
  for (const double secondsPerPath : {1e-8, 1e-6, 7e-6, 3e-5, 1e-3}) {
    PassHistory history{799, 601, secondsPerPath};
    const int alone = nextPass(history, 64).divider;
    history.first.finer = 3;
    const int divider = nextPass(history, 64).divider;
    EXPECT_GE(divider, alone);
    EXPECT_LT(divider, alone + 3);
    EXPECT_TRUE(divider == 1 || divider % 3 == 0) << divider;
  }
}

TEST(PassScheduler, RefinesStepByStepAndStops) {
  const auto plans = play(800, 600, 5e-6, 256, false);
  ASSERT_FALSE(plans.empty());
  for (size_t i = 1; i < plans.size(); ++i) {
    EXPECT_LE(plans[i].divider, plans[i - 1].divider);
    if (plans[i].divider == plans[i - 1].divider) {
      EXPECT_GT(plans[i].samples, plans[i - 1].samples);
    }
  }
  EXPECT_EQ(plans.back(), (PassPlan{1, 256}));
}

TEST(PassScheduler, CoarsePassesCostLittle) {
  for (const double secondsPerPath : {1e-7, 1e-6, 3e-6, 1e-5}) {
    double coarse = 0;  // in units of a full pass of one sample
    for (const PassPlan& plan : play(1600, 900, secondsPerPath, 8, true))
      if (plan.divider > 1) coarse += 1.0 / (plan.divider * plan.divider);
    EXPECT_LT(coarse, 1.0 / 3) << secondsPerPath;
  }
}

// Two of them for every pixel, and then the picture is traced as any other.
TEST(PassScheduler, CoarsePathsComeFirstWhereOthersWaitForFibres) {
  for (const double secondsPerPath : {2e-6, 3e-6, 1e-5}) {
    const auto plans = play(640, 480, secondsPerPath, 64, true, true), usual = play(640, 480, secondsPerPath, 64, true);
    double paths = 0, most = 0;  // for each pixel at full resolution
    for (const PassPlan& plan : plans) {
      if (plan.divider == 1) break;
      EXPECT_TRUE(plan.samples == 1 || plan.divider < 4) << "at a coarseness that is not the last";
      const double own = 1.0 / (plan.divider * plan.divider);
      paths += own;
      most = std::max(most, own);
    }
    EXPECT_GE(paths, 2);
    EXPECT_LT(paths, 2 + 1.0 / 3 + most);
    const auto isFine = [](const PassPlan& plan) { return plan.divider == 1; };
    const auto first = std::ranges::find_if(plans, isFine), usualFirst = std::ranges::find_if(usual, isFine);
    EXPECT_EQ(*first, *usualFirst);
    EXPECT_EQ(plans.back(), usual.back());
  }
}

TEST(PassScheduler, PassesStayShortEnoughToBeInterrupted) {
  const double secondsPerPath = 2e-6;
  uint32_t before = 0;
  for (const PassPlan& plan : play(640, 480, secondsPerPath, 1024, true)) {
    if (plan.divider > 1) continue;
    EXPECT_LE((plan.samples - before) * 640.0 * 480 * secondsPerPath, 1.1);
    before = plan.samples;
  }
}

TEST(PassScheduler, SurvivesOddSizes) {
  for (const int side : {1, 2, 3, 17, 16384})
    for (const double seconds : {0.0, 1e-9, 1.0}) {
      const PassPlan plan = nextPass({side, 1, seconds}, 1);
      EXPECT_GE(plan.divider, 1);
      EXPECT_EQ(plan.samples, 1u);
    }
}

TEST(HitsWanted, NoneBeforeTheFirstPassThenMoreWithEverySample) {
  PassHistory history;
  EXPECT_EQ(hitsWanted(history), 0u);
  uint32_t before = 0;
  for (const int divider : {16, 8, 4, 2, 1}) {
    history.divider = divider;
    EXPECT_GE(hitsWanted(history), std::max(1u, before));
    before = hitsWanted(history);
  }
  for (history.samples = 1; history.samples < 8; ++history.samples) {
    EXPECT_GE(hitsWanted(history), before);
    before = hitsWanted(history);
  }
  EXPECT_EQ(before, 16u);
}

TEST(HitsWanted, MoreWithCoarsePaths) {
  PassHistory history;
  history.divider = 3;
  uint32_t before = 0;
  for (history.coarseSamples = 1; history.coarseSamples <= 18; ++history.coarseSamples) {
    EXPECT_GE(hitsWanted(history), before);
    EXPECT_LE(hitsWanted(history), before + 1) << "a round at a time";
    before = hitsWanted(history);
  }
  EXPECT_GE(before, 6u);
  EXPECT_LE(before, 16u);
}

TEST(NextSubject, WhatCannotBeSeenYetComesFirstAndThePictureBeforeTheInset) {
  EXPECT_EQ(nextSubject({true, 0, 0}, {true, 0, 0}), Subject::picture);
  EXPECT_EQ(nextSubject({true, 8, 0.1}, {true, 0, 9}), Subject::inset);
  EXPECT_EQ(nextSubject({true, 0, 9}, {true, 8, 0}), Subject::picture);
}

TEST(NextSubject, WhatIsCoarseComesBeforeWhatIsFine) {
  EXPECT_EQ(nextSubject({true, 1, 0}, {true, 4, 9}), Subject::inset);
  EXPECT_EQ(nextSubject({true, 4, 9}, {true, 1, 0}), Subject::picture);
}

TEST(NextSubject, OneThatWantsNothingLeavesAllPassesToTheOther) {
  EXPECT_EQ(nextSubject({false, 1, 0}, {true, 1, 9}), Subject::inset);
  EXPECT_EQ(nextSubject({true, 1, 9}, {false, 1, 0}), Subject::picture);
  EXPECT_EQ(nextSubject({true, 1, 9}, {}), Subject::picture);
  EXPECT_EQ(nextSubject({}, {}), Subject::none);
}

// However long their passes are, neither is ever more than one of them ahead of the other.
TEST(NextSubject, BothGetTheSameTime) {
  constexpr double kPicturePass = 1.0, kInsetPass = 0.13;
  Contender picture{true, 1, 0}, inset{true, 1, 0};
  for (int i = 0; i < 200; ++i) {
    (nextSubject(picture, inset) == Subject::inset ? inset.spent_s += kInsetPass : picture.spent_s += kPicturePass);
    EXPECT_LE(picture.spent_s - inset.spent_s, kPicturePass + 1e-9);
    EXPECT_LE(inset.spent_s - picture.spent_s, kInsetPass + 1e-9);
  }
}

}  // namespace
}  // namespace loomlight
