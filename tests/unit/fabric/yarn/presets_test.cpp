#include "core/fabric/yarn/presets.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "core/fabric/model/finish.h"
#include "core/fabric/model/validate.h"
#include "core/fabric/model/yarn_count.h"
#include "core/fabric/yarn/derived.h"
#include "core/fabric/yarn/long_floats.h"
#include "core/fabric/yarn/yarn_reflectance.h"

namespace loomlight {
namespace {

TEST(Presets, TheFibresOfTheTradeAreThere) {
  std::vector<std::string> names;
  for (const FibrePreset& preset : fibrePresets()) names.push_back(preset.fibre.name);
  EXPECT_THAT(names, testing::ElementsAre("cotton", "wool", "silk", "linen", "viscose", "polyester", "nylon", "acrylic",
                                          "mohair", "alpaca", "cashmere"));
}

TEST(Presets, RadiusFollowsFromFinenessAndEveryNumberSaysWhereItIsFrom) {
  for (const FibrePreset& preset : fibrePresets()) {
    EXPECT_NEAR(fibreFineness_dtex(preset.fibre) / preset.fineness_dtex, 1.0, 0.005) << preset.fibre.name;
    const FibreSources& of = preset.sources;
    for (const char* source : {of.fineness, of.density, of.refractiveIndex, of.roughness, of.scaleTilt, of.colour})
      EXPECT_THAT(source, testing::ContainsRegex("^(measured|handbook|guess)")) << preset.fibre.name;
  }
}

/// Diameters as microscopes see them, um: cotton 11-14, merino 17-20, silk 10-13, linen 12-17, mohair 25-45, alpaca
/// 17-35, cashmere 14-18.5, others 9-22.
TEST(Presets, DiametersLieInTheRangesOfTheHandbooks) {
  const std::pair<double, double> ranges[] = {{11, 14}, {17, 20}, {10, 13}, {12, 17}, {10, 16},  {9, 18},
                                              {10, 20}, {12, 22}, {25, 45}, {17, 35}, {14, 18.5}};
  const std::vector<FibrePreset> presets = fibrePresets();
  ASSERT_EQ(presets.size(), std::size(ranges));
  for (size_t i = 0; i < presets.size(); ++i) {
    EXPECT_GE(2 * presets[i].fibre.radius_um, ranges[i].first) << presets[i].fibre.name;
    EXPECT_LE(2 * presets[i].fibre.radius_um, ranges[i].second) << presets[i].fibre.name;
  }
}

TEST(Presets, SilkIsAsClearAsMeasured) {
  // Guided light in bombyx silk loses at most 0.64 per mm.
  const FibrePreset silk = fibrePresets()[2];
  ASSERT_EQ(silk.fibre.name, "silk");
  EXPECT_LE(silk.fibre.absorption_per_mm.primaries.r, 0.64f);
}

TEST(Presets, EveryFibreAndYarnIsValidInACloth) {
  for (const FibrePreset& preset : fibrePresets()) {
    Fabric fabric;
    fabric.fibres = {preset.fibre};
    EXPECT_NO_THROW(validate(fabric, preset.fibre.name));
  }
  for (const YarnPreset& preset : yarnPresets()) {
    Fabric fabric;
    fabric.fibres = {preset.fibre};
    fabric.yarns = {preset.yarn};
    EXPECT_NO_THROW(validate(fabric, preset.yarn.name));
    EXPECT_NE(preset.provenance, "");
    const double fibres = fibresInYarn(preset.yarn, preset.fibre);
    EXPECT_GE(fibres, 12) << preset.yarn.name;
    EXPECT_LE(fibres, 1000) << preset.yarn.name;
  }
}

/// The glossary tells designers so of ring-spun yarns, and of rotor yarns a little less.
TEST(Presets, SpunYarnsAreAsHairyAsTheTradeMeasuresThem) {
  int spun = 0;
  for (const YarnPreset& preset : yarnPresets()) {
    const double hairiness = hairinessH(preset.yarn, preset.fibre);
    if (hairiness == 0) continue;  // filament
    ++spun;
    if (preset.fibre.name == "linen") continue;  // wet-spun, which lays its hair
    const bool isWoollen = preset.yarn.name.starts_with("Woollen"), isCompact = preset.yarn.name.ends_with("compact");
    EXPECT_GE(hairiness, isWoollen ? 7 : isCompact ? 3 : 4) << preset.yarn.name;
    EXPECT_LE(hairiness, (isWoollen ? 14 : isCompact ? 4 : 7) + 1e-9) << preset.yarn.name;
  }
  EXPECT_GE(spun, 9);
}

TEST(Presets, NoSpunYarnIsMoreEvenThanChance) {
  for (const YarnPreset& preset : yarnPresets()) {
    EXPECT_EQ(isSpun(preset.yarn), preset.yarn.evennessCv_percent > 0) << preset.yarn.name;
    if (!isSpun(preset.yarn)) continue;
    EXPECT_GT(preset.yarn.evennessCv_percent, limitCv_percent(preset.yarn, preset.fibre)) << preset.yarn.name;
  }
}

TEST(Presets, EveryFibreComesAsItIsUsuallySpun) {
  const std::set<std::string> filaments{"silk", "viscose", "polyester", "nylon"};
  for (const FibrePreset& preset : fibrePresets()) {
    const Fibre& fibre = preset.fibre;
    SCOPED_TRACE(fibre.name);
    Fabric fabric;
    fabric.fibres = {fibre};
    fabric.yarns = {usuallySpun(fibre)};
    EXPECT_NO_THROW(validate(fabric, fibre.name));
    const Yarn& yarn = fabric.yarns[0];
    EXPECT_EQ(yarn.count_tex, Yarn{}.count_tex);
    EXPECT_EQ(singlesIn(yarn), 1);
    EXPECT_GT(yarn.fibreDisorder_deg, 0);
    EXPECT_EQ(isSpun(yarn), !filaments.contains(fibre.name));
    if (!isSpun(yarn)) continue;
    EXPECT_GT(yarn.migration, 0);
    EXPECT_GE(hairinessH(yarn, fibre), 2.9);
    EXPECT_GT(yarn.evennessCv_percent, limitCv_percent(yarn, fibre));
  }
}

TEST(Presets, WhatADraftIsWovenOfIsSpun) {
  const Fabric fabric = plainCotton();
  EXPECT_NO_THROW(validate(fabric, "plain cotton"));
  EXPECT_TRUE(warnings(fabric, floats(fabric.weave), longFloats(fabric, kUsualFloatLimit_mm)).empty());
  const Yarn& yarn = fabric.yarns[0];
  for (const double value : {yarn.hairiness_per_mm, yarn.fibreDisorder_deg, yarn.evennessCv_percent, yarn.migration,
                             yarn.plyTwist_per_m, fabric.settCv_percent})
    EXPECT_GT(value, 0);
}

TEST(Presets, TwistMultiplierOfTheTrade) {
  // TPI = TM sqrt(Ne): TM 4 at Ne 25 is 20 turns per inch.
  EXPECT_NEAR(twist_per_m(4.0, texFromCount(25, CountSystem::cotton)), 20 / 0.0254, 1.5);
  EXPECT_NEAR(twistMultiplier(twist_per_m(3.7, 42), 42), 3.7, 1e-12);
}

TEST(Presets, DyedShowsItsColour) {
  const Rgb wanted(0.5f, 0.1f, 0.02f);
  const Fibre fibre = dyed(fibrePresets()[0].fibre, wanted);
  const Rgb shown = fibreReflectance(fibre);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(shown[i], wanted[i], 1e-4);
}

}  // namespace
}  // namespace loomlight
