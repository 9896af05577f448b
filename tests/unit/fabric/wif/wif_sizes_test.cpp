#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/fabric/json/fabric_json.h"
#include "core/fabric/model/wif_origin.h"
#include "core/fabric/model/yarn_count.h"
#include "core/fabric/wif/wif_fabric.h"
#include "tests/unit/fabric/wif/wif_drafts.h"

// What a fabric that came from a WIF draft says of spacing and thickness when it goes out as one again.
namespace loomlight {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

double diameterOf(const Fabric& fabric, int yarn) {
  return yarnDiameter_mm(fabric.yarns[yarn], meanFibre(fabric.yarns[yarn], fabric.fibres));
}

/// The same cloth, for ever: crossings, and the thickness of every thread.
void expectSameThreads(const Fabric& a, const Fabric& b) {
  const int ends = std::max(a.weave.ends(), b.weave.ends()) * 3, picks = std::max(a.weave.picks(), b.weave.picks()) * 3;
  for (int p = 0; p < picks; ++p)
    for (int e = 0; e < ends; ++e) ASSERT_EQ(a.weave.warpOver(p, e), b.weave.warpOver(p, e)) << p << " " << e;
  constexpr double kHalfStep = 0.5e-3;  // sizes of threads are told apart by a thousandth of the usual one
  for (int e = 0; e < ends; ++e)
    ASSERT_NEAR(diameterOf(a, a.warpYarn(e)) / diameterOf(b, b.warpYarn(e)), 1, kHalfStep) << "end " << e;
  for (int p = 0; p < picks; ++p)
    ASSERT_NEAR(diameterOf(a, a.weftYarn(p)) / diameterOf(b, b.weftYarn(p)), 1, kHalfStep) << "pick " << p;
}

/// The twill with a first end half as thick again as the others.
std::string thickEndFile() {
  return twillFile() + "[WARP THICKNESS]\n1=0.06\n";
}

TEST(WifSizes, UnevenSpacingThatGoesIsSaid) {
  Fabric fabric = imported(twillFile());
  fabric.picks_per_cm = 31;
  const WifExport exported = wifFromFabric(fabric, "y.wif");
  EXPECT_THAT(exported.remarks, Contains(HasSubstr("Picks lay unevenly in the file")));
  EXPECT_TRUE(document(exported.text).rest.weft.spacings.empty());
  const Fabric again = imported(exported.text);
  EXPECT_NE(again.weftYarn(1), again.weftYarn(0)) << "thick picks have their thickness now";
}

TEST(WifSizes, SizesOfTheDesignerReplaceThoseOfTheFile) {
  Fabric fabric = imported(twillFile());
  fabric.ends_per_cm = 25;
  const WifRest rest = document(wifFromFabric(fabric, "y.wif").text).rest;
  EXPECT_EQ(rest.warp.spacing, 0.04);
  EXPECT_EQ(rest.weft, document(twillFile()).rest.weft) << "untouched";
  for (Yarn& yarn : fabric.yarns) yarn.count_tex *= 4;
  const Yarn& usual = fabric.yarns[fabric.weftYarn(0)];
  EXPECT_NEAR(*document(wifFromFabric(fabric, "y.wif").text).rest.weft.thickness,
              0.1 * yarnDiameter_mm(usual, fabric.fibres[usual.fibre]), 1e-6);
}

// The mean thickness is the same in any order.
TEST(WifSizes, ThickThreadsInAnotherOrderAreWrittenWhereTheyAre) {
  Fabric fabric = imported(thickEndFile());
  ASSERT_EQ(fabric.warpSequence.size(), 8u);
  std::rotate(fabric.warpSequence.begin(), fabric.warpSequence.begin() + 1, fabric.warpSequence.end());
  for (const Fabric& turned : {fabric, fabricFromJson(fabricToJson(fabric), "x.json")}) {
    const WifExport exported = wifFromFabric(turned, "y.wif");
    expectSameThreads(imported(exported.text), turned);
    EXPECT_THAT(exported.remarks, Contains(HasSubstr("of single ends")));
    EXPECT_EQ(document(exported.text).rest.weft, document(twillFile()).rest.weft) << "untouched";
  }
}

TEST(WifSizes, TheWeftsOrderIsMindedToo) {
  Fabric fabric = imported(twillFile());
  std::rotate(fabric.weftSequence.begin(), fabric.weftSequence.begin() + 1, fabric.weftSequence.end());
  const WifExport exported = wifFromFabric(fabric, "y.wif");
  expectSameThreads(imported(exported.text), fabric);
  EXPECT_THAT(exported.remarks, Contains(HasSubstr("of single picks")));
}

// Ends 2 and 3 are of two colours, and as thick as each other.
TEST(WifSizes, ColoursInAnotherOrderLeaveTheFilesSizes) {
  Fabric fabric = imported(thickEndFile());
  ASSERT_NE(fabric.warpSequence[1], fabric.warpSequence[2]);
  std::swap(fabric.warpSequence[1], fabric.warpSequence[2]);
  const WifExport exported = wifFromFabric(fabric, "y.wif");
  EXPECT_EQ(document(exported.text).rest.warp, document(thickEndFile()).rest.warp);
  EXPECT_THAT(exported.remarks, IsEmpty());
}

// Files of before diameters were kept hand back what they said, as they did.
TEST(WifSizes, OlderFabricsHandBackTheFilesSizes) {
  Fabric fabric = imported(thickEndFile());
  WifOrigin older = *fabric.wif;
  older.warpDiameters_mm.clear();
  older.weftDiameters_mm.clear();
  fabric.wif = std::make_shared<const WifOrigin>(older);
  EXPECT_EQ(document(wifFromFabric(fabric, "y.wif").text).rest, document(thickEndFile()).rest);
}

TEST(WifSizes, DiametersOfAFabricsFileAreChecked) {
  const std::string text = fabricToJson(imported(thickEndFile()));
  const std::string wrong = replaced(text, "\"warp_diameters_mm\": [", "\"warp_diameters_mm\": [-1, ");
  ASSERT_NE(wrong, text);
  try {
    fabricFromJson(wrong, "x.json");
    ADD_FAILURE() << "it is read";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("x.json: wif.warp_diameters_mm[0]: expected a number from 0 to 10000"));
  }
}

TEST(WifSizes, ThickThreadsStayWhereThereAreMoreOrFewer) {
  for (const int picks : {4, 7, 12}) {
    Fabric fabric = imported(twillFile());
    fabric.draft.reset();
    fabric.weave = fabric.weave.resized(8, picks);
    const WifExport exported = wifFromFabric(fabric, "y.wif");
    EXPECT_THAT(exported.remarks, Contains(HasSubstr("of single picks")));
    EXPECT_TRUE(document(exported.text).rest.weft.spacings.empty());
    expectSameThreads(imported(exported.text), fabric);
  }
}

}  // namespace
}  // namespace loomlight
