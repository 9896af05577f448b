#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "app/bench/studies/wardrobe_study.h"
#include "core/fabric/model/validate.h"
#include "core/fabric/yarn/derived.h"

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
  EXPECT_THAT(warnings(fabric), testing::IsEmpty());
}

/// What a later change of the geometry would break. `info` measures in the same way.
TEST_P(WardrobeCloths, WeighWhatTheTradeSays) {
  const ClothComparison of = compareWithTrade(*GetParam());
  EXPECT_LE(std::abs(of.massOff()), kMassAllowance.share)
      << of.ours.arealMass_g_m2 << " g/m2, the trade says " << GetParam()->trade.mass_g_m2;
}

TEST_P(WardrobeCloths, AreAsThickAsTheTradeSaysOrItIsSaidWhyNot) {
  const Allowance& allowed = GetParam()->trade.thickness;
  const ClothComparison of = compareWithTrade(*GetParam());
  const double off = std::abs(of.thicknessOff());
  EXPECT_LE(off, allowed.share) << of.ours.thickness_mm << " mm, the trade says " << GetParam()->trade.thickness_mm;
  if (allowed.share > kThicknessAllowance.share) {
    EXPECT_STRNE(allowed.reason, "");
    EXPECT_GT(off, kThicknessAllowance.share) << "an excuse that is no longer needed";
  }
}

TEST_P(WardrobeCloths, CoverAsMuchAsRoundThreadsDoOrMore) {
  const ClothComparison of = compareWithTrade(*GetParam());
  EXPECT_GT(of.cover, GetParam()->trade.cover - 0.12);
  EXPECT_LE(of.cover, 1.0);
}

INSTANTIATE_TEST_SUITE_P(All, WardrobeCloths, testing::ValuesIn(allCloths()),
                         [](const auto& test) { return std::string(test.param->file); });

}  // namespace
}  // namespace loomlight
