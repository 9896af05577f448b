#include <gtest/gtest.h>

#include <cmath>

#include "core/geometry/cloth_geometry.h"
#include "tests/unit/geometry/cloths.h"

namespace loomlight {
namespace {

/// The axis of a yarn near a crossing, as height above s = 0 there, |s| <= pitch.
class AxisAt {
 public:
  AxisAt(const ClothGeometry& cloth, const CellKey& key)
      : pitch_(cloth.yarn(key.system, key.yarn).pitch_mm),
        before_(key.previous, key.here, pitch_),
        after_(key.here, key.next, pitch_) {}
  AxisPoint operator()(double s) const {
    return s < 0 ? before_.at(before_.lengthTo(s + pitch_)) : after_.at(after_.lengthTo(s));
  }

 private:
  double pitch_;
  Transition before_, after_;
};

/// How deep the bodies of warp and weft, as flattened tubes of the size at which yarns rest on each other, go into each
/// other at a crossing, mm; negative: a gap.
double penetration(const ClothGeometry& cloth, int pick, int end) {
  const CellKey warpKey = cloth.key(System::warp, pick, end), weftKey = cloth.key(System::weft, pick, end);
  const YarnGeometry &warp = cloth.yarn(System::warp, warpKey.yarn), &weft = cloth.yarn(System::weft, weftKey.yarn);
  const double warpTop = warp.halfHeight_mm * warp.contactShare(), warpSide = warp.halfWidth_mm * warp.contactShare();
  const double weftTop = weft.halfHeight_mm * weft.contactShare(), weftSide = weft.halfWidth_mm * weft.contactShare();
  const AxisAt warpAxis(cloth, warpKey), weftAxis(cloth, weftKey);
  const double side = warpKey.here.height_mm > weftKey.here.height_mm ? 1.0 : -1.0;
  double deepest = -1;
  constexpr int kSteps = 24;
  for (int i = -kSteps; i <= kSteps; ++i)
    for (int j = -kSteps; j <= kSteps; ++j) {
      // x across the warp, y across the weft: inside both outlines seen from above.
      const double x = warpSide * i / kSteps, y = weftSide * j / kSteps;
      if (std::abs(x) > weft.pitch_mm || std::abs(y) > warp.pitch_mm) continue;
      const AxisPoint over = warpAxis(y), under = weftAxis(x);
      const double warpHalf = warpTop * std::sqrt(1 - std::pow(x / warpSide, 2)) / std::cos(over.angle);
      const double weftHalf = weftTop * std::sqrt(1 - std::pow(y / weftSide, 2)) / std::cos(under.angle);
      const double gap = side * (over.z_mm - under.z_mm) - warpHalf - weftHalf;
      deepest = std::max(deepest, -gap);
    }
  return deepest;
}

TEST(YarnPath, WarpAndWeftTouchWithoutInterpenetrating) {
  for (const Fabric& fabric : cloths::all()) {
    SCOPED_TRACE(fabric.name);
    const ClothGeometry cloth(fabric, 8, 8);
    for (int pick = 0; pick < cloth.repeatPicks(); ++pick)
      for (int end = 0; end < cloth.repeatEnds(); ++end)
        ASSERT_LT(penetration(cloth, pick, end), 0.03 * cloth.minYarnDiameter_mm()) << pick << ", " << end;
  }
}

TEST(YarnPath, YarnsTouchWhereTheyInterlace) {
  const ClothGeometry cloth(cloths::plain(), 4, 4);
  const YarnGeometry &warp = cloth.yarn(System::warp, 0), &weft = cloth.yarn(System::weft, 0);
  const CellKey over = cloth.key(System::warp, 0, 0), under = cloth.key(System::weft, 0, 0);
  EXPECT_NEAR(std::abs(over.here.height_mm - under.here.height_mm), warp.halfHeight_mm + weft.halfHeight_mm, 1e-6);
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

TEST(YarnPath, CrimpOfPlainWeaveIsPeirces) {
  // Round yarns of one kind, no flats: with p the pitch, D the sum of radii, theta the steepest angle,
  // p = (l - D theta) cos theta + D sin theta, h = (l - D theta) sin theta + D (1 - cos theta), h = D.
  Fabric fabric = cloths::plain();
  fabric.yarns[0].flattening = 1;
  fabric.ends_per_cm = fabric.picks_per_cm = 18;
  const ClothGeometry cloth(fabric, 4, 4);
  const double p = 10.0 / 18, D = cloth.minYarnDiameter_mm();
  double low = 0, high = 1.3;
  for (int i = 0; i < 60; ++i) {
    const double theta = 0.5 * (low + high);
    const double straight = (p - 2 * D * std::sin(theta)) / std::cos(theta);
    const double climb = straight * std::sin(theta) + 2 * D * (1 - std::cos(theta));
    (climb < D ? low : high) = theta;
  }
  const double length = (p - 2 * D * std::sin(low)) / std::cos(low) + 2 * D * low;
  EXPECT_NEAR(cloth.measure().crimpWarp, length / p - 1, 1e-5);
  EXPECT_NEAR(cloth.measure().crimpWeft, length / p - 1, 1e-5);
  EXPECT_NEAR(cloth.measure().thickness_mm, 2 * D, 1e-6);
}

TEST(YarnPath, FloatsBulgeAndCrimpLess) {
  Fabric fabric = cloths::plain();
  const double plainCrimp = ClothGeometry(fabric, 8, 8).measure().crimpWarp;
  fabric.weave = cloths::satin8();
  const ClothGeometry satin(fabric, 8, 8);
  EXPECT_LT(satin.measure().crimpWarp, 0.5 * plainCrimp);
  // End 0 is over at pick 0 only: the float under picks 1 to 7 is deepest in its middle.
  EXPECT_LT(satin.key(System::warp, 4, 0).here.height_mm, satin.key(System::warp, 1, 0).here.height_mm);
  EXPECT_EQ(satin.key(System::warp, 1, 0).here.height_mm, satin.key(System::warp, 7, 0).here.height_mm);
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
  const double open = ClothGeometry(fabric, 4, 4).yarn(System::warp, 0).halfHeight_mm;
  fabric.ends_per_cm = 60;
  const ClothGeometry jammed(fabric, 4, 4);
  const YarnGeometry& warp = jammed.yarn(System::warp, 0);
  EXPECT_GT(warp.halfHeight_mm, open);
  EXPECT_LE(warp.halfWidth_mm, 0.5 * warp.crossPitch_mm * 1.9);
  const Transition path(jammed.key(System::weft, 0, 0).here, jammed.key(System::weft, 0, 0).next, 10.0 / 60);
  for (const Transition::Piece& piece : path.pieces()) EXPECT_LE(std::abs(piece.start.angle), kSteepestPath + 1e-6);
}

}  // namespace
}  // namespace loomlight
