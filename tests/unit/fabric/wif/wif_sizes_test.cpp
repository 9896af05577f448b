#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/fabric/json/fabric_json.h"
#include "core/fabric/model/thread_spacing.h"
#include "core/fabric/model/wif_origin.h"
#include "core/fabric/model/yarn_count.h"
#include "core/fabric/wif/wif_fabric.h"
#include "tests/unit/fabric/wif/wif_drafts.h"

// What a fabric that came from a WIF draft says of spacing and thickness when it goes out as one again.
namespace loomlight {
namespace {

using testing::Contains;
using testing::ElementsAre;
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

TEST(WifSizes, ThickThreadsAreThickerByTheirRatio) {
  const std::string text = twillFile() + "[WARP THICKNESS]\n3=0.08\n";
  const Fabric f = imported(text);
  EXPECT_NE(f.warpYarn(2), f.warpYarn(6)) << "of one colour";
  EXPECT_EQ(f.yarns[f.warpYarn(6)].count_tex, Yarn{}.count_tex);
  EXPECT_NEAR(f.yarns[f.warpYarn(2)].count_tex, 4 * Yarn{}.count_tex, 1e-9) << "twice the diameter";
}

// Some programs write thick and thin as the room that a thread takes.
TEST(WifSizes, UnevenSpacingIsThickAndThin) {
  const WifImport import = fabricFromWif(twillFile(), "x.wif", Fabric{}, WifSizeChoice::keep);
  const Fabric& f = import.fabric;
  EXPECT_EQ(f.yarns[f.weftYarn(0)].count_tex, Yarn{}.count_tex);
  EXPECT_NEAR(f.yarns[f.weftYarn(1)].count_tex, 4 * Yarn{}.count_tex, 1e-9) << "twice the diameter";
  EXPECT_EQ(f.weftYarn(0), f.weftYarn(5));
  EXPECT_THAT(inLines(import.warnings),
              ElementsAre(testing::AllOf(HasSubstr("Picks lie 1 to 2 times the usual distance apart"),
                                         HasSubstr("have yarns of such diameters; here they lie so too"))));
  EXPECT_EQ(f.weftSpacing, (std::vector<double>{1.5, 1.5, 1, 1, 1, 1})) << "in the middle of their rooms";
  EXPECT_TRUE(f.warpSpacing.empty());
  const std::string back = wifFromFabric(f, "y.wif").text;
  EXPECT_EQ(document(back).rest.weft, document(twillFile()).rest.weft) << "none is lost";
  expectSameThreads(imported(back), f);
}

TEST(WifSizes, ThreadsThatFitTheirRoomAreSetApart) {
  const std::string text = replaced(twillFile(), "Spacing=.02\n", "Spacing=.02\nThickness=.018\n");
  const WifImport import = fabricFromWif(text, "x.wif", Fabric{}, WifSizeChoice::keep);
  EXPECT_EQ(import.fabric.weftSequence.size(), 1u) << "one yarn, with gaps";
  EXPECT_THAT(inLines(import.warnings),
              ElementsAre(HasSubstr("in the file; here they lie so too, as far as they can")));
  EXPECT_EQ(import.fabric.weftSpacing, (std::vector<double>{1, 2, 1, 1, 1, 1})) << "from thread to thread";
  EXPECT_EQ(document(wifFromFabric(import.fabric, "y.wif").text).rest, document(text).rest);
}

// Thick and thin by turns have rooms of two widths, and lie at one distance.
TEST(WifSizes, ThickAndThinByTurnsLieAtOneDistance) {
  const std::string text = replaced(twillFile(), "[WEFT SPACING]\n2=0.04\n", "[WEFT SPACING]\n2=.04\n4=.04\n6=.04\n");
  const WifImport import = fabricFromWif(text, "x.wif", Fabric{}, WifSizeChoice::keep);
  EXPECT_NE(import.fabric.weftYarn(1), import.fabric.weftYarn(0));
  EXPECT_TRUE(import.fabric.weftSpacing.empty());
  EXPECT_THAT(inLines(import.warnings), ElementsAre(HasSubstr("of such diameters; here they lie at one distance")));
}

// Hardly two crossings of such a cloth would be alike.
TEST(WifSizes, SpacingThatRepeatsLateIsSaidAndNotWoven) {
  std::string text = replaced(twillFile(), "Threads=8", "Threads=32"), spacing = "[WARP SPACING]\n";
  for (int end = 9; end <= 32; ++end) text = replaced(text, "[THREADING]\n", fmt::format("[THREADING]\n{}=1\n", end));
  for (int end = 1; end <= kMostSpacing + 1; ++end) spacing += fmt::format("{}=0.{}\n", end, 10 + end);
  const WifImport import = fabricFromWif(text + spacing, "x.wif", Fabric{}, WifSizeChoice::keep);
  ASSERT_EQ(import.fabric.weave.ends(), 32);
  EXPECT_TRUE(import.fabric.warpSpacing.empty());
  EXPECT_THAT(inLines(import.warnings), Contains(testing::AllOf(HasSubstr("Ends lie"), HasSubstr("at one distance"))));
}

TEST(WifSizes, BothThickAndUnevenTakesTheThickness) {
  const std::string text = twillFile() + "[WEFT THICKNESS]\n1=.02\n2=.02\n3=.03\n4=.02\n5=.02\n6=.02\n";
  const Fabric f = imported(text);
  EXPECT_NEAR(f.yarns[f.weftYarn(2)].count_tex, 2.25 * Yarn{}.count_tex, 1e-9);
  EXPECT_EQ(f.weftYarn(1), f.weftYarn(0));
}

TEST(WifSizes, UnevenSpacingThatGoesIsSaid) {
  Fabric fabric = imported(twillFile());
  ASSERT_FALSE(fabric.weftSpacing.empty());
  fabric.weftSpacing.clear();
  for (const double picks_per_cm : {fabric.picks_per_cm, 31.0}) {
    fabric.picks_per_cm = picks_per_cm;
    const WifExport exported = wifFromFabric(fabric, "y.wif");
    EXPECT_THAT(exported.remarks, Contains(HasSubstr("Picks lay unevenly in the file")));
    EXPECT_TRUE(document(exported.text).rest.weft.spacings.empty());
    const Fabric again = imported(exported.text);
    EXPECT_NE(again.weftYarn(1), again.weftYarn(0)) << "thick picks have their thickness now";
  }
}

TEST(WifSizes, UnevenSpacingStaysInAnotherSett) {
  Fabric fabric = imported(twillFile());
  fabric.picks_per_cm = 25;
  const WifExport exported = wifFromFabric(fabric, "y.wif");
  EXPECT_THAT(exported.remarks, testing::Not(Contains(HasSubstr("unevenly"))));
  // 1.5, 1.5, 1, 1, 1, 1 of 7 parts of six pitches of .04 cm.
  const std::map<int, double>& written = document(exported.text).rest.weft.spacings;
  ASSERT_EQ(written.size(), 6u);
  EXPECT_NEAR(written.at(1), 1.5 / 7 * 0.24, 1e-6);
  EXPECT_NEAR(written.at(6), 1.0 / 7 * 0.24, 1e-6);
  const Fabric again = imported(exported.text);
  EXPECT_EQ(again.weftSpacing.size(), 6u);
  for (size_t i = 0; i < 6; ++i) EXPECT_NEAR(again.weftSpacing[i], fabric.weftSpacing[i], 2e-4);
}

// Ends of a reed that the designer has set, which no file has said.
TEST(WifSizes, ADesignersSpacingIsWritten) {
  Fabric fabric;
  fabric.warpSpacing = {1, 1, 2.5};
  const Fabric again = imported(wifFromFabric(fabric, "y.wif").text);
  ASSERT_EQ(again.warpSpacing.size(), 3u);
  for (size_t i = 0; i < 3; ++i) EXPECT_NEAR(again.warpSpacing[i], fabric.warpSpacing[i], 1e-3);
  EXPECT_TRUE(again.weftSpacing.empty());
  EXPECT_EQ(again.weave.ends(), 6) << "weave and spacing repeat together";

  fabric.warpSpacing = {1, 2};
  fabric.ends_per_cm = 40;  // closer than the yarns are thick
  const Fabric dense = imported(wifFromFabric(fabric, "y.wif").text);
  EXPECT_EQ(dense.warpSpacing, fabric.warpSpacing);
  EXPECT_EQ(dense.warpSequence.size(), 1u) << "threads that lie close are not thin";

  fabric.warpSpacing = {0.1, 0.1, 2};
  EXPECT_EQ(imported(wifFromFabric(fabric, "y.wif").text).warpSpacing, (std::vector<double>{0.5, 0.5, 10}));
  fabric.warpSpacing = {3, 3, 3};
  EXPECT_TRUE(document(wifFromFabric(fabric, "y.wif").text).rest.warp.spacings.empty()) << "even";
}

// Threads beyond those that a draft names are not woven, and have no spacing either.
TEST(WifSizes, SpacingIsThatOfTheThreadsThatAreLeft) {
  std::string text = replaced(twillFile(), "Threads=8", "Threads=30") + "[WARP SPACING]\n";
  for (int end = 1; end <= 8; end += 2) text += fmt::format("{}=0.1\n", end);
  const WifImport import = fabricFromWif(text, "x.wif", Fabric{}, WifSizeChoice::keep);
  EXPECT_TRUE(import.fabric.warpSpacing.empty()) << "thirty do not repeat after few";
  const Fabric cut = cutToNamed(import.fabric, import.named);
  ASSERT_EQ(cut.weave.ends(), 8);
  EXPECT_EQ(cut.warpSpacing, (std::vector<double>{2, 1}));
  EXPECT_EQ(document(wifFromFabric(cut, "y.wif").text).rest.warp, cut.wif->rest.warp) << "its own";
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
    const Fabric again = imported(exported.text);
    expectSameThreads(again, fabric);
    ASSERT_EQ(again.weftSpacing.size(), 6u);
    for (size_t i = 0; i < 6; ++i) EXPECT_NEAR(again.weftSpacing[i], fabric.weftSpacing[i], 2e-4);
  }
}

}  // namespace
}  // namespace loomlight
