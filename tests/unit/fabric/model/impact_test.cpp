#include "core/fabric/model/impact.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

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

Impact of(const std::function<void(Fabric&)>& edit) {
  const Fabric before = base();
  Fabric after = before;
  edit(after);
  const Impact found = impact(before, after);
  EXPECT_EQ(sameCloth(before, after), !found.cloth());
  return found;
}

TEST(Impact, NothingFromNothing) {
  EXPECT_TRUE(of([](Fabric&) {}).nothing());
  EXPECT_TRUE(of([](Fabric& f) {
                f.name = "other";
                f.description = "words";
                f.yarns[0].name = "words";
                f.fibres[0].name = "words";
              }).nothing());
}

// The rows of the table in DESIGN section 3. Exposure, tone curve and overlays are no part of a fabric.

TEST(Impact, CameraAndLightRestartTheFilmOnly) {
  const Impact camera = of([](Fabric& f) { f.camera.azimuth_deg += 10; });
  EXPECT_TRUE(camera.film);
  EXPECT_FALSE(camera.lighting || camera.materials || camera.drape || camera.volume() || camera.threads);
  const Impact light = of([](Fabric& f) { f.light.azimuth_deg += 10; });
  EXPECT_TRUE(light.film && light.lighting);
  EXPECT_FALSE(light.materials || light.drape || light.volume() || light.threads);
}

TEST(Impact, FibreOpticsAndColourTouchNoVoxel) {
  const std::vector<std::function<void(Fabric&)>> edits = {
      [](Fabric& f) { f.fibres[0].refractiveIndex = 1.4; },
      [](Fabric& f) { f.fibres[0].absorption_per_mm = Rgb(3.0f); },
      [](Fabric& f) { f.fibres[0].longitudinalRoughness = 0.1; },
      [](Fabric& f) { f.fibres[0].azimuthalRoughness = 0.1; },
      [](Fabric& f) { f.fibres[0].scaleTilt_deg = 3; },
      [](Fabric& f) { f.fibres[0].section = FibreSection::trilobal; },
      [](Fabric& f) { f.yarns[0].fibre = 1; },  // another colour of the same fibre
  };
  for (const auto& edit : edits) {
    const Impact impact = of(edit);
    EXPECT_TRUE(impact.film && impact.materials);
    EXPECT_FALSE(impact.volume() || impact.drape || impact.lighting);
  }
}

TEST(Impact, ColourSequenceTouchesNoVoxel) {
  const Impact impact = of([](Fabric& f) { f.warpSequence = {0, 0, 1}; });
  EXPECT_TRUE(impact.film && impact.threads);
  EXPECT_FALSE(impact.volume() || impact.drape || impact.lighting || impact.materials);
}

TEST(Impact, SequenceOfYarnsOfOtherShapesMovesBricks) {
  const Impact impact = of([](Fabric& f) { f.warpSequence = {0, 0, 2}; });
  EXPECT_TRUE(impact.film && impact.threads && impact.crossings);
  EXPECT_FALSE(impact.allBricks);
}

TEST(Impact, SequencesThatSayTheSameAreTheSame) {
  EXPECT_TRUE(of([](Fabric& f) { f.warpSequence = {0, 0, 0}; }).nothing());
  Fabric a = base();
  a.warpSequence = {0, 1};
  Fabric b = a;
  b.warpSequence = {0, 1, 0, 1, 0, 1};
  EXPECT_TRUE(impact(a, b).nothing());
  b.warpSequence = {0, 1, 0, 1, 0};
  EXPECT_TRUE(impact(a, b).threads) << "equal on their common length, but not beyond";
}

TEST(Impact, YarnShapeRebuildsItsOwnBricks) {
  const std::vector<std::function<void(Fabric&)>> edits = {
      [](Fabric& f) { f.yarns[1].plyTwist_per_m += 100; },
      [](Fabric& f) { f.yarns[1].plyTwistDirection = TwistDirection::s; },
      [](Fabric& f) { f.yarns[1].plies = 2; },
      [](Fabric& f) { f.yarns[1].cords = 2; },
      [](Fabric& f) { f.yarns[1].count_tex = 40; },
      [](Fabric& f) { f.yarns[1].fibresPerPly = 90; },
      [](Fabric& f) { f.yarns[1].packing = 0.4; },
      [](Fabric& f) { f.yarns[1].flattening = 2; },
      [](Fabric& f) { f.yarns[1].hairiness_per_mm = 5; },
      [](Fabric& f) { f.yarns[1].migration = 0.5; },
      [](Fabric& f) { f.yarns[1].layout = FibreLayout::random; },
      [](Fabric& f) { f.fibres[1].density_g_cm3 = 1.3; },
  };
  for (const auto& edit : edits) {
    const Impact impact = of(edit);
    EXPECT_TRUE(impact.film);
    EXPECT_THAT(impact.reshapedYarns, ElementsAre(1));
    EXPECT_FALSE(impact.allBricks || impact.crossings || impact.drape || impact.lighting || impact.threads ||
                 impact.materials);
  }
}

