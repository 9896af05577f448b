#include "core/fabric/wif/wif_fabric.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <numeric>
#include <set>

#include "core/base/rgb.h"
#include "core/fabric/json/fabric_json.h"
#include "core/fabric/model/colourways.h"
#include "core/fabric/model/validate.h"
#include "core/fabric/model/yarn_count.h"
#include "core/fabric/weave/jacquard.h"
#include "core/fabric/weave/structures.h"
#include "core/fabric/wif/wif_writer.h"
#include "core/fabric/yarn/derived.h"
#include "core/fabric/yarn/yarn_reflectance.h"
#include "tests/unit/fabric/wif/wif_drafts.h"

namespace loomlight {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

Rgb colourOf(const Fabric& fabric, int yarn) {
  const Fibre& fibre = fabric.fibres[fabric.yarns[yarn].fibre];
  return srgbFromLinear(fibreReflectance(fibre));
}

void expectColour(const Rgb& colour, const Rgb& bytes) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(255 * colour[i], bytes[i], 0.5);
}

/// The same cloth, for ever: crossings, and colours of threads.
void expectSameCloth(const Fabric& a, const Fabric& b) {
  const int ends = std::max(a.weave.ends(), b.weave.ends()) * 3, picks = std::max(a.weave.picks(), b.weave.picks()) * 3;
  for (int p = -2; p < picks; ++p)
    for (int e = -2; e < ends; ++e) ASSERT_EQ(a.weave.warpOver(p, e), b.weave.warpOver(p, e)) << p << " " << e;
  for (int e = -2; e < ends; ++e) expectColour(colourOf(a, a.warpYarn(e)), 255.0f * colourOf(b, b.warpYarn(e)));
  for (int p = -2; p < picks; ++p) expectColour(colourOf(a, a.weftYarn(p)), 255.0f * colourOf(b, b.weftYarn(p)));
}

TEST(WifFabric, TakesDraftColoursAndTexts) {
  const Fabric f = imported(twillFile());
  EXPECT_EQ(f.name, "Two twills");
  EXPECT_EQ(f.description, "first line\n\nthird line");
  ASSERT_TRUE(f.draft);
  EXPECT_EQ(f.draft->treadling.back(), (std::vector<int>{2, 3}));
  EXPECT_EQ(f.weave, drawdown(*f.draft));
  EXPECT_EQ(f.warpSequence.size(), 4u) << "the shortest that goes on so";
  EXPECT_EQ(f.weftSequence.size(), 6u) << "one pick of them is thick";
  expectColour(colourOf(f, f.warpYarn(0)), {255, 255, 255});
  expectColour(colourOf(f, f.warpYarn(7)), {17, 34, 200});
  expectColour(colourOf(f, f.weftYarn(3)), {0, 0, 0});
  EXPECT_EQ(imported(replaced(twillFile(), "Title=Two twills\n", "")).name, "x");
}

TEST(WifFabric, ColoursOfAnotherFormGoOutAsTheyWereRead) {
  const std::string text = replaced(twillFile(), "Entries=4\n", "Entries=4\nForm=Decimal\n");
  const Fabric fabric = imported(text);
  EXPECT_EQ(fabricFromJson(fabricToJson(fabric), "x.json"), fabric) << "a fabric that was saved opens again";
  EXPECT_THAT(wifFromFabric(fabric, "y.wif").text, testing::Not(testing::HasSubstr("Form=")));
  const std::string rgb = replaced(twillFile(), "Entries=4\n", "Entries=4\nForm=RGB\n");
  EXPECT_THAT(wifFromFabric(imported(rgb), "y.wif").text, testing::HasSubstr("\r\nForm=RGB\r\n"));
}

