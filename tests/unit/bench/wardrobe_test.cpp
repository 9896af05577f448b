#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <string>

#include "app/bench/studies/wardrobe_study.h"
#include "core/base/random.h"
#include "core/fabric/model/validate.h"
#include "core/fabric/model/yarn_count.h"
#include "core/fabric/yarn/derived.h"
#include "core/fabric/yarn/long_floats.h"
#include "core/geometry/cloth/cloth_geometry.h"
#include "render/scene/fibre_bricks.h"
#include "render/scene/scene.h"
#include "tests/support/fibre_pairs.h"

namespace loomlight {
namespace {

std::vector<const WardrobeCloth*> allCloths() {
  std::vector<const WardrobeCloth*> cloths;
  for (const WardrobeCloth& cloth : wardrobe()) cloths.push_back(&cloth);
  return cloths;
}

TEST(Wardrobe, HasTwentyFourClothsAndDenimTwice) {
  std::set<std::string> files, names;
  for (const WardrobeCloth& cloth : wardrobe()) {
    files.insert(cloth.file);
    names.insert(cloth.name);
  }
  EXPECT_EQ(wardrobe().size(), 25u);
  EXPECT_EQ(files.size(), wardrobe().size());
  EXPECT_EQ(names.size(), wardrobe().size());
}

class WardrobeCloths : public testing::TestWithParam<const WardrobeCloth*> {};

TEST_P(WardrobeCloths, AreValidAndSayWhatTheyAre) {
  const Fabric fabric = fabricOf(*GetParam());
  EXPECT_NO_THROW(validate(fabric, GetParam()->file));
  EXPECT_EQ(fabric.name, GetParam()->name) << "the table and the file call it the same";
  EXPECT_THAT(fabric.description, testing::HasSubstr("Source")) << "where its construction is from";
  EXPECT_THAT(warnings(fabric, floats(fabric.weave), longFloats(fabric, 12)), testing::IsEmpty());
}

/// Within the trade's bounds, or it is said why not: what a later change of the geometry would break. `info` measures
/// in the same way.
TEST_P(WardrobeCloths, TurnOutAsTheTradeSays) {
  const TradeFigures& trade = GetParam()->trade;
  const ClothComparison of = compareWithTrade(*GetParam());
  EXPECT_LE(std::abs(of.massOff()), kMassAllowance.share)
      << of.ours.arealMass_g_m2 << " g/m2, the trade says " << trade.mass_g_m2;
  EXPECT_LE(std::abs(of.thicknessOff()), trade.thickness.share)
      << of.ours.thickness_mm << " mm, the trade says " << trade.thickness_mm;
  if (trade.thickness.share > kThicknessAllowance.share) {
    EXPECT_STRNE(trade.thickness.reason, "");
    EXPECT_GT(std::abs(of.thicknessOff()), kThicknessAllowance.share) << "an excuse that is no longer needed";
  }
}

/// Pressed yarns are no narrower than Peirce's round ones, which are of 0.91 g/cm3, and no wider than the law spreads
/// filament: 1.41 times at the usual readiness to flatten, 1.2, and as the root of it. Of what gaps are left, milling
/// closes its own share.
TEST_P(WardrobeCloths, CoverWhatYarnsOfTheirWidthCan) {
  const ClothComparison of = compareWithTrade(*GetParam());
  const auto coverOfYarns = [&](double width, double milling = 0) {
    const auto open = [&](double factor) { return (1 - milling) * (1 - std::min(1.0, width * factor / 28)); };
    return 1 - open(of.round.warp) * open(of.round.weft);
  };
  EXPECT_NEAR(coverOfYarns(1), of.round.fraction, 1e-12);
  EXPECT_GE(of.ours.cover, coverOfYarns(1));
  const Fabric fabric = fabricOf(*GetParam());
  double widest = 0;
  for (const Yarn& yarn : fabric.yarns) {
    const double density_g_cm3 = yarn.packing * meanFibre(yarn, fabric.fibres).density_g_cm3;
    widest = std::max(widest, 1.41 * std::sqrt(yarn.flattening / 1.2 * 0.91 / density_g_cm3));
  }
  EXPECT_LE(of.ours.cover, coverOfYarns(widest, fabric.milling));
}

/// Threads in disorder lie no closer together than 0.82; yarns of cloth, wherever they go, leave more air. Jammed ones
/// grow taller, so that each has room. By volume: loose fibres and what twist takes up count as if they lay in the
/// body.
TEST_P(WardrobeCloths, LeaveAirBetweenTheirFibres) {
  const ClothGeometry cloth(fabricOf(*GetParam()), 8, 8);
  for (const System system : {System::warp, System::weft})
    for (int thread = 0; thread < 8; ++thread) {
      const YarnGeometry& yarn = cloth.yarn(system, cloth.key(system, thread, thread).yarn);
      const double fibres_mm2 = 1e-3 * yarn.count_tex / yarn.fibreDensity_g_cm3;
      const double round_mm2 = kPi * yarn.radius_mm * yarn.radius_mm;
      const auto expectRoom = [&](const SectionOutline& section) {
        EXPECT_LE(fibres_mm2 / (round_mm2 * section.up * section.across), 0.8) << thread;
      };
      for (const SectionOutline& section : yarn.pressed) {
        expectRoom(section);
        expectRoom(SectionEasing(section, section, yarn.free).at(0.5));
      }
      expectRoom(SectionEasing(yarn.pressed.front(), yarn.pressed.back(), yarn.free).at(0.5));
    }
}

/// Of all pairs of a warp and a weft fibre that cross, fewer than one in fifty come closer than one and a half radii,
/// where fibres that touch are two apart; but yarns do rest on each other. On average over crossings of all kinds:
/// plies stand up at some and lie side by side at others.
TEST_P(WardrobeCloths, HaveYarnsThatHardlyRunThroughEachOther) {
  constexpr int kCrossings = 16;
  const ClothGeometry cloth(fabricOf(*GetParam()), 64, 64);
  Random random(3);
  double pressed = 0, touching = 0;
  for (int i = 0; i < kCrossings; ++i) {
    const int pick = static_cast<int>(64 * random.uniformDouble()), end = static_cast<int>(64 * random.uniformDouble());
    pressed += test::sharePressedTogether(cloth, pick, end, 1.5) / kCrossings;
    touching += test::sharePressedTogether(cloth, pick, end, 3) / kCrossings;
  }
  EXPECT_LT(pressed, 0.02);
  EXPECT_GT(touching, 0);
}

TEST_P(WardrobeCloths, HaveFibresSeenCloseBy) {
  Fabric fabric = fabricOf(*GetParam());
  fabric.light = Light{};
  fabric.light.kind = LightKind::dome;
  fabric.render.resolution = 1;  // fewer voxels of the same fibres
  const auto scene = makeScene(std::make_shared<const Fabric>(fabric), Task{});
  EXPECT_EQ(FibreBricks::whyNone(scene->cloth->volume->counts()), "");
  EXPECT_TRUE(scene->cloth->fibres);
}

INSTANTIATE_TEST_SUITE_P(All, WardrobeCloths, testing::ValuesIn(allCloths()),
                         [](const auto& test) { return std::string(test.param->file); });

}  // namespace
}  // namespace loomlight