TEST(Impact, ABlendOfLikeFibresTouchesNoVoxel) {
  for (const auto& edit : std::vector<std::function<void(Fabric&)>>{[](Fabric& f) { f.yarns[0].blendFibre = 1; },
                                                                    [](Fabric& f) {
                                                                      f.yarns[0].blendFibre = 1;
                                                                      f.yarns[0].blendShare = 0.9;
                                                                    }}) {
    const Impact impact = of(edit);
    EXPECT_TRUE(impact.materials && impact.film);
    EXPECT_FALSE(impact.volume() || impact.threads || impact.drape || impact.lighting);
  }
  Fabric blended = base();
  blended.yarns[0].blendFibre = 1;
  blended.fibres[1].radius_um = 9;
  Fabric more = blended;
  more.yarns[0].blendShare = 0.6;
  EXPECT_THAT(impact(blended, more).reshapedYarns, ElementsAre(0)) << "fewer, thicker fibres make the same mass";
}

TEST(Impact, AnUnusedShareAndOtherColourwaysAreNothing) {
  EXPECT_TRUE(of([](Fabric& f) { f.yarns[0].blendShare = 0.1; }).nothing());
  EXPECT_TRUE(of([](Fabric& f) { f.colourways.resize(3); }).nothing());
}

TEST(Impact, FibreRadiusIsShapeAndOptics) {
  const Impact impact = of([](Fabric& f) { f.fibres[1].radius_um = 9; });
  EXPECT_THAT(impact.reshapedYarns, ElementsAre(1));
  EXPECT_TRUE(impact.materials);
}

TEST(Impact, WhatAYarnDoesNotUseIsNotItsShape) {
  EXPECT_TRUE(of([](Fabric& f) { f.yarns[0].yarnTwist_per_m = 300; }).nothing()) << "a single has no plies to twist";
  EXPECT_TRUE(of([](Fabric& f) { f.yarns[0].cableTwist_per_m = 300; }).nothing()) << "it is no cable";
  EXPECT_TRUE(of([](Fabric& f) { f.yarns[0].hairLength_mm = 1; }).nothing()) << "it has no hairs";
  EXPECT_TRUE(of([](Fabric& f) { f.yarns[2].count_tex = 70; }).nothing()) << "no thread uses it";
  Fabric counted = base();
  counted.yarns[0].fibresPerPly = 100;
  Fabric other = counted;
  other.yarns[0].count_tex = 99;
  EXPECT_TRUE(impact(counted, other).nothing()) << "its count follows from the fibres";
  other.fibres[0].density_g_cm3 = 1.3;
  EXPECT_TRUE(impact(counted, other).nothing()) << "it has the same fibres, lighter";
}

TEST(Impact, OneCrossingMovesBricksWhoseKeyChanges) {
  const Impact impact = of([](Fabric& f) { f.weave = f.weave.with(1, 2, !f.weave.at(1, 2)); });
  EXPECT_TRUE(impact.film && impact.crossings);
  EXPECT_FALSE(impact.allBricks || impact.materials || impact.drape || impact.lighting || impact.threads);
  EXPECT_THAT(impact.reshapedYarns, IsEmpty());
}

TEST(Impact, DrapeTouchesNoBrick) {
  for (const auto& edit : std::vector<std::function<void(Fabric&)>>{[](Fabric& f) { f.drape.kind = DrapeKind::sphere; },
                                                                    [](Fabric& f) { f.drape.width_mm = 7; }}) {
    const Impact impact = of(edit);
    EXPECT_TRUE(impact.film && impact.drape);
    EXPECT_FALSE(impact.volume() || impact.materials || impact.lighting || impact.threads);
  }
}

TEST(Impact, SettAndResolutionRebuildAllBricks) {
  for (const auto& edit : std::vector<std::function<void(Fabric&)>>{[](Fabric& f) { f.ends_per_cm = 30; },
                                                                    [](Fabric& f) { f.picks_per_cm = 30; },
                                                                    [](Fabric& f) { f.render.resolution = 4; }}) {
    const Impact impact = of(edit);
    EXPECT_TRUE(impact.film && impact.allBricks);
    EXPECT_FALSE(impact.materials || impact.drape || impact.lighting || impact.threads);
  }
}

TEST(Impact, RenderSettings) {
  EXPECT_TRUE(of([](Fabric& f) { f.render.samplesPerPixel *= 2; }).nothing()) << "more samples of the same picture";
  for (const auto& edit : std::vector<std::function<void(Fabric&)>>{
           [](Fabric& f) { f.render.seed = 7; }, [](Fabric& f) { f.render.maxDepth = 3; },
           [](Fabric& f) { f.render.method = Method::fibres; }, [](Fabric& f) { f.render.estimator = Estimator::none; },
           [](Fabric& f) { f.render.eventLaw = EventLaw::report; }, [](Fabric& f) { f.render.width = 99; }}) {
    const Impact impact = of(edit);
    EXPECT_TRUE(impact.film);
    EXPECT_FALSE(impact.volume() || impact.materials || impact.drape || impact.lighting);
  }
}

TEST(Impact, HeadlightMovesWithTheCamera) {
  Fabric before = base();
  before.light.kind = LightKind::headlight;
  Fabric after = before;
  after.camera.distance_mm *= 2;
  EXPECT_TRUE(impact(before, after).lighting);
  after = before;
  after.camera.fov_deg = 35;
  EXPECT_FALSE(impact(before, after).lighting);
}

}  // namespace
}  // namespace loomlight
