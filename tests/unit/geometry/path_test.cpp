#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/geometry/cloth/cloth_geometry.h"
#include "tests/unit/geometry/cloths.h"

namespace loomlight {
namespace {

/// What the law puts between two yarns: axes as far apart as both sections are high, or further where they bend both
/// ways or float.
TEST(YarnPath, YarnsRestOnEachOtherWhereTheyCross) {
  for (const Fabric& fabric : cloths::all()) {
    SCOPED_TRACE(fabric.name);
    const ClothGeometry cloth(fabric, 8, 8);
    for (int pick = 0; pick < cloth.repeatPicks(); ++pick)
      for (int end = 0; end < cloth.repeatEnds(); ++end) {
        const YarnCellKey warp = cloth.key(System::warp, pick, end), weft = cloth.key(System::weft, pick, end);
        const double warpHigh = warp.here.up * cloth.yarn(System::warp, warp.yarn).radius_mm;
        const double weftHigh = weft.here.up * cloth.yarn(System::weft, weft.yarn).radius_mm;
        const double apart = std::abs(warp.here.height_mm - weft.here.height_mm);
        // Where their float states differ, each keeps the height of its own. Inside a float yarns rise further.
        ASSERT_GT(apart, 0.93 * (warpHigh + weftHigh)) << pick << ", " << end;
        ASSERT_LT(apart, 1.25 * (warpHigh + weftHigh)) << pick << ", " << end;
      }
  }
}

TEST(YarnPath, HeightsAddUpToTheDistanceOfTheAxes) {
  Fabric fabric = cloths::plain();
  for (const double balance : {0.25, 1.0, 4.0}) {
    fabric.crimpBalance = balance;
    const ClothGeometry cloth(fabric, 4, 4);
    const YarnGeometry &warp = cloth.yarn(System::warp, 0), &weft = cloth.yarn(System::weft, 0);
    const YarnCellKey over = cloth.key(System::warp, 0, 0), under = cloth.key(System::weft, 0, 0);
    EXPECT_NEAR(std::abs(over.here.height_mm - under.here.height_mm), warp.rest_mm[0] + weft.rest_mm[0], 1e-6);
    // Equal yarns of 1 g/m are 20 mm2 as stiff in bending as in tension: F = T h / p (1 + 20 m / p^2).
    const auto stiffness = [mass_g_m = 1e-3 * fabric.yarns[0].count_tex](double pitch_mm) {
      return (1 + 20 * mass_g_m / (pitch_mm * pitch_mm)) / pitch_mm;
    };
    EXPECT_NEAR(std::abs(over.here.height_mm / under.here.height_mm),
                balance * stiffness(weft.pitch_mm) / stiffness(warp.pitch_mm), 1e-3);
  }
}

TEST(YarnPath, WarpLiesOverWhereTheWeaveSaysSo) {
  const Fabric fabric = cloths::pliedSatin();
  const ClothGeometry cloth(fabric, 8, 8);
  for (int pick = -8; pick < 8; ++pick)
    for (int end = -8; end < 8; ++end) {
      const bool over =
          cloth.key(System::warp, pick, end).here.height_mm > cloth.key(System::weft, pick, end).here.height_mm;
      EXPECT_EQ(over, fabric.weave.warpOver(pick, end));
    }
}

TEST(YarnPath, IsAnArcALineAndAnArc) {
  // Over a third of the pitch each: with a the angle, 2 (p / 3) tan(a / 2) + (p / 3) tan a = 2 h, and the length is
  // 2 (p / 3) a / sin a + (p / 3) / cos a.
  const ClothGeometry cloth(cloths::plain(), 4, 4);
  const double p = 10.0 / 20, climb = 2 * std::abs(cloth.key(System::warp, 0, 0).here.height_mm);
  double low = 0, high = 1.3;
  for (int i = 0; i < 60; ++i) {
    const double a = 0.5 * (low + high);
    (p / 3 * (2 * std::tan(a / 2) + std::tan(a)) < climb ? low : high) = a;
  }
  const double length = p / 3 * (2 * low / std::sin(low) + 1 / std::cos(low));
  EXPECT_NEAR(cloth.measure().crimpWarp, length / p - 1, 1e-6);
}

TEST(YarnPath, FloatsCrimpLessAndLieHigher) {
  Fabric fabric = cloths::plain();
  const double plainCrimp = ClothGeometry(fabric, 8, 8).measure().crimpWarp;
  fabric.weave = cloths::satin8();
  const ClothGeometry satin(fabric, 8, 8);
  EXPECT_LT(satin.measure().crimpWarp, 0.5 * plainCrimp);
  // End 0 is over at pick 0 only: the float under picks 1 to 7 is deeper inside than at its ends.
  EXPECT_LT(satin.key(System::warp, 4, 0).here.height_mm, satin.key(System::warp, 1, 0).here.height_mm);
  EXPECT_EQ(satin.key(System::warp, 1, 0).here.height_mm, satin.key(System::warp, 7, 0).here.height_mm);
}

/// Of cotton singles.
Fabric cottonCloth(double ends_per_cm, double picks_per_cm, double warp_tex, double weft_tex) {
  Fabric fabric = cloths::plain();
  fabric.ends_per_cm = ends_per_cm;
  fabric.picks_per_cm = picks_per_cm;
  fabric.yarns.assign(2, fabric.yarns[0]);
  fabric.weftSequence = {1};
  fabric.yarns[0].count_tex = warp_tex;
  fabric.yarns[1].count_tex = weft_tex;
  for (Yarn& yarn : fabric.yarns) yarn.packing = 0.5;
  return fabric;
}

TEST(YarnPath, CrimpOfAPoplinOfUnequalSettIsTheHandbooks) {
  // 14 and 2 % for 50 x 28 per cm of 14.8 tex: textilecalculations.com.
  const ClothMeasures poplin = ClothGeometry(cottonCloth(50, 28, 14.8, 14.8), 4, 4).measure();
  EXPECT_NEAR(100 * poplin.crimpWarp, 14, 2);
  EXPECT_NEAR(100 * poplin.crimpWeft, 2, 2);
}

/// Crimp and thickness of yarns relaxed as bundles of hard threads, with tension, bending, contact and friction: ranges
/// over what such a solver can be started from. The law was read off the same threads, so that this holds its port.
struct WashedCloth {
  const char* name;
  Weave weave;
  double ends_per_cm, picks_per_cm, warp_tex, weft_tex, packing, density_g_cm3;
  double warpCrimp[2], weftCrimp[2], thickness_mm[2];
};

TEST(YarnPath, CrimpAndThicknessAreThoseOfRelaxedYarns) {
  const Weave denim({{1, 1, 1, 0}, {0, 1, 1, 1}, {1, 0, 1, 1}, {1, 1, 0, 1}});
  const Weave basket({{1, 1, 0, 0}, {1, 1, 0, 0}, {0, 0, 1, 1}, {0, 0, 1, 1}});
  const Weave plain = cloths::plain().weave;
  std::vector<std::vector<uint8_t>> satin(5, std::vector<uint8_t>(5, 0));
  for (size_t pick = 0; pick < 5; ++pick) satin[pick][2 * pick % 5] = 1;
  const WashedCloth relaxed[] = {
      {"denim", denim, 26, 17, 84, 66, 0.5, 1.52, {7.5, 10.8}, {2.3, 7.6}, {0.62, 0.71}},
      {"poplin", plain, 50, 28, 14.8, 14.8, 0.5, 1.52, {12.5, 14}, {2, 3.7}, {0.25, 0.30}},
      {"sheeting", plain, 30, 26, 19.7, 19.7, 0.5, 1.52, {8.1, 8.1}, {6.0, 6.0}, {0.25, 0.29}},
      {"satin", Weave(satin), 34, 24, 29.5, 29.5, 0.7, 1.38, {5.4, 5.4}, {2.1, 2.1}, {0.38, 0.41}},
      {"basket", basket, 30, 30, 30.3, 30.3, 0.5, 1.52, {7.0, 7.0}, {7.0, 7.0}, {0.39, 0.39}},
      {"organza", plain, 48, 44, 4.67, 4.67, 0.7, 1.34, {5.4, 5.4}, {4.8, 4.8}, {0.13, 0.14}}};
  for (const WashedCloth& cloth : relaxed) {
    SCOPED_TRACE(cloth.name);
    Fabric fabric = cottonCloth(cloth.ends_per_cm, cloth.picks_per_cm, cloth.warp_tex, cloth.weft_tex);
    fabric.weave = cloth.weave;
    fabric.press = 0;
    for (Yarn& yarn : fabric.yarns) yarn.packing = cloth.packing;
    for (Fibre& fibre : fabric.fibres) fibre.density_g_cm3 = cloth.density_g_cm3;
    const ClothMeasures measures = ClothGeometry(fabric, 8, 8).measure();
    EXPECT_GT(100 * measures.crimpWarp, cloth.warpCrimp[0] - 2);
    EXPECT_LT(100 * measures.crimpWarp, cloth.warpCrimp[1] + 2);
    EXPECT_GT(100 * measures.crimpWeft, cloth.weftCrimp[0] - 2);
    EXPECT_LT(100 * measures.crimpWeft, cloth.weftCrimp[1] + 2);
    EXPECT_GT(measures.thickness_mm, 0.85 * cloth.thickness_mm[0]);
    EXPECT_LT(measures.thickness_mm, 1.15 * cloth.thickness_mm[1]);
  }
}

TEST(YarnPath, ClothIsThinnerTheMoreItIsPressed) {
  Fabric fabric = cottonCloth(30, 26, 19.7, 19.7);
  double before = 1;
  for (const double press : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    fabric.press = press;
    const double thickness = ClothGeometry(fabric, 4, 4).measure().thickness_mm;
    EXPECT_LT(thickness, before);
    before = thickness;
  }
}

TEST(YarnPath, ThinYarnsBendRoundThickOnes) {
  Fabric fabric = cloths::plain();
  Yarn thin = fabric.yarns[0];
  thin.count_tex = 8;
  fabric.yarns.push_back(thin);
  fabric.weftSequence = {1};
  const ClothMeasures measures = ClothGeometry(fabric, 4, 4).measure();
  EXPECT_GT(measures.crimpWeft, 2 * measures.crimpWarp);
}

TEST(YarnPath, JammedYarnsGrowTallerAndStayBounded) {
  Fabric fabric = cloths::plain();
  const double open = ClothGeometry(fabric, 4, 4).yarn(System::warp, 0).halfHeight_mm();
  fabric.ends_per_cm = 60;
  const ClothGeometry jammed(fabric, 4, 4);
  const YarnGeometry& warp = jammed.yarn(System::warp, 0);
  EXPECT_GT(warp.halfHeight_mm(), open);
  EXPECT_LE(warp.halfWidth_mm(), 0.5 * warp.crossPitch_mm * 1.9);
  const Transition path(jammed.key(System::weft, 0, 0).here, jammed.key(System::weft, 0, 0).next, 10.0 / 60);
  for (const Transition::Piece& piece : path.pieces()) EXPECT_LE(std::abs(piece.start.angle), kSteepestPath + 1e-6);
}

}  // namespace
}  // namespace loomlight