/// Of a designer who looks at flannel, say: what the draft dyes is the blend, in one colour a yarn.
TEST(WifFabric, ABlendOfMineStaysOneInTheColoursOfTheFile) {
  Fabric mine;
  mine.fibres = {Fibre{}, Fibre{}, Fibre{}};
  mine.fibres[2].radius_um = 2 * mine.fibres[0].radius_um;
  mine.yarns[0].blendFibre = 2;
  mine.yarns[0].blendShare = 0.3;
  const std::string colourless = replaced(replaced(twillFile(), "Color=1\n", ""), "Color=3\n", "");
  for (const std::string& text : {twillFile(), colourless}) {
    for (const WifSizeChoice sizes : {WifSizeChoice::keep, WifSizeChoice::file}) {
      const Fabric fabric = fabricFromWif(text, "x.wif", mine, sizes).fabric;
      EXPECT_NO_THROW(validate(fabric, "x.wif"));
      for (const Yarn& yarn : fabric.yarns) {
        ASSERT_TRUE(yarn.blendFibre);
        EXPECT_EQ(yarn.blendShare, 0.3);
        EXPECT_EQ(fabric.fibres[*yarn.blendFibre].radius_um, 2 * fabric.fibres[yarn.fibre].radius_um);
        const Rgb first = srgbFromLinear(fibreReflectance(fabric.fibres[yarn.fibre]));
        expectColour(srgbFromLinear(fibreReflectance(fabric.fibres[*yarn.blendFibre])), 255.0f * first);
      }
    }
  }
}

/// A fabric has at most 64 fibres, so that of 40 yarns only some can be blends, each in its own colour.
TEST(WifFabric, ABlendThatHasNoRoomIsOfItsFirstFibre) {
  WifDocument many = document(twillFile());
  for (int colour = 1; colour <= 40; ++colour) many.rest.palette.colours[colour] = {3 * colour, 255 - colour, colour};
  many.draft.threading.assign(40, {1});
  many.warpColours.resize(40);
  std::iota(many.warpColours.begin(), many.warpColours.end(), 1);
  Fabric mine;
  mine.fibres = {Fibre{}, Fibre{}};
  mine.yarns[0].blendFibre = 1;
  const WifImport import = fabricFromWif(wifFromDocument(many), "x.wif", mine, WifSizeChoice::keep);
  const Fabric& fabric = import.fabric;
  EXPECT_NO_THROW(validate(fabric, "x.wif"));
  EXPECT_EQ(fabric.fibres.size(), 64u);
  const auto blends = std::count_if(fabric.yarns.begin(), fabric.yarns.end(),
                                    [](const Yarn& yarn) { return yarn.blendFibre.has_value(); });
  EXPECT_GE(blends, 24);
  const auto plain = static_cast<long>(fabric.yarns.size()) - blends;
  EXPECT_GT(plain, 0);
  EXPECT_THAT(inLines(import.warnings), Contains(HasSubstr(fmt::format("{} yarns are of the first fibre", plain))));
}

TEST(WifFabric, MineGivesTheYarnsAndAllElse) {
  Fabric mine;
  mine.yarns = {Yarn{}, Yarn{}, Yarn{}};
  mine.yarns[1].name = "silk";
  mine.yarns[1].count_tex = 20;
  mine.yarns[2].name = "linen";
  mine.yarns[2].count_tex = 40;
  mine.warpSequence = {2};
  mine.weftSequence = {1};
  mine.ends_per_cm = 33;
  mine.camera.distance_mm = 7;
  const Fabric f = fabricFromWif(twillFile(), "x.wif", mine, WifSizeChoice::keep).fabric;
  EXPECT_EQ(f.yarns[f.warpYarn(0)].count_tex, 40) << "the warp is not that of mine";
  EXPECT_EQ(f.yarns[f.weftYarn(0)].count_tex, 20);
  EXPECT_EQ(f.ends_per_cm, 33);
  EXPECT_EQ(f.camera, mine.camera);
}

// Opened one after the other, each into the cloth before: what a yarn was called does not pile up.
TEST(WifFabric, YarnsOfTheFilesColoursGoByThese) {
  Fabric mine;
  mine.yarns[0].name = "warp, ultramarine";
  mine.fibres[0].name = "cotton, ultramarine";
  mine.colourways = {colourwayOf(mine, "of my own")};
  for (int i = 0; i < 3; ++i) {
    const Fabric f = fabricFromWif(twillFile(), "x.wif", mine, WifSizeChoice::keep).fabric;
    EXPECT_EQ(f.yarns[f.warpYarn(0)].name, "");
    std::set<std::string> fibres;
    for (const Fibre& fibre : f.fibres) fibres.insert(fibre.name);
    EXPECT_EQ(fibres.size(), f.fibres.size()) << "two are called alike";
    for (const std::string& fibre : fibres) EXPECT_LE(fibre.size(), std::string("cotton 2").size()) << fibre;
    EXPECT_TRUE(f.colourways.empty()) << "they were of my fibres";
    mine = f;
  }
}

