#include "core/fabric/model/finish.h"

#include <gtest/gtest.h>

#include "core/fabric/model/changes.h"
#include "core/fabric/model/field_tables.h"
#include "core/fabric/model/yarn_count.h"

namespace loomlight {
namespace {

TEST(Finish, MercerisingMakesCottonRoundAndLustrousAndNothingElse) {
  Fibre cotton;
  cotton.section = FibreSection::kidney;
  Fabric fabric;
  EXPECT_EQ(withFinishedSurface(cotton, fabric), cotton);
  fabric.mercerised = true;
  const Fibre swollen = withFinishedSurface(cotton, fabric);
  EXPECT_EQ(swollen.section, FibreSection::round);
  EXPECT_LT(swollen.longitudinalRoughness, cotton.longitudinalRoughness);
  EXPECT_LT(swollen.azimuthalRoughness, cotton.azimuthalRoughness);
  Fibre rest = swollen;
  rest.section = cotton.section;
  rest.longitudinalRoughness = cotton.longitudinalRoughness;
  rest.azimuthalRoughness = cotton.azimuthalRoughness;
  EXPECT_EQ(rest, cotton);

  cotton.section = FibreSection::trilobal;
  EXPECT_EQ(withFinishedSurface(cotton, fabric), cotton) << "lye does nothing to it";
}

TEST(Finish, MercerisingLeavesEveryVoxel) {
  Fabric before, after;
  before.fibres.resize(2);
  after = before;
  after.mercerised = true;
  const Changes change = changes(before, after);
  EXPECT_EQ(change.stages, Stages(Stage::optics));
  EXPECT_EQ(change.fibres, (std::vector<int>{0, 1}));
}

TEST(Finish, TheHairOfAYarnIsWhatSingeingAndBrushingChange) {
  Yarn yarn;
  yarn.hairiness_per_mm = 40;
  yarn.hairLength_mm = 2;
  Fabric fabric;
  EXPECT_EQ(withFinish(yarn, fabric), yarn);
  for (bool Fabric::* finish : {&Fabric::singed, &Fabric::brushed}) {
    fabric = {};
    fabric.*finish = true;
    Yarn finished = withFinish(yarn, fabric);
    EXPECT_NE(finished.hairiness_per_mm, yarn.hairiness_per_mm);
    EXPECT_NE(finished.hairLength_mm, yarn.hairLength_mm);
    EXPECT_LE(finished.hairiness_per_mm, 50) << "the most that a yarn may have";
    EXPECT_LE(finished.hairLength_mm, 3);
    finished.hairiness_per_mm = yarn.hairiness_per_mm;
    finished.hairLength_mm = yarn.hairLength_mm;
    EXPECT_EQ(finished, yarn);
  }
}

TEST(Finish, MillingOpensYarnsThatHaveHairsAndMatsThem) {
  Yarn yarn;
  yarn.hairiness_per_mm = 9;
  yarn.hairLength_mm = 1;
  yarn.packing = 0.4;
  yarn.fibreDisorder_deg = 13;
  Fabric fabric;
  Yarn before = yarn;
  HairLie lieBefore = hairLieOf(fabric, System::warp);
  for (const double milling : {0.25, 0.5, 0.75, 1.0}) {
    fabric.milling = milling;
    const Yarn milled = withFinish(yarn, fabric);
    EXPECT_LT(milled.packing, before.packing) << milling;
    EXPECT_GT(milled.fibreDisorder_deg, before.fibreDisorder_deg) << milling;
    EXPECT_GT(milled.hairiness_per_mm, before.hairiness_per_mm) << milling;
    EXPECT_GT(milled.hairLength_mm, before.hairLength_mm) << milling;
    EXPECT_GT(hairLieOf(fabric, System::warp).lyingShare, lieBefore.lyingShare) << milling;
    EXPECT_EQ(feltingOf(yarn, fabric), milling);
    before = milled;
    lieBefore = hairLieOf(fabric, System::warp);
  }
  EXPECT_LE(lieBefore.lyingShare, 1);
  EXPECT_EQ(before.count_tex, yarn.count_tex);
  EXPECT_EQ(before.plyTwist_per_m, yarn.plyTwist_per_m);
}

TEST(Finish, MillingChangesWhereYarnsLie) {
  Fabric before, after;
  after.milling = 0.5;
  EXPECT_TRUE(changes(before, after).stages.any(Stage::grid));
}

TEST(Finish, MillingKeepsWithinWhatAYarnMayBe) {
  Yarn yarn;
  yarn.hairiness_per_mm = fieldInfo(&Yarn::hairiness_per_mm).max;
  yarn.hairLength_mm = fieldInfo(&Yarn::hairLength_mm).max;
  yarn.packing = fieldInfo(&Yarn::packing).min;
  yarn.fibreDisorder_deg = fieldInfo(&Yarn::fibreDisorder_deg).max;
  Fabric fabric;
  fabric.milling = 1;
  EXPECT_EQ(withFinish(yarn, fabric), yarn);
}

TEST(Finish, MillingDoesNothingToFilaments) {
  Yarn filament;
  filament.hairiness_per_mm = 0;
  Fabric fabric;
  fabric.milling = 1;
  EXPECT_EQ(withFinish(filament, fabric), filament);
  EXPECT_EQ(feltingOf(filament, fabric), 0);
}

TEST(Hairiness, IsSetByWhatTestersMeasure) {
  Yarn yarn;
  const Fibre fibre;
  yarn.hairiness_per_mm = 3;
  for (const double wanted : {0.5, 4.0, 12.0})
    EXPECT_NEAR(hairinessH(withHairinessH(yarn, fibre, wanted), fibre), wanted, 1e-12);
  EXPECT_EQ(withHairinessH(yarn, fibre, 1e6).hairiness_per_mm, 50);
}

}  // namespace
}  // namespace loomlight
