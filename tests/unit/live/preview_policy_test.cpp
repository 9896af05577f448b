#include "app/live/preview_policy.h"

#include <gtest/gtest.h>

#include <vector>

#include "app/live/pass_scheduler.h"
#include "render/display/preview_quality.h"

namespace loomlight {
namespace {

Changes of(Stages stages) {
  Changes changes;
  changes.stages = stages;
  return changes;
}

/// A machine of fake clock: it traces a path in `secondsPerPath`, and its picture has 1280 x 720 pixels.
struct Machine {
  double secondsPerPath;
  double now_s = 0;

  double secondsOf(const PassPlan& plan, uint32_t before) const {
    const double paths = 1280.0 * 720 / (plan.divider * plan.divider);
    return secondsPerPath * paths * (plan.divider == 1 ? plan.samples - before : 1);
  }
  /// The dividers of the passes of a picture, until it has so many samples.
  std::vector<int> play(const PreviewStart& start, uint32_t samples) {
    PassHistory history;
    history.width = 1280;
    history.height = 720;
    history.secondsPerPath = start.knowsCost ? secondsPerPath : 0;
    history.divider = start.reached;
    history.first = start.first;
    const double begun_s = now_s;
    std::vector<int> dividers;
    while (history.samples < samples) {
      history.seconds = now_s - begun_s;
      const PassPlan plan = nextPass(history, samples);
      now_s += secondsOf(plan, history.samples);
      history.secondsPerPath = secondsPerPath;
      history.divider = plan.divider;
      if (plan.divider == 1) history.samples = plan.samples;
      dividers.push_back(plan.divider);
    }
    return dividers;
  }
};

constexpr double kSlow_s = 5e-6, kQuick_s = 1e-8;  // for a path

TEST(PreviewStart, GoesOnWhereABetterMediumHasCome) {
  PreviewHave have{true, true, 4, of({}), of({})};
  const PreviewStart start = previewStart(have);
  EXPECT_EQ(start.reached, 4);
  EXPECT_EQ(Machine{kSlow_s}.play(start, 1), (std::vector<int>{2, 1})) << "nothing coarser than what is there";
  have.divider = 1;
  EXPECT_EQ(Machine{kSlow_s}.play(previewStart(have), 1), (std::vector<int>{1}));
  have.sameRequest = false;
  EXPECT_EQ(previewStart(have).reached, 0) << "the picture there is of something else";
}

TEST(PreviewStart, IsLegibleFromWhereItWasSeenBefore) {
  const PreviewHave have{false, true, 1, of(Stage::shape), of(Stage::shape)};
  Machine machine{kSlow_s};
  const int first = machine.play(previewStart(have), 1).front();
  EXPECT_LE(first, 9) << "coarser ones say nothing of the weave";
  EXPECT_EQ(first % previewStart(have).first.finer, 0) << "known light is seen in so many times its pixels";
  EXPECT_LE(machine.secondsOf({first, 1}, 0), 0.3) << "the first pass cannot be stopped";
  EXPECT_EQ(Machine{kQuick_s}.play(previewStart(have), 1), (std::vector<int>{1})) << "no coarser than need be";
}

TEST(PreviewStart, FollowsAMovingCamera) {
  const PreviewHave have{false, true, 1, of(Stage::camera), of(Stage::camera)};
  const PreviewStart start = previewStart(have);
  EXPECT_TRUE(start.knowsCost);
  for (const double secondsPerPath : {1e-7, 1e-6, kSlow_s, 3e-5}) {
    Machine machine{secondsPerPath};
    const int first = machine.play(start, 1).front();
    EXPECT_LE(machine.secondsOf({first, 1}, 0), 0.1) << "the first pass cannot be stopped";
  }
  EXPECT_LE(Machine{1e-6}.play(start, 1).front(), 12);
  EXPECT_GT(start.first.finer, 1) << "the light of the view before is known";
}

TEST(PreviewStart, KnowsNothingOfAnotherDrape) {
  const PreviewStart start = previewStart({false, true, 1, of(Stage::drape), of(Stage::drape)});
  EXPECT_FALSE(start.knowsCost);
  EXPECT_GT(Machine{kSlow_s}.play(start, 1).front(), 12) << "quick first, until the cost has been measured";
  EXPECT_FALSE(previewStart({}).knowsCost) << "nor of the first of all";
}

TEST(PreviewStart, OfAnotherSizeIsNoViewSeenBefore) {
  const PreviewHave have{false, false, 1, of({}), of({})};
  EXPECT_EQ(previewStart(have).first.coarsest, 12);
}

TEST(ClearHelp, IsThePictureWhereItIsTheSame) {
  const PreviewSize size{640, 480, 8, 8};
  EXPECT_EQ(clearHelp(of({}), size, size), ClearHelp::patched);
  Changes turned = of(Stage::shape);
  turned.crossings = true;
  EXPECT_EQ(clearHelp(turned, size, size), ClearHelp::patched);
  EXPECT_EQ(clearHelp(turned, size, {640, 480, 8, 9}), ClearHelp::none) << "threads have other numbers";
  EXPECT_EQ(clearHelp(turned, size, {600, 480, 8, 8}), ClearHelp::none);
  turned.yarns = {0};
  EXPECT_EQ(clearHelp(turned, size, size), ClearHelp::none);
  for (const Stage stage : {Stage::grid, Stage::thread, Stage::drape, Stage::optics, Stage::colour, Stage::brightness,
                            Stage::light, Stage::camera, Stage::sampling})
    EXPECT_EQ(clearHelp(of(stage), size, size), ClearHelp::none) << static_cast<int>(stage);
}

TEST(ClearHelp, IsReframedButNoBlur) {
  const PreviewSize size{640, 480, 8, 8};
  EXPECT_EQ(clearHelp(of({}), size, {300, 480, 8, 8}), ClearHelp::reframed);
  EXPECT_EQ(clearHelp(of(Stage::label), size, {640, 600, 8, 8}), ClearHelp::reframed);
  EXPECT_EQ(clearHelp(of({}), size, {640, 601, 8, 8}), ClearHelp::none) << "stretched by more than a quarter";
  EXPECT_EQ(clearHelp(of(Stage::camera), size, {300, 480, 8, 8}), ClearHelp::none);
}

TEST(ClearHelp, EndsWhereThePictureIsAsClear) {
  EXPECT_TRUE(wantsHelp(0, 1));
  EXPECT_TRUE(wantsHelp(kClearSamples - 1, 1000));
  EXPECT_FALSE(wantsHelp(kClearSamples, 1000));
  EXPECT_FALSE(wantsHelp(3, 3));
}

TEST(IsOnlyMoved, WhereTheCameraAloneIsAnother) {
  EXPECT_TRUE(isOnlyMoved(of(Stage::camera)));
  EXPECT_TRUE(isOnlyMoved(of(Stage::camera | Stage::label)));
  EXPECT_FALSE(isOnlyMoved(of({})));
  EXPECT_FALSE(isOnlyMoved(of(Stage::camera | Stage::light)));
  EXPECT_FALSE(isOnlyMoved(of(Stage::camera | Stage::drape)));
}

TEST(Supersedes, DyedPicturesThatHaveNoLessNoise) {
  const RecolouredPicture recoloured{64, false, 0.1};
  EXPECT_FALSE(supersedes(8, 0.11, recoloured));
  EXPECT_TRUE(supersedes(8, 0.1, recoloured));
  EXPECT_FALSE(supersedes(3, 0.01, recoloured)) << "too few to know a variance by";
  EXPECT_TRUE(supersedes(64, 9, recoloured)) << "of as many samples";
  EXPECT_FALSE(supersedes(63, 0.01, {64, true, 0.1})) << "with an earlier picture in it";
}

}  // namespace
}  // namespace loomlight