TEST(WifFabric, KeepsMySizesOrTakesTheFiles) {
  const WifImport kept = fabricFromWif(twillFile(), "x.wif", Fabric{}, WifSizeChoice::keep);
  EXPECT_EQ(kept.fabric.ends_per_cm, Fabric{}.ends_per_cm);
  EXPECT_THAT(inLines(otherWifSizes(kept.fabric)), Contains("The file has 16.87 picks per cm; the cloth keeps 20."));
  EXPECT_THAT(inLines(otherWifSizes(kept.fabric)), Contains(HasSubstr("The file's warp yarn is 0.4 mm thick")));
  EXPECT_EQ(wifSett(kept.fabric).ends_per_cm, 20);
  EXPECT_NEAR(*wifSett(kept.fabric).warpDiameter_mm, 0.4, 1e-9);

  const Fabric taken = imported(twillFile(), WifSizeChoice::file);
  EXPECT_EQ(taken.ends_per_cm, 20);
  EXPECT_NEAR(taken.picks_per_cm, 10 * 6 / (25.4 * (5 * 0.02 + 0.04)), 1e-3);
  const auto diameter = [](const Fabric& f, int yarn) {
    return yarnDiameter_mm(f.yarns[yarn], f.fibres[f.yarns[yarn].fibre]);
  };
  EXPECT_NEAR(diameter(taken, taken.warpYarn(0)), 0.4, 1e-4);
  EXPECT_NEAR(diameter(taken, taken.weftYarn(0)), diameter(Fabric{}, 0), 1e-9) << "the file does not say how thick";
  std::vector<WifWarning> warnings;
  EXPECT_EQ(withWifSizes(kept.fabric, warnings), taken) << "it can be done later";
  EXPECT_THAT(otherWifSizes(taken), testing::IsEmpty()) << "they are the file's now";
}

// Warp and weft have their commonest yarn in common, the weft another one besides: it is scaled like the rest.
TEST(WifFabric, TheFilesThicknessReachesEveryYarn) {
  std::string text = replaced(twillFile(), "Color=3\nUnits=Inches", "Color=1\nThickness=0.04\nUnits=Centimeters");
  text += "[WEFT COLORS]\n2=4\n";
  text = replaced(text, "[WEFT SPACING]\n2=0.04\n", "");
  const Fabric f = imported(text, WifSizeChoice::file);
  ASSERT_EQ(f.warpYarn(0), f.weftYarn(0));
  ASSERT_NE(f.weftYarn(1), f.weftYarn(0));
  for (const int yarn : {f.warpYarn(0), f.warpYarn(2), f.weftYarn(1)})
    EXPECT_NEAR(yarnDiameter_mm(f.yarns[yarn], f.fibres[f.yarns[yarn].fibre]), 0.4, 1e-4) << yarn;
}

TEST(WifFabric, TheFilesThicknessIsThatOfMostThreadsWhateverTheirColours) {
  std::string text = replaced(twillFile(), "3=0,0,0\n", "3=0,0,0\n5=1,2,3\n6=4,5,6\n7=7,8,9\n");
  text = replaced(text, "1=1\n2=1\n3=2\n4=2\n5=1\n6=1\n7=2\n8=2\n", "1=1\n2=2\n3=3\n4=4\n5=5\n6=6\n7=7\n8=7\n");
  text += "[WARP THICKNESS]\n7=0.08\n8=0.08\n";
  const Fabric f = imported(text, WifSizeChoice::file);
  const auto diameter_mm = [&](int end) {
    const Yarn& yarn = f.yarns[f.warpYarn(end)];
    return yarnDiameter_mm(yarn, f.fibres[yarn.fibre]);
  };
  for (const int end : {0, 1, 2, 3, 4, 5}) EXPECT_NEAR(diameter_mm(end), 0.4, 1e-4) << end;
  EXPECT_NEAR(diameter_mm(6), 0.8, 1e-4);
}

