#include "core/fabric/model/changes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <utility>
#include <vector>

#include "core/fabric/weave/structures.h"

namespace loomlight {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Two yarns of one shape and two colours, a third of another shape; warp of the first, weft of the second.
Fabric base() {
  Fabric f;
  f.weave = twill(2, 2);
  f.fibres.resize(3);
  f.fibres[1].absorption_per_mm = Rgb(10.0f);
  f.yarns.resize(3);
  f.yarns[1].fibre = 1;
  f.yarns[1].name = "dark";
  f.yarns[2].fibre = 2;
  f.yarns[2].count_tex = 60;
  f.weftSequence = {1};
  return f;
}

Changes of(const std::function<void(Fabric&)>& edit) {
  const Fabric before = base();
  Fabric after = before;
  edit(after);
  return changes(before, after);
}

/// Without labels, which make nothing.
Stages stagesOf(const std::function<void(Fabric&)>& edit) {
  return of(edit).stages - Stage::label;
}

TEST(Changes, NothingFromNothing) {
  EXPECT_EQ(of([](Fabric&) {}).stages, Stages());
  const Changes labels = of([](Fabric& f) {
    f.name = "other";
    f.description = "words";
    f.yarns[0].name = "words";
    f.fibres[0].name = "words";
  });
  EXPECT_EQ(labels.stages, Stages(Stage::label));
  EXPECT_FALSE(labels.picture());
}

// What an edit may leave: the promises of a quick answer, beside field_tables.h and not read from there. Exposure, tone
// curve and overlays are no part of a fabric.
TEST(Changes, TouchNoMoreThanTheyMust) {
  const std::vector<std::pair<Stages, std::function<void(Fabric&)>>> rows = {
      {Stage::camera, [](Fabric& f) { f.camera.azimuth_deg += 10; }},
      {Stage::light, [](Fabric& f) { f.light.azimuth_deg += 10; }},
      {Stage::brightness, [](Fabric& f) { f.light.intensity = 3; }},
      {Stage::brightness, [](Fabric& f) { f.light.temperature_K = 2700; }},
      {Stage::colour, [](Fabric& f) { f.fibres[0].absorption_per_mm = Rgb(3.0f); }},
      {Stage::optics, [](Fabric& f) { f.fibres[0].refractiveIndex = 1.4; }},
      {Stage::optics, [](Fabric& f) { f.fibres[0].longitudinalRoughness = 0.1; }},
      {Stage::optics, [](Fabric& f) { f.fibres[0].azimuthalRoughness = 0.1; }},
      {Stage::optics, [](Fabric& f) { f.fibres[0].scaleTilt_deg = 3; }},
      {Stage::optics, [](Fabric& f) { f.fibres[0].section = FibreSection::trilobal; }},
      {Stage::optics, [](Fabric& f) { f.render.method = Method::fibres; }},
      {Stage::optics, [](Fabric& f) { f.render.estimator = Estimator::none; }},
      {Stage::optics, [](Fabric& f) { f.render.eventLaw = EventLaw::report; }},
      {Stage::drape, [](Fabric& f) { f.drape.kind = DrapeKind::sphere; }},
      {Stage::drape, [](Fabric& f) { f.drape.width_mm = 7; }},
      {Stage::drape, [](Fabric& f) { f.drape.grain_deg = 45; }},
      {Stage::grid, [](Fabric& f) { f.ends_per_cm = 30; }},
      {Stage::grid, [](Fabric& f) { f.picks_per_cm = 30; }},
      {Stage::grid, [](Fabric& f) { f.render.resolution = 4; }},
      {Stage::sampling, [](Fabric& f) { f.render.seed = 7; }},
      {Stage::sampling, [](Fabric& f) { f.render.maxDepth = 3; }},
      {Stages(), [](Fabric& f) { f.render.samplesPerPixel *= 2; }},  // more samples of the same picture
  };
  for (size_t i = 0; i < rows.size(); ++i) EXPECT_EQ(stagesOf(rows[i].second), rows[i].first) << "row " << i;
}

TEST(Changes, ColourSequenceTouchesNoVoxel) {
  const Changes found = of([](Fabric& f) { f.warpSequence = {0, 0, 1}; });
  EXPECT_EQ(found.stages, Stages(Stage::thread));
  EXPECT_TRUE(found.picture() && found.cloth() && !found.voxels());
}

TEST(Changes, SequenceOfYarnsOfOtherShapesMovesBricks) {
  const Changes found = of([](Fabric& f) { f.warpSequence = {0, 0, 2}; });
  EXPECT_EQ(found.stages, Stage::thread | Stage::shape);
  EXPECT_TRUE(found.crossings);
  EXPECT_THAT(found.yarns, IsEmpty());
}

TEST(Changes, SpacingMovesEveryThread) {
  const Changes found = of([](Fabric& f) { f.warpSpacing = {1, 2}; });
  EXPECT_EQ(found.stages, Stages(Stage::grid));
  EXPECT_TRUE(found.picture() && found.voxels());
}

TEST(Changes, SequencesThatSayTheSameAreTheSame) {
  EXPECT_EQ(stagesOf([](Fabric& f) { f.warpSequence = {0, 0, 0}; }), Stages());
  Fabric a = base();
  a.warpSequence = {0, 1};
  Fabric b = a;
  b.warpSequence = {0, 1, 0, 1, 0, 1};
  EXPECT_EQ(changes(a, b).stages, Stages());
  b.warpSequence = {0, 1, 0, 1, 0};
  EXPECT_EQ(changes(a, b).stages, Stages(Stage::thread)) << "equal on their common length, but not beyond";
}

TEST(Changes, YarnShapeRebuildsItsOwnBricks) {
  for (const auto& edit : std::vector<std::function<void(Fabric&)>>{[](Fabric& f) { f.yarns[1].plyTwist_per_m += 100; },
                                                                    [](Fabric& f) { f.fibres[1].density_g_cm3 = 1.3; },
                                                                    [](Fabric& f) { f.fibres[1].radius_um = 9; }}) {
    const Changes found = of(edit);
    EXPECT_EQ(found.stages, Stages(Stage::shape));
    EXPECT_THAT(found.yarns, ElementsAre(1));
    EXPECT_FALSE(found.crossings);
  }
}

TEST(Changes, WhatADyeIsCalledColoursNothing) {
  Fabric before = base(), after = before;
  before.fibres[0].absorption_per_mm.dyes = after.fibres[0].absorption_per_mm.dyes = {Dyestuff{}};
  after.fibres[0].absorption_per_mm.dyes[0].name = "madder";
  EXPECT_EQ(changes(before, after).stages, Stages(Stage::label));
  after.fibres[0].absorption_per_mm.dyes[0].amount_percent = 2;
  EXPECT_EQ(changes(before, after).stages, Stage::label | Stage::colour);
  after.fibres[0].absorption_per_mm.dyes.clear();
  EXPECT_EQ(changes(before, after).stages, Stages(Stage::colour));
}

TEST(Changes, OfOpticsNameTheirFibres) {
  EXPECT_THAT(of([](Fabric& f) { f.fibres[1].scaleTilt_deg = 3; }).fibres, ElementsAre(1));
  EXPECT_THAT(of([](Fabric& f) { f.fibres[0].absorption_per_mm = Rgb(3); }).fibres, IsEmpty());
  const auto another = [](Fabric& f) { f.fibres.emplace_back(); };
  EXPECT_THAT(of(another).fibres, ElementsAre(3));
  EXPECT_EQ(stagesOf(another), Stages(Stage::optics));
  EXPECT_EQ(stagesOf([](Fabric& f) { f.yarns.emplace_back(); }), Stages(Stage::optics));
}

TEST(Changes, ABlendOfLikeFibresTouchesNoVoxel) {
  EXPECT_EQ(stagesOf([](Fabric& f) { f.yarns[0].fibre = 1; }), Stages(Stage::optics)) << "of another colour";
  EXPECT_EQ(stagesOf([](Fabric& f) { f.yarns[0].blendFibre = 1; }), Stages(Stage::optics));
  Fabric blended = base();
  blended.yarns[0].blendFibre = 1;
  Fabric more = blended;
  more.yarns[0].blendShare = 0.5;
  EXPECT_FALSE(changes(blended, more).picture()) << "as much as where nothing is said";
  more.yarns[0].blendShare = 0.6;
  EXPECT_EQ(changes(blended, more).stages, Stages(Stage::optics));
  blended.fibres[1].radius_um = more.fibres[1].radius_um = 9;
  EXPECT_THAT(changes(blended, more).yarns, ElementsAre(0)) << "fewer, thicker fibres make the same mass";
}

TEST(Changes, AnUnusedShareAndOtherColourwaysAreNothing) {
  EXPECT_EQ(stagesOf([](Fabric& f) { f.yarns[0].blendShare = 0.1; }), Stages());
  EXPECT_EQ(stagesOf([](Fabric& f) { f.colourways.resize(3); }), Stages());
}

TEST(Changes, OfWhatAYarnDoesNotUseAreNone) {
  EXPECT_FALSE(of([](Fabric& f) { f.yarns[0].yarnTwist_per_m = 300; }).picture()) << "a single has no plies to twist";
  EXPECT_FALSE(of([](Fabric& f) { f.yarns[0].cableTwist_per_m = 300; }).picture()) << "it is no cable";
  EXPECT_FALSE(of([](Fabric& f) { f.yarns[0].hairLength_mm = 1; }).picture()) << "it has no hairs";
  EXPECT_FALSE(of([](Fabric& f) { f.yarns[0].slubRatio = 3; }).picture()) << "it has no slubs";
  EXPECT_FALSE(of([](Fabric& f) { f.yarns[0].yarnTwistDirection = TwistDirection::z; }).picture()) << "nor a twist";
  EXPECT_FALSE(of([](Fabric& f) { f.yarns[2].count_tex = 70; }).picture()) << "no thread uses it";
  Fabric counted = base();
  counted.yarns[0].fibresPerPly = 100;
  Fabric other = counted;
  other.yarns[0].count_tex = 99;
  EXPECT_FALSE(changes(counted, other).picture()) << "its count follows from the fibres";
  other.fibres[0].density_g_cm3 = 1.3;
  EXPECT_THAT(changes(counted, other).yarns, ElementsAre(0)) << "it has the same fibres, lighter: so is the cloth";
}

TEST(Changes, OneCrossingMovesBricksWhoseKeyChanges) {
  const auto turn = [](Fabric& f) { f.weave = f.weave.with(1, 2, !f.weave.at(1, 2)); };
  const Changes found = of(turn);
  EXPECT_EQ(found.stages, Stages(Stage::shape));
  EXPECT_TRUE(found.crossings && found.crossingsAlone());
  EXPECT_THAT(found.yarns, IsEmpty());
  const std::vector<std::function<void(Fabric&)>> others = {[](Fabric& f) { f.fibres[0].absorption_per_mm = Rgb(3); },
                                                            [](Fabric& f) { f.camera.distance_mm += 1; },
                                                            [](Fabric& f) { f.yarns[0].plyTwist_per_m += 50; },
                                                            [](Fabric& f) { f.light.intensity = 2; },
                                                            [](Fabric& f) { f.warpSequence = {0, 2}; },
                                                            [](Fabric& f) { f.weftSpacing = {1, 2}; },
                                                            [](Fabric& f) { f.ends_per_cm += 1; }};
  for (const auto& other : others) {
    EXPECT_FALSE(of(other).crossingsAlone());
    EXPECT_FALSE(of([&](Fabric& f) {
                   turn(f);
                   other(f);
                 }).crossingsAlone());
  }
}

// Making fibres takes seconds, so looking from elsewhere or recolouring must not; but no medium may serve a cloth that
// it was not made of.
TEST(Changes, LightCameraAndColourLeaveTheMedium) {
  EXPECT_FALSE(of([](Fabric& f) { f.camera.azimuth_deg += 10; }).medium());
  EXPECT_FALSE(of([](Fabric& f) { f.light.kind = LightKind::dome; }).medium());
  EXPECT_FALSE(of([](Fabric& f) { f.light.intensity = 2; }).medium());
  EXPECT_FALSE(of([](Fabric& f) { f.fibres[0].absorption_per_mm = Rgb(3.0f); }).medium());
  EXPECT_FALSE(of([](Fabric& f) { f.render.seed = 7; }).medium());
  EXPECT_TRUE(of([](Fabric& f) { f.fibres[0].refractiveIndex = 1.4; }).medium());
  EXPECT_TRUE(of([](Fabric& f) { f.yarns[0].packing = 0.4; }).medium());
  EXPECT_TRUE(of([](Fabric& f) { f.yarns[0].fibre = 1; }).medium());
  EXPECT_TRUE(of([](Fabric& f) { f.warpSequence = {0, 1}; }).medium());
  EXPECT_TRUE(of([](Fabric& f) { f.drape.width_mm = 3; }).medium());
  EXPECT_TRUE(of([](Fabric& f) { f.drape.kind = DrapeKind::sphere; }).medium());
  EXPECT_TRUE(of([](Fabric& f) { f.render.method = Method::fibres; }).medium());
  EXPECT_TRUE(of([](Fabric& f) { f.render.estimator = Estimator::none; }).medium());
  EXPECT_TRUE(of([](Fabric& f) { f.render.eventLaw = EventLaw::report; }).medium());
}

TEST(Changes, HeadlightMovesWithTheCamera) {
  Fabric before = base();
  before.light.kind = LightKind::headlight;
  Fabric after = before;
  after.camera.distance_mm *= 2;
  EXPECT_EQ(changes(before, after).stages, Stage::camera | Stage::light);
  after = before;
  after.camera.fov_deg = 35;
  EXPECT_EQ(changes(before, after).stages, Stages(Stage::camera));
  after = before;
  after.camera.distance_mm *= 2;
  before.light.kind = after.light.kind = LightKind::sky;
  EXPECT_EQ(changes(before, after).stages, Stages(Stage::camera));
}

}  // namespace
}  // namespace loomlight
