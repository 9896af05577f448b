#include "render/transport/reached_colours.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/fabric/weave/structures.h"
#include "core/fabric/yarn/yarn_reflectance.h"
#include "render/transport/make_medium.h"
#include "tests/support/test_cloth.h"

namespace loomlight {
namespace {

constexpr size_t kFewWalks = 256;

/// White, and a second yarn that is dyed dark red, in a plain weave.
Fabric whiteAndRed() {
  Fabric fabric = test::whiteCotton();
  fabric.yarns.push_back(fabric.yarns[0]);
  fabric.yarns[1].fibre = 1;
  fabric.fibres.push_back(fabric.fibres[0]);
  fabric.fibres[1].absorption_per_mm = Rgb(4.0f, 150.0f, 180.0f);
  fabric.weftSequence = {1};
  fabric.ends_per_cm = fabric.picks_per_cm = 30;
  fabric.render.resolution = 2;
  return fabric;
}

std::vector<Rgb> reachedBy(const Fabric& fabric) {
  return *reachedColours(fabric, Task{}, kFewWalks);
}

// By a tenth and more, known to 0.7 % of white; in coarse voxels it would be too bright.
TEST(ReachedColours, ADarkRedIsDarkerThanItsDyeInAThickMass) {
  Fabric fabric = whiteAndRed();
  fabric.render.resolution = 8;
  const std::vector<Rgb> reached = *reachedColours(fabric, Task{}, kChipPaths);
  ASSERT_EQ(reached.size(), 2u);
  EXPECT_LT(reached[1].r, yarnReflectance(fabric, fabric.yarns[1]).r - 4 * 0.007f);
  EXPECT_GT(reached[0].g, 2 * reached[1].g);
}

TEST(ReachedColours, FollowTheLamp) {
  Fabric fabric = whiteAndRed();
  const std::vector<Rgb> day = reachedBy(fabric);
  fabric.light.illuminant = StandardIlluminant::f11;
  const std::vector<Rgb> shop = reachedBy(fabric);
  EXPECT_GT(glm::length(shop[1] - day[1]), 0.01f);
  fabric.light = Light{};
  fabric.light.kind = LightKind::back;
  EXPECT_EQ(reachedBy(fabric), day) << "where the lamps stand is no matter of a chip";
}

TEST(ReachedColours, AYarnThatTheFaceNeverShowsHasThatOfPlainClothOfItAlone) {
  Fabric fabric = whiteAndRed();
  fabric.weftSequence = {0};
  Fabric alone = fabric;
  alone.warpSequence = alone.weftSequence = {1};
  const Rgb unused = reachedBy(fabric)[1], plain = reachedBy(alone)[1];
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(unused[c], plain[c], 0.03);
  EXPECT_GT(unused.r, 3 * unused.g);
}

TEST(ReachedColours, FindARareStripeOfAWideOrder) {
  for (const int place : {0, 100, 200, 300}) {
    Fabric fabric = whiteAndRed();
    fabric.weave = satin(8, 3);
    fabric.weftSequence = {0};
    fabric.warpSequence.assign(400, 0);
    std::fill_n(fabric.warpSequence.begin() + place, 20, 1);
    const auto scene = test::sceneOf(colourPatch(fabric));
    const auto medium = makeMedium(*scene, defaultMemoryLimit_bytes(), Task{});
    const auto paths = tallyYarns(*scene, *medium, kFewWalks, Task{});
    EXPECT_GE((*paths)[1].count, kFewWalks) << "of threads from " << place;
  }
}

TEST(ReachedColours, ASheerWhiteIsCalledWhiteThoughBlackShinesThrough) {
  Fabric fabric = whiteAndRed();
  fabric.weftSequence = {0};
  fabric.ends_per_cm = fabric.picks_per_cm = 12;
  const auto paths = *tracePathsToYarns(fabric, kFewWalks, Task{});
  const std::vector<Rgb> reached = reachedColours(paths, colouringOf(fabric));
  EXPECT_LT(reached[0].g, 0.6f);
  const std::vector<Rgb> called = coloursForNames(paths, reached);
  for (int c = 0; c < 3; ++c) EXPECT_GT(called[0][c], 0.95f);
  EXPECT_GT(called[1].r, 3 * called[1].g) << "red stays red";
}

TEST(ReachedColours, AreStopped) {
  std::stop_source stop;
  stop.request_stop();
  Task task;
  task.stop = stop.get_token();
  EXPECT_FALSE(reachedColours(whiteAndRed(), task));
}

}  // namespace
}  // namespace loomlight