/// A name may say a count, and what is thicker is another yarn.
TEST(WifFabric, AYarnOfAnotherThicknessLosesItsName) {
  const auto named = [](Fabric fabric) {
    for (Yarn& yarn : fabric.yarns) yarn.name = "Ne 40 combed";
    return fabric;
  };
  std::vector<WifWarning> warnings;
  const Fabric taken = withWifSizes(named(imported(twillFile())), warnings);
  EXPECT_EQ(taken.yarns[taken.warpYarn(0)].name, "");
  EXPECT_EQ(taken.yarns[taken.weftYarn(0)].name, "Ne 40 combed") << "the file does not say how thick";
  const Fabric again = withWifSizes(named(taken), warnings);
  EXPECT_EQ(again.yarns[again.warpYarn(0)].name, "Ne 40 combed") << "it is as thick as the file says";
}

TEST(WifFabric, WhatIsNotNamedCanBeCutOff) {
  const std::string text = replaced(replaced(twillFile(), "Threads=6", "Threads=500"), "Threads=8", "Threads=30");
  const WifImport import = fabricFromWif(text, "x.wif", Fabric{}, WifSizeChoice::keep);
  EXPECT_EQ(import.named, (WifNamed{8, 6}));
  const Fabric cut = cutToNamed(import.fabric, import.named), plain = imported(twillFile());
  EXPECT_EQ(cut.weave, plain.weave);
  EXPECT_EQ(cut.draft, plain.draft);
  expectSameCloth(cut, plain);
  EXPECT_EQ(fabricFromJson(fabricToJson(cut), "x.json"), cut);
  EXPECT_EQ(document(wifFromFabric(cut, "y.wif").text).warpColours, document(twillFile()).warpColours);
  EXPECT_EQ(cutToNamed(plain, {}), plain);
  EXPECT_EQ(cutToNamed(cut, {100, 100}).weave, plain.weave);
}

TEST(WifFabric, HostileSizesAreHeldToTheRange) {
  std::string text =
      replaced(replaced(twillFile(), "Spacing=0.05", "Spacing=90000"), "Thickness=0.04", "Thickness=90000");
  const WifImport import = fabricFromWif(text, "x.wif", Fabric{}, WifSizeChoice::file);
  EXPECT_EQ(import.fabric.ends_per_cm, 0.2);
  EXPECT_THAT(inLines(import.warnings), Contains(HasSubstr("out of range")));
}

TEST(WifFabric, MoreColoursThanYarnsBecomeTheNearest) {
  std::string table = "[COLOR TABLE]\n", colours = "[WARP COLORS]\n";
  for (int c = 1; c <= 200; ++c) {
    table += fmt::format("{0}={0},{0},{0}\n", c);
    colours += fmt::format("{0}={0}\n", c);
  }
  const std::string text =
      "[WIF]\n[WARP]\nThreads=200\n[WEFT]\nThreads=1\n[COLOR PALETTE]\nRange=0,255\n" + table + colours;
  const WifImport import = fabricFromWif(text, "x.wif", Fabric{}, WifSizeChoice::keep);
  EXPECT_EQ(import.fabric.yarns.size(), 64u);
  EXPECT_THAT(inLines(import.warnings), Contains(HasSubstr("a fabric has at most 64 yarns")));
  for (int end = 0; end < 200; ++end)
    EXPECT_NEAR(255 * colourOf(import.fabric, import.fabric.warpYarn(end)).r, end + 1, 3.5)
        << "the 200 greys are 3.1 of 64 apart, and no stand-in is off by more than twice half of that";
  EXPECT_EQ(import.fabric.wif->rest.palette.colours.size(), 200u) << "none is lost";
}

// One gold end among two hundred greys is what the weaver put it in for.
TEST(WifFabric, ARareColourOfItsOwnStays) {
  std::string table = "[COLOR TABLE]\n", colours = "[WARP COLORS]\n";
  for (int c = 1; c <= 400; ++c) {
    table += c == 400 ? "400=255,200,0\n" : fmt::format("{0}={1},{1},{1}\n", c, (c + 1) / 2);
    colours += fmt::format("{0}={0}\n", c);
  }
  const std::string text =
      "[WIF]\n[WARP]\nThreads=400\n[WEFT]\nThreads=1\n[COLOR PALETTE]\nRange=0,255\n" + table + colours;
  const Fabric f = imported(text);
  expectColour(colourOf(f, f.warpYarn(399)), {255, 200, 0});
}

