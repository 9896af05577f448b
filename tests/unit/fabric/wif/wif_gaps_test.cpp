/// Drafts that give a size to some of their threads, and say nothing of the others.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/fabric/model/yarn_count.h"
#include "core/fabric/wif/wif_fabric.h"
#include "tests/unit/fabric/wif/wif_drafts.h"

namespace loomlight {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

/// The twill without any size.
std::string sizeless() {
  std::string text = replaced(twillFile(), "Spacing=0.05\nThickness=0.04\n", "");
  return replaced(replaced(text, "Spacing=.02\n", ""), "[WEFT SPACING]\n2=0.04\n", "");
}

WifImport fromFile(const std::string& text) {
  return fabricFromWif(text, "x.wif", Fabric{}, WifSizeChoice::file);
}

double endsDiameter(const Fabric& fabric, int end) {
  const Yarn& yarn = fabric.yarns[fabric.warpYarn(end)];
  return yarnDiameter_mm(yarn, meanFibre(yarn, fabric.fibres));
}

/// All but what is kept of the file is as without these lines, whether its sizes are taken or not.
void expectPassedOver(const std::string& lines) {
  const auto ofSystem = [&lines](const WifRest& rest) { return lines.starts_with("[WARP") ? rest.warp : rest.weft; };
  const WifSizes read = ofSystem(document(sizeless() + lines).rest);
  for (const WifSizeChoice sizes : {WifSizeChoice::keep, WifSizeChoice::file}) {
    Fabric fabric = imported(sizeless() + lines, sizes);
    EXPECT_EQ(ofSystem(document(wifFromFabric(fabric, "y.wif").text).rest), read) << lines;
    const Fabric plain = imported(sizeless(), sizes);
    fabric.wif = plain.wif;
    EXPECT_EQ(fabric, plain) << lines;
  }
}

std::vector<std::string> saidOf(const std::string& text) {
  return inLines(fromFile(text).warnings);
}

TEST(WifGaps, ThicknessOfAFewEndsIsNotTheUsualOne) {
  for (const char* lines : {"[WARP THICKNESS]\n3=0.08\n6=0.08\n", "[WARP THICKNESS]\n3=0.08\n6=0.12\n"}) {
    expectPassedOver(lines);
    EXPECT_THAT(saidOf(sizeless() + lines),
                Contains("[WARP THICKNESS]: Only 2 of 8 ends have a thickness, and none is said for the others; it is "
                         "only kept for export, and makes no end thick or thin."));
  }
}

TEST(WifGaps, ThicknessOfAFewPicksIsNotTheUsualOne) {
  const std::string lines = "[WEFT THICKNESS]\n2=0.03\n4=0.03\n5=0.02\n";
  expectPassedOver(lines);
  EXPECT_THAT(saidOf(sizeless() + lines),
              Contains("[WEFT THICKNESS]: Only 3 of 6 picks have a thickness, and none is said for the others; it is "
                       "only kept for export, and makes no pick thick or thin."));
}

TEST(WifGaps, SpacingOfSomeThreadsIsPassedOverWithAWord) {
  const std::string warp = "[WARP SPACING]\n3=0.08\n6=0.08\n", weft = "[WEFT SPACING]\n1=0.1\n2=0.1\n3=0.2\n4=0.1\n";
  expectPassedOver(warp);
  expectPassedOver(weft);
  const std::vector<std::string> said = saidOf(sizeless() + warp + weft);
  EXPECT_THAT(said, Contains("[WARP SPACING]: Only 2 of 8 ends have a spacing, and none is said for the others; it is "
                             "only kept for export, and all ends lie at one distance."));
  EXPECT_THAT(said, Contains("[WEFT SPACING]: Only 4 of 6 picks have a spacing, and none is said for the others; it is "
                             "only kept for export, and all picks lie at one distance."));
}

// One bad line does not cost the others what they say.
TEST(WifGaps, WhereMostHaveAThicknessItsThickEndsStayThick) {
  const std::string lines = "[WARP THICKNESS]\n1=0.04\n2=0.08\n3=0.04\n4=0.04\n5=0.04\n6=0.04\n7=0.04\n8=many\n";
  const WifImport import = fromFile(sizeless() + lines);
  for (int end = 0; end < 8; ++end)
    EXPECT_NEAR(endsDiameter(import.fabric, end), end == 1 ? 0.8 : 0.4, 0.01) << "end " << end + 1;
  EXPECT_THAT(inLines(import.warnings), Contains("[WARP THICKNESS]: Only 7 of 8 ends have a thickness, and none is "
                                                 "said for the others; they get the usual yarn."));
}

TEST(WifGaps, NothingIsSaidWhereAllAreSaid) {
  std::string all = sizeless();
  for (const auto& [section, threads] :
       {std::pair("WARP THICKNESS", 8), {"WARP SPACING", 8}, {"WEFT THICKNESS", 6}, {"WEFT SPACING", 6}}) {
    all += fmt::format("[{}]\n", section);
    for (int thread = 1; thread <= threads; ++thread) all += fmt::format("{}=0.0{}\n", thread, 1 + thread % 3);
  }
  EXPECT_THAT(saidOf(all), Not(Contains(HasSubstr("none is said"))));
  EXPECT_THAT(saidOf(twillFile() + "[WARP THICKNESS]\n3=0.08\n"), Not(Contains(HasSubstr("none is said"))));
}

// Of ends that no line of the threading names a file need not say how thick they are.
TEST(WifGaps, EndsThatAreNotNamedNeedNoSize) {
  std::string lines = "[WARP THICKNESS]\n", spaced = "[WEFT SPACING]\n";
  for (int end = 1; end <= 8; ++end) lines += fmt::format("{}=0.0{}\n", end, end == 2 ? 8 : 4);
  for (int pick = 1; pick <= 6; ++pick) spaced += fmt::format("{}=0.0{}\n", pick, pick == 2 ? 8 : 4);
  const std::string longer = replaced(replaced(sizeless(), "Threads=8", "Threads=50"), "Threads=6", "Threads=40");
  const WifImport import = fabricFromWif(longer + lines + spaced, "x.wif", Fabric{}, WifSizeChoice::keep);
  const Fabric cut = cutToNamed(import.fabric, import.named);
  const WifImport whole = fabricFromWif(sizeless() + lines + spaced, "x.wif", Fabric{}, WifSizeChoice::keep);
  ASSERT_GT(endsDiameter(whole.fabric, 1), 1.9 * endsDiameter(whole.fabric, 0));
  EXPECT_EQ(cut.yarns, whole.fabric.yarns);
  EXPECT_EQ(cut.warpSequence, whole.fabric.warpSequence);
  EXPECT_EQ(cut.weftSequence, whole.fabric.weftSequence);
  EXPECT_THAT(inLines(import.warnings), Not(Contains(HasSubstr("none is said"))));
  EXPECT_THAT(inLines(import.warnings), Contains(HasSubstr("Picks lie 1 to 2 times the usual distance")));
}

TEST(WifGaps, AnotherSettTakesTheirPlaceWithARemark) {
  Fabric fabric = imported(sizeless() + "[WARP SPACING]\n3=0.08\n[WEFT THICKNESS]\n4=0.03\n");
  fabric.ends_per_cm = 25;
  fabric.picks_per_cm = 26;
  const WifExport exported = wifFromFabric(fabric, "y.wif");
  EXPECT_THAT(exported.remarks, Contains(HasSubstr("Only some ends had a spacing or a thickness")));
  EXPECT_THAT(exported.remarks, Contains(HasSubstr("Only some picks had a spacing or a thickness")));
}

}  // namespace
}  // namespace loomlight
