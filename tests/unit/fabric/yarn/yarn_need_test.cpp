#include "core/fabric/yarn/yarn_need.h"

#include <gtest/gtest.h>

#include "core/fabric/yarn/derived.h"

namespace loomlight {
namespace {

TEST(YarnNeed, CountsThreadsAlongTheSequences) {
  Fabric fabric;
  fabric.yarns.resize(2);
  fabric.warpSequence = {0, 0, 1};
  fabric.weftSequence = {1};
  fabric.ends_per_cm = 10;
  fabric.picks_per_cm = 8;
  // 10 ends: A A B A A B A A B A.
  const std::vector<YarnNeed> needs = yarnNeed(fabric, {2, 1}, 0.1, 0.05);
  ASSERT_EQ(needs.size(), 2u);
  EXPECT_NEAR(needs[0].warp_m, 7 * 2 * 1.1, 1e-9);
  EXPECT_NEAR(needs[1].warp_m, 3 * 2 * 1.1, 1e-9);
  EXPECT_EQ(needs[0].weft_m, 0);
  EXPECT_NEAR(needs[1].weft_m, 1600 * 0.01 * 1.05, 1e-9);
  EXPECT_NEAR(needs[0].mass_kg, 7 * 2 * 1.1 * fabric.yarns[0].count_tex * 1e-6, 1e-12);
}

TEST(YarnNeed, SelvedgesTakeYarnToo) {
  Fabric fabric;
  fabric.yarns.resize(2);
  fabric.ends_per_cm = 10;
  fabric.mill.selvedgeEnds = 20;
  EXPECT_NEAR(yarnNeed(fabric, {2, 1}, 0.1, 0)[0].warp_m, (10 + 40) * 2 * 1.1, 1e-9) << "the warp goes on";
  fabric.mill.selvedgeYarn = 1;
  EXPECT_NEAR(yarnNeed(fabric, {2, 1}, 0.1, 0)[0].warp_m, 10 * 2 * 1.1, 1e-9);
  EXPECT_NEAR(yarnNeed(fabric, {2, 1}, 0.1, 0)[1].warp_m, 40 * 2 * 1.1, 1e-9);
}

TEST(YarnNeed, AllYarnsTogetherWeighWhatTheClothDoes) {
  Fabric fabric;
  fabric.yarns.resize(3);
  fabric.yarns[1].count_tex = 55;
  fabric.yarns[2].count_tex = 7;
  fabric.warpSequence = {0, 1};
  fabric.weftSequence = {2, 2, 1, 0};
  fabric.ends_per_cm = 24;
  fabric.picks_per_cm = 18;
  const PieceSize piece{30, 140};
  double mass_kg = 0;
  for (const YarnNeed& need : yarnNeed(fabric, piece, 0.06, 0.04)) mass_kg += need.mass_kg;
  const double area_m2 = piece.length_m * 0.01 * piece.width_cm;
  EXPECT_NEAR(mass_kg, 1e-3 * area_m2 * arealMass_g_m2(fabric, 0.06, 0.04), 1e-9);
}

}  // namespace
}  // namespace loomlight