TEST(WifFabric, EveryByteOfAColourComesBack) {
  for (const char* range : {"0,255", "0,999", "0,65535"}) {
    for (int c = 0; c < 256; c += 5) {
      const std::string text = replaced(replaced(twillFile(), "0,255", range), "17,34,200", fmt::format("{},0,255", c));
      const WifExport exported = wifFromFabric(imported(text), "y.wif");
      EXPECT_EQ(document(exported.text).rest.palette, document(text).rest.palette);
    }
  }
}

// Thick and thin of one colour are two yarns, white is there twice, and the last colour is nobody's.
TEST(WifFabric, ColourNumbersStayAsTheyWere) {
  std::string text = replaced(twillFile(), "Thickness=0.04\n", "Thickness=0.04\n[WARP THICKNESS]\n3=0.08\n6=0.08\n");
  text = replaced(text, "Threads=6\n", "Threads=6\n[WEFT COLORS]\n2=5\n4=5\n5=1\n");
  text = replaced(text, "4=120,80,3\n", "4=120,80,3\n5=255,255,255\n7=17,34,200\n");
  const WifDocument before = document(text);
  const Fabric fabric = imported(text);
  for (const Fabric& f : {fabric, fabricFromJson(fabricToJson(fabric), "x.json")}) {
    const WifDocument after = document(wifFromFabric(f, "y.wif").text);
    EXPECT_EQ(after.warpColours, before.warpColours);
    EXPECT_EQ(after.weftColours, before.weftColours);
    EXPECT_EQ(after.rest.palette, before.rest.palette);
  }
  Fabric redyed = fabric;
  Fibre& weft = redyed.fibres[redyed.yarns[redyed.weftYarn(0)].fibre];
  weft.absorption_per_mm = Rgb(9, 4, 1);
  const WifDocument after = document(wifFromFabric(redyed, "y.wif").text);
  EXPECT_EQ(after.warpColours, before.warpColours);
  EXPECT_EQ(after.weftColours[0], 8) << "a colour of its own, behind all others";
  EXPECT_EQ(after.weftColours[1], 5);
  EXPECT_EQ(after.rest.palette.colours.size(), before.rest.palette.colours.size() + 1);
}

TEST(WifFabric, AnotherColourFindsANumberBesideTheLast) {
  Fabric fabric = imported(replaced(twillFile(), "4=120,80,3\n", "65536=120,80,3\n"));
  fabric.fibres[fabric.yarns[fabric.weftYarn(0)].fibre].absorption_per_mm = Rgb(9, 4, 1);
  EXPECT_EQ(document(wifFromFabric(fabric, "y.wif").text).weftColours[0], 65535);
}

TEST(WifFabric, ADraftWithoutColoursGoesOutWithoutThem) {
  std::string text = twillFile();
  text = replaced(replaced(text, "Color=1\n", ""), "Color=3\n", "");
  for (const char* section : {"[COLOR PALETTE]", "[COLOR TABLE]", "[WARP COLORS]"}) {
    const size_t from = text.find(section), to = text.find("\n[", from);
    text.erase(from, to + 1 - from);
  }
  ASSERT_TRUE(document(text).rest.palette.colours.empty());
  Fabric navy;
  navy.fibres[0].absorption_per_mm = Rgb(50, 40, 9);
  Fabric measured = navy;  // by a spectrophotometer, as a matched swatch is
  measured.fibres[0].absorption_per_mm.bands.emplace().fill(12.0f);
  for (const Fabric& mine : {Fabric{}, navy, measured}) {
    Fabric fabric = fabricFromWif(text, "x.wif", mine, WifSizeChoice::keep).fabric;
    const WifDocument after = document(wifFromFabric(fabric, "y.wif").text);
    EXPECT_TRUE(after.rest.palette.colours.empty());
    EXPECT_EQ(after.warpColours, document(text).warpColours);
    fabric.fibres[0].absorption_per_mm = Rgb(1, 2, 3);
    EXPECT_EQ(document(wifFromFabric(fabric, "y.wif").text).rest.palette.colours.size(), 1u) << "dyed since";
  }
}

TEST(WifFabric, YarnsOfOneColourShareItsNumber) {
  Fabric fabric;
  fabric.yarns.resize(3);
  fabric.yarns[1].count_tex = 90;
  fabric.fibres[0].absorption_per_mm = Rgb(9, 4, 1);
  fabric.warpSequence = {0, 1};
  fabric.weftSequence = {2};
  EXPECT_EQ(document(wifFromFabric(fabric, "y.wif").text).rest.palette.colours.size(), 1u);
}

TEST(WifFabric, GoesThroughJsonAndBackToTheSameFile) {
  Random random(6);
  for (int i = 0; i < 200; ++i) {
    const std::string first = wifFromDocument(randomDocument(random));
    const Fabric fabric = imported(first, i % 2 ? WifSizeChoice::file : WifSizeChoice::keep);
    const Fabric read = fabricFromJson(fabricToJson(fabric), "x.json");
    ASSERT_EQ(read, fabric);
    const std::string second = wifFromFabric(read, "y.wif").text;
    const Fabric again = imported(second, i % 2 ? WifSizeChoice::file : WifSizeChoice::keep);
    expectSameCloth(again, fabric);
    ASSERT_EQ(again.draft->threading, fabric.draft->threading);
    ASSERT_EQ(again.draft->liftplan, fabric.draft->liftplan);
    ASSERT_EQ(wifFromFabric(again, "z.wif").text, second) << "stable from then on";
  }
}

TEST(WifFabric, HandsBackWhatItDoesNotHold) {
  Fabric fabric = imported(twillFile());
  fabric.name = "Renamed";
  const WifDocument before = document(twillFile());
  WifDocument after = document(wifFromFabric(fabric, "y.wif").text);
  EXPECT_EQ(after.title, "Renamed");
  EXPECT_EQ(after.rest, before.rest) << "palette, sizes, authors, private sections";
  EXPECT_EQ(after.draft, before.draft);
  EXPECT_EQ(after.warpColours, before.warpColours);
}

TEST(WifFabric, AFabricOfOurOwnBecomesADraft) {
  Fabric fabric;
  fabric.weave = twill(2, 2);
  fabric.yarns.resize(2);
  fabric.fibres.resize(2);
  fabric.yarns[1].fibre = 1;
  fabric.fibres[1].absorption_per_mm = Rgb(3, 20, 90);
  fabric.warpSequence = {0, 0, 0, 0, 1, 1, 1, 1};
  fabric.weftSequence = {0, 1, 1};
  const WifExport exported = wifFromFabric(fabric, "y.wif");
  EXPECT_THAT(exported.remarks, Contains(HasSubstr("the smallest one has 4 shafts and 4 treadles")));
  EXPECT_THAT(warningsOf(exported.text), testing::IsEmpty());
  const Fabric again = imported(exported.text, WifSizeChoice::file);
  EXPECT_EQ(again.weave.ends(), 8);
  EXPECT_EQ(again.weave.picks(), 12);
  expectSameCloth(fabric, again);
  EXPECT_EQ(again.ends_per_cm, fabric.ends_per_cm);
  EXPECT_NEAR(meanDiameter_mm(again, System::warp), meanDiameter_mm(fabric, System::warp), 1e-3);
}

TEST(WifFabric, AJacquardIsWrittenAndReadAgain) {
  Fabric fabric;
  fabric.weave = damaskJacquard(200, 240);
  EXPECT_EQ(imported(wifFromFabric(fabric, "y.wif").text).weave, fabric.weave);
}

TEST(WifFabric, FilesAreReadAndWritten) {
  const std::string file = testing::TempDir() + "wif-" + std::to_string(getpid()) + ".wif";
  const Fabric fabric = imported(twillFile());
  writeWifFabric(fabric, file);
  EXPECT_EQ(readWifFabric(file, Fabric{}, WifSizeChoice::keep).fabric.draft, fabric.draft);
  Fabric bad = fabric;
  bad.ends_per_cm = -1;
  EXPECT_THROW(writeWifFabric(bad, file), InputError);
  EXPECT_EQ(readWifFabric(file, Fabric{}, WifSizeChoice::keep).fabric.draft, fabric.draft) << "the old one is there";
  std::filesystem::remove(file);
  EXPECT_THROW(readWifFabric(file, Fabric{}, WifSizeChoice::keep), InputError);
}

}  // namespace
}  // namespace loomlight
