#include "core/fabric/wif/wif_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/fabric/wif/wif_drafts.h"

namespace loomlight {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// The twill without one section.
std::string without(const std::string& section) {
  const std::string text = twillFile();
  const size_t start = text.find("\n[" + section + "]") + 1;
  return text.substr(0, start) + text.substr(std::min(text.find("\n[", start), text.size() - 1) + 1);
}

TEST(WifReader, ReadsAllOfACarefulFileWithoutAWarning) {
  EXPECT_THAT(warningsOf(twillFile()), IsEmpty());
  const WifDocument d = document(twillFile());
  EXPECT_EQ(d.title, "Two twills");
  EXPECT_EQ(d.program, "Testweaver 2.5");
  EXPECT_THAT(d.notes, ElementsAre("first line", "", "third line"));
  EXPECT_EQ(d.draft.shafts, 4);
  EXPECT_EQ(d.draft.treadles, 4);
  EXPECT_EQ(d.draft.threading, (std::vector<std::vector<int>>{{1}, {2}, {3}, {4}, {1}, {2}, {3}, {4}}));
  EXPECT_EQ(d.draft.tieUp, (std::vector<std::vector<int>>{{1, 2}, {2, 3}, {3, 4}, {1, 4}}));
  EXPECT_EQ(d.draft.treadling, (std::vector<std::vector<int>>{{1}, {2}, {3}, {4}, {1}, {2, 3}}));
  EXPECT_TRUE(d.draft.liftplan.empty());
  EXPECT_THAT(d.warpColours, ElementsAre(1, 1, 2, 2, 1, 1, 2, 2));
  EXPECT_THAT(d.weftColours, ElementsAre(3, 3, 3, 3, 3, 3));
  EXPECT_EQ(d.rest.palette.colours.at(2), glm::ivec3(17, 34, 200));
  EXPECT_EQ(d.rest.warp.unit, WifUnit::centimeters);
  EXPECT_EQ(d.rest.warp.thickness, 0.04);
  EXPECT_EQ(d.rest.weft.unit, WifUnit::inches);
  EXPECT_EQ(d.rest.weft.spacing, 0.02);
  EXPECT_EQ(d.rest.weft.spacings.at(2), 0.04);
  EXPECT_NEAR(*d.rest.weft.meanSpacing_mm(6), 25.4 * (5 * 0.02 + 0.04) / 6, 1e-12);
}

TEST(WifReader, KeepsWhatItDoesNotUse) {
  EXPECT_THAT(
      document(twillFile()).rest.kept,
      ElementsAre(WifLines{"TEXT", {"Author=A. Weaver"}},
                  WifLines{"PRIVATE TESTWEAVER LOOM", {"; which loom", "Model = Big one", "  a line of its own"}}));
  const std::string odd = "; by hand\n" + replaced(twillFile(), "Shafts=4\n", "Shafts=4\n;c\nProfile=no\n") +
                          "[WARP SYMBOLS]\n1='X'\n1=#219\n";
  EXPECT_THAT(
      document(odd).rest.kept,
      ElementsAre(WifLines{"WIF", {"; by hand", ";c"}}, WifLines{"TEXT", {"Author=A. Weaver"}},
                  WifLines{"WEAVING", {"Profile=no"}}, WifLines{"WARP SYMBOLS", {"1=#219"}},
                  WifLines{"PRIVATE TESTWEAVER LOOM", {"; which loom", "Model = Big one", "  a line of its own"}}));
}

TEST(WifReader, LineEndsMarksAndCaseMakeNoDifference) {
  const WifDocument expected = document(twillFile());
  std::string crlf, cr;
  for (const char c : twillFile()) {
    crlf += c == '\n' ? std::string("\r\n") : std::string(1, c);
    cr += c == '\n' ? '\r' : c;
  }
  EXPECT_EQ(document(crlf), expected);
  EXPECT_EQ(document(cr), expected);
  EXPECT_EQ(document("\xEF\xBB\xBF" + twillFile()), expected);
  std::string shouted = replaced(twillFile(), "[Threading]", "[THREADING]");
  shouted = replaced(replaced(shouted, "[COLOR TABLE]", "[Colour  Table ] ; comment"), "Rising Shed=true",
                     "RISING SHED = ON");
  EXPECT_EQ(document(replaced(shouted, "Threads=8", " threads = 8 ; ends")), expected);
}

TEST(WifReader, ALaterDuplicateCounts) {
  const std::string text = twillFile() + "[THREADING]\n8=1\n";
  EXPECT_THAT(document(text).draft.threading.back(), ElementsAre(1));
  EXPECT_THAT(warningsOf(text), Contains(HasSubstr("[THREADING]: This part comes twice")));
  EXPECT_THAT(warningsOf(text), Contains(HasSubstr("[THREADING] 8: Each end should be named once")));
}

TEST(WifReader, LinesThatGoOnAreJoined) {
  for (const char* broken : {"6=2,\n3\n", "6=2,\\\n3\n", "6=2, \n  3\n"}) {
    const std::string text = replaced(twillFile(), "6=2,3\n", broken);
    EXPECT_THAT(document(text).draft.treadling.back(), ElementsAre(2, 3)) << broken;
    EXPECT_THAT(warningsOf(text), Contains(HasSubstr("goes on here")));
  }
}

TEST(WifReader, LiftplanCountsBeforeTreadling) {
  const std::string lifts = "[LIFTPLAN]\n1=1,2\n2=2,3\n3=3,4\n4=1,4\n5=1,2\n";
  EXPECT_THAT(warningsOf(twillFile() + lifts + "6=2,3,4\n"), Not(Contains(HasSubstr("another cloth"))));
  const std::string text = twillFile() + lifts + "6=1\n";
  EXPECT_THAT(warningsOf(text), Contains(HasSubstr("[LIFTPLAN]: The liftplan weaves another cloth")));
  const WifDocument d = document(text);
  EXPECT_TRUE(drawdown(d.draft).at(5, 0));
  EXPECT_FALSE(drawdown(d.draft).at(5, 2));
  EXPECT_EQ(d.draft.treadling.size(), 6u) << "kept beside it";
}

TEST(WifReader, AnEmptyLiftplanLiftsNothing) {
  const std::string text = replaced(replaced(without("TREADLING"), "Rising Shed=true", "Rising Shed=false"), "[NOTES]",
                                    "[LIFTPLAN]\n[NOTES]");
  const Weave weave = drawdown(document(text).draft);
  for (int pick = 0; pick < weave.picks(); ++pick)
    for (int end = 0; end < weave.ends(); ++end) EXPECT_FALSE(weave.at(pick, end));
}

TEST(WifReader, RisingShedIsMeantWhereNothingSaysSo) {
  EXPECT_FALSE(document(replaced(twillFile(), "Shed=true", "Shed=no")).draft.risingShed);
  const std::string silent = replaced(twillFile(), "Rising Shed=true\n", "");
  EXPECT_TRUE(document(silent).draft.risingShed);
  EXPECT_THAT(warningsOf(silent), ElementsAre(HasSubstr("taken as rising")));
  EXPECT_THAT(warningsOf(replaced(twillFile(), "Shed=true", "Shed=maybe")),
              ElementsAre(HasSubstr("Rising Shed=maybe: True or false should stand here")));
}

TEST(WifReader, ThreadsSaysHowLargeTheDraftIs) {
  const WifDocument more = document(replaced(twillFile(), "Threads=8", "Threads=10"));
  EXPECT_EQ(more.ends(), 10);
  EXPECT_TRUE(more.draft.threading[9].empty());
  EXPECT_EQ(more.warpColours[9], 1) << "the usual colour";
  const std::string fewer = replaced(twillFile(), "Threads=8", "Threads=5");
  EXPECT_EQ(document(fewer).ends(), 5);
  EXPECT_THAT(warningsOf(fewer),
              Contains(testing::AllOf(HasSubstr("[THREADING] 6; line "),
                                      HasSubstr("and 1 more like this: There are ends 1 to 5 only"))));
  for (const char* odd : {"", "Threads=\n", "Threads=0\n", "Threads=-3\n", "Threads=999999999\n", "Threads=8e9\n"})
    EXPECT_EQ(document(replaced(twillFile(), "Threads=8\n", odd)).ends(), 8) << odd;
}

TEST(WifReader, ShaftsThatAreUsedAreThere) {
  const std::string text = replaced(twillFile(), "8=4\n", "8=18\n");
  EXPECT_EQ(document(text).draft.shafts, 18);
  EXPECT_THAT(warningsOf(text),
              ElementsAre(HasSubstr("[WEAVING] Shafts=4: The draft uses another number of shafts: 18.")));
  EXPECT_EQ(document(replaced(twillFile(), "Shafts=4", "Shafts=2000000000")).draft.shafts, 4);
  EXPECT_EQ(document(replaced(twillFile(), "Treadles=4", "Treadles=0")).draft.treadles, 4);
}

TEST(WifReader, TreadlesThatAreNotThereMoveNothing) {
  const std::string text = replaced(twillFile(), "6=2,3\n", "6=2,7\n");
  EXPECT_THAT(document(text).draft.treadling.back(), ElementsAre(2));
  EXPECT_THAT(warningsOf(text), ElementsAre(HasSubstr("pick 6, treadle 7: There are 4 treadles")));
}

TEST(WifReader, MissingSectionsLeaveADraftThatOpens) {
  EXPECT_EQ(drawdown(document(without("TIEUP")).draft), Weave(std::vector<Weave::Row>(6, Weave::Row(8, 0))));
  EXPECT_THAT(warningsOf(without("TIEUP")), Contains(HasSubstr("[TIEUP]: No shaft is tied")));
  EXPECT_THAT(warningsOf(without("TREADLING")), Contains(HasSubstr("Neither a treadling nor a liftplan")));
  EXPECT_THAT(warningsOf(without("THREADING")), Contains(HasSubstr("no end hangs on a shaft")));
  EXPECT_EQ(document(without("WEAVING")).draft.shafts, 4);
  EXPECT_EQ(document(without("WARP")).ends(), 8);
  EXPECT_EQ(document(without("WEFT")).picks(), 6);
  EXPECT_THAT(warningsOf(without("WIF")), Contains(HasSubstr("[WIF]: The part that names the format is missing")));
  EXPECT_THAT(warningsOf(without("CONTENTS")), IsEmpty());
  EXPECT_THAT(document(without("COLOR TABLE")).warpColours, testing::Each(0));
  EXPECT_THAT(warningsOf(without("NOTES")), ElementsAre(HasSubstr("names what is not there")));
}

TEST(WifReader, ColoursComeInAnyRange) {
  const auto shown = [](const char* range, const char* colour) {
    const std::string text = replaced(replaced(twillFile(), "Range=0,255\n", range), "2=17,34,200\n", colour);
    const WifPalette palette = document(text).rest.palette;
    return palette.srgb(palette.colours.at(2));
  };
  EXPECT_EQ(shown("Range=0,999\n", "2=999,0,333\n"), Rgb(1, 0, 1.0f / 3));
  EXPECT_EQ(shown("Range=0,65535\n", "2=65535,0,13107\n"), Rgb(1, 0, 0.2f));
  EXPECT_EQ(shown("Range = 20,1200\n", "2=20,1200,610\n"), Rgb(0, 1, 0.5f));
  EXPECT_EQ(shown("", "2=255,0,51\n"), Rgb(1, 0, 0.2f));
  EXPECT_EQ(shown("", "2=999,0,333\n"), Rgb(1, 0, 1.0f / 3)) << "a range that the colours fit";
  EXPECT_EQ(shown("Range=5,5\n", "2=255,0,51\n"), Rgb(1, 0, 0.2f));
  EXPECT_EQ(shown("Range=0,255\n", "2=300,-4,51\n"), Rgb(1, 0, 0.2f));
  EXPECT_NEAR(shown("Range=0,1\n", "2=0.5,0,1\n").x, 0.5, 1e-4);
}

TEST(WifReader, ColoursThatAreNotInTheTableFallBack) {
  const std::string text = replaced(twillFile(), "[WARP COLORS]\n1=1\n2=1\n3=2\n", "[WARP COLORS]\n1=9\n2=0\n3=\n");
  EXPECT_THAT(document(text).warpColours, ElementsAre(1, 1, 1, 2, 1, 1, 2, 2));
  EXPECT_THAT(warningsOf(text),
              Contains(HasSubstr("[WARP COLORS] 1=9; line 78: [WARP COLORS] 2=0: There is no colour")));
  EXPECT_THAT(document(replaced(twillFile(), "Color=3", "Color=5")).weftColours, testing::Each(0));
  const WifDocument given = document(replaced(twillFile(), "Color=3", "Color=5,1,2,3"));
  EXPECT_THAT(given.weftColours, testing::Each(5));
  EXPECT_EQ(given.rest.palette.colours.at(5), glm::ivec3(1, 2, 3));
}

TEST(WifReader, NumbersAreTakenAsPeopleWriteThem) {
  const auto spacing = [](const char* value) {
    return document(replaced(twillFile(), "Spacing=0.05", std::string("Spacing=") + value)).rest.warp.spacing;
  };
  EXPECT_EQ(spacing(".212"), 0.212);
  EXPECT_EQ(spacing("0,212"), 0.212);
  EXPECT_EQ(spacing("\"0.212\""), 0.212);
  EXPECT_EQ(spacing("0.212 ; one twelfth"), 0.212);
  for (const char* wrong : {"0", "-1", "wide", "1e300", "nan", "inf", "1e-9"})
    EXPECT_EQ(spacing(wrong), std::nullopt) << wrong;
  EXPECT_EQ(document(replaced(twillFile(), "Units=Centimeters", "units=INCHES ")).rest.warp.unit, WifUnit::inches);
  EXPECT_EQ(document(replaced(twillFile(), "Units=Centimeters", "Units=Decipoints")).rest.warp.unit,
            WifUnit::decipoints);
}

TEST(WifReader, MillimetresAreUnderstood) {
  std::string mm = replaced(twillFile(), "Units=Centimeters", "Units=mm");
  mm = replaced(replaced(mm, "Spacing=0.05", "Spacing=0.5"), "Thickness=0.04", "Thickness=0.4");
  EXPECT_EQ(document(mm), document(twillFile()));
  EXPECT_THAT(warningsOf(mm), ElementsAre(HasSubstr("Units=mm: The format knows no millimetres")));
}

TEST(WifReader, HabitsOfOtherProgramsAreUnderstoodOrSaid) {
  const WifDocument expected = document(twillFile());
  for (const char* yes : {"T", "Y", "-1", "\"TRUE\"", "Yes ; always"}) {
    const std::string text = replaced(twillFile(), "Shed=true", std::string("Shed=") + yes);
    EXPECT_EQ(document(text), expected) << yes;
    EXPECT_EQ(warningsOf(text), warningsOf(twillFile())) << yes;
  }
  EXPECT_FALSE(document(replaced(twillFile(), "Shed=true", "Shed=F")).draft.risingShed);
  EXPECT_EQ(document(replaced(twillFile(), "Threads=8", "Threads=8.0")), expected);
  const std::string thousand = replaced(twillFile(), "Threads=8", "Threads=1.000");
  EXPECT_EQ(document(thousand).ends(), 8);
  EXPECT_THAT(warningsOf(thousand), Contains(HasSubstr("Threads=1.000: The number of threads should stand here")));
  EXPECT_EQ(document(replaced(twillFile(), "Units=Centimeters", "Units=Centimetre")), expected);
  EXPECT_THAT(warningsOf(replaced(twillFile(), "Range=0,255", "Range=0,255\nForm=HSV")),
              Contains(HasSubstr("Form=HSV: Colours are of hue, saturation and value")));
  EXPECT_THAT(warningsOf(replaced(twillFile(), "Range=0,255", "Range=0,255\nForm=CMYK")),
              Contains(HasSubstr("Form=CMYK: Colours of another form than RGB and HSV")));
  EXPECT_EQ(warningsOf(replaced(twillFile(), "Range=0,255", "Range=0,255\nForm=rgb")), warningsOf(twillFile()));
  const std::string semicolons = replaced(twillFile(), "6=2,3\n", "6=2;3\n");
  EXPECT_THAT(document(semicolons).draft.treadling.back(), ElementsAre(2, 3));
  EXPECT_THAT(warningsOf(semicolons), ElementsAre(HasSubstr("6=2;3: A semicolon begins a comment in this format")));
  const std::string comment = replaced(twillFile(), "6=2,3\n", "6=2;3 of them\n");
  EXPECT_THAT(document(comment).draft.treadling.back(), ElementsAre(2));
  EXPECT_THAT(warningsOf(comment), ElementsAre(HasSubstr("What stands behind a semicolon is a comment")));
  EXPECT_EQ(document(twillFile() + std::string("\0\0\x1A", 3)), expected) << "what old systems end a text with";
  EXPECT_EQ(document(replaced(twillFile(), "\n[WARP]\n", "\n\t[WARP]\t\n")), expected);
}

TEST(WifReader, HousekeepingIsNotSpokenOf) {
  std::string text = replaced(twillFile(), "Version=1.1", "Version=2.0");
  text = replaced(replaced(text, "April 20, 1997", "9/11/2014"), "wif@mhsoft.com", "me@example.org");
  EXPECT_THAT(warningsOf(replaced(text, "NOTES=true\n", "")), IsEmpty());
}

TEST(WifReader, WhatChangesTheClothIsSaidFirst) {
  std::string text = replaced(replaced(twillFile(), "Title=", "oops\nTitle="), "2=17,34,200", "2=17,34");
  text = replaced(replaced(text, "Treadles=4", "Treadles=2"), "8=4\n", "8=four\n");
  EXPECT_THAT(warningsOf(text),
              testing::ElementsAreArray({HasSubstr("[THREADING] 8=four"), HasSubstr("[COLOR TABLE] 2"),
                                         HasSubstr("[WARP COLORS] 3=2"), HasSubstr("[TEXT] oops"),
                                         HasSubstr("[WEAVING] Treadles=2")}));
}

TEST(WifReader, AColourInPlaceOfItsNumberIsNotTakenForOne) {
  const std::string text = replaced(twillFile(), "[WARP COLORS]\n1=1\n", "[WARP COLORS]\n1=255,0,0\n");
  EXPECT_THAT(warningsOf(text), ElementsAre(HasSubstr("Expected the number of one colour of the table; the thread")));
}

TEST(WifReader, ThreadsThatAreOnlyCountedAreToldFromTheNamed) {
  EXPECT_EQ(document(twillFile()).named, WifNamed{});
  const std::string text = replaced(replaced(twillFile(), "Threads=6", "Threads=500"), "8=4\n", "");
  EXPECT_EQ(document(text).named, (WifNamed{7, 6}));
  EXPECT_THAT(warningsOf(text),
              ElementsAre(HasSubstr("Only 7 of 8 ends are named"), HasSubstr("Only 6 of 500 picks are named")));
  EXPECT_EQ(document(replaced(twillFile(), "3=3\n", "")).named, WifNamed{}) << "a gap is none";
}

TEST(WifReader, OnlyThePlanThatCountsTellsHowManyPicksAreNamed) {
  const std::string lifts = "[LIFTPLAN]\n1=1,2\n2=2,3\n3=3,4\n4=1,4\n5=1,2\n6=3\n";
  const std::string shortTreadling = replaced(twillFile(), "4=4\n5=1\n6=2,3\n", "4=4\n");
  EXPECT_EQ(document(shortTreadling).named, (WifNamed{0, 4}));
  EXPECT_EQ(document(shortTreadling + lifts).named, WifNamed{}) << "the liftplan names all six";
  EXPECT_EQ(document(twillFile() + "[LIFTPLAN]\n1=1,2\n2=2,3\n3=3,4\n").named, (WifNamed{0, 3}));
}

TEST(WifReader, ListsAreReadHoweverTheyAreParted) {
  for (const char* list : {"2+3", "2/3", "2&3", "2-3", "2 + 3", "3-2", "2;3", "2; 3", "2 ;3"}) {
    const std::string text = replaced(twillFile(), "6=2,3\n", std::string("6=") + list + "\n");
    EXPECT_THAT(document(text).draft.treadling.back(), ElementsAre(2, 3)) << list;
    EXPECT_THAT(warningsOf(text), testing::SizeIs(1)) << list;
  }
  const std::string dash = replaced(twillFile(), "6=2,3\n", "6=1-4\n");
  EXPECT_THAT(document(dash).draft.treadling.back(), ElementsAre(1, 4));
  EXPECT_THAT(warningsOf(dash), ElementsAre(HasSubstr("6=1-4: Two numbers with a dash are read as those two")));
}

TEST(WifReader, ColoursAreReadAsTheyAreOftenWritten) {
  const auto read = [](const char* from, const char* to) { return document(replaced(twillFile(), from, to)); };
  for (const char* hex : {"2=#1122c8\n", "2=0x1122C8\n", "2=1122C8\n"})
    EXPECT_EQ(read("2=17,34,200\n", hex).rest.palette.colours.at(2), glm::ivec3(17, 34, 200)) << hex;
  EXPECT_EQ(read("Color=3\n", "Color=200,10,30\n").rest.palette.colours.at(5), glm::ivec3(200, 10, 30));
  EXPECT_THAT(read("Color=3\n", "Color=200,10,30\n").weftColours, testing::Each(5));
  EXPECT_THAT(warningsOf(replaced(twillFile(), "Color=3\n", "Color=200,10,30\n")),
              Contains(HasSubstr("without its number; it is read as red, green and blue")));
  const std::string bare =
      replaced(replaced(without("COLOR TABLE"), "Color=1\n", "Color=0,0,255\n"), "Color=3\n", "Color=255,0,0\n");
  const WifDocument d = document(bare);
  EXPECT_EQ(d.rest.palette.srgb(d.rest.palette.colours.at(d.warpColours[0])), Rgb(0, 0, 1));
  EXPECT_EQ(d.rest.palette.srgb(d.rest.palette.colours.at(d.weftColours[0])), Rgb(1, 0, 0));
  const std::string hsv =
      replaced(replaced(twillFile(), "Range=0,255", "Range=0,255\nForm=HSV"), "2=17,34,200\n", "2=170,255,102\n");
  EXPECT_EQ(document(hsv).rest.palette.colours.at(2), glm::ivec3(0, 0, 102)) << "a dark blue";
  EXPECT_EQ(document(hsv).rest.palette.colours.at(1), glm::ivec3(255, 0, 0)) << "hue 255 is that of 0";
}

TEST(WifReader, HuesInDegreesAreTold) {
  const std::string table = "1=255,255,255\n2=17,34,200\n3=0,0,0\n4=120,80,3\n";
  for (const char* range : {"Range=0,255\nForm=HSV", "Form=HSV"}) {
    const std::string text = replaced(replaced(twillFile(), "Range=0,255", range), table,
                                      "1=0,0,100\n2=240,100,50\n3=120,0,0\n4=300,100,100\n");
    const WifPalette palette = document(text).rest.palette;
    const auto shown = [&](int number) { return palette.srgb(palette.colours.at(number)); };
    constexpr float kHalfStep = 0.5f / 65535;
    for (const auto& [number, rgb] : {std::pair{1, Rgb(1)}, {2, Rgb(0, 0, 0.5f)}, {3, Rgb(0)}, {4, Rgb(1, 0, 1)}})
      EXPECT_LE(glm::length(shown(number) - rgb), kHalfStep) << range << ", " << number;
    EXPECT_THAT(warningsOf(text), Contains(HasSubstr("Hue is taken as degrees")));
  }
  const std::string outside =
      replaced(replaced(twillFile(), "Range=0,255", "Range=0,255\nForm=HSV"), "4=120,80,3\n", "4=300,255,255\n");
  EXPECT_THAT(warningsOf(outside), Contains(HasSubstr("4: The numbers of a colour go from 0 to 255")));
}

TEST(WifReader, AColourWithoutANumberTakesAFreeOne) {
  std::string text = replaced(twillFile(), "3=0,0,0\n4=120,80,3\n", "3=0,0,0\n65536=120,80,3\n");
  text = replaced(text, "Color=3\n", "Color=200,10,30\n");
  EXPECT_THAT(document(text).weftColours, testing::Each(65535));
  EXPECT_EQ(document(text).rest.palette.colours.at(65535), glm::ivec3(200, 10, 30));
  const WifDocument both = document(replaced(text, "Color=1\n", "Color=9,8,7\n") + "[WARP COLORS]\n1=\n");
  EXPECT_EQ(both.rest.palette.colours.at(65535), glm::ivec3(9, 8, 7));
  EXPECT_EQ(both.rest.palette.colours.at(65534), glm::ivec3(200, 10, 30));
  EXPECT_THAT(both.weftColours, testing::Each(65534));
  EXPECT_EQ(both.warpColours[0], 65535);
}

TEST(WifReader, AColourWithoutANumberIsNotWhatAnotherLineNames) {
  const WifDocument d =
      document(replaced(replaced(twillFile(), "Color=1\n", "Color=5\n"), "Color=3\n", "Color=9,8,7\n"));
  EXPECT_THAT(d.weftColours, testing::Each(6));
  EXPECT_EQ(d.rest.palette.colours.count(5), 0u) << "the warp's number has no colour";
}

TEST(WifReader, WhereNoNumberIsFreeAColourWithoutOneIsPassedOver) {
  std::string table = "[COLOR TABLE]\n";
  for (int number = 1; number <= kMaxWifNumber; ++number) table += std::to_string(number) + "=1,2,3\n";
  const std::string text = replaced(twillFile(), "Color=3\n", "Color=70000,10,30\n") + table;
  EXPECT_THAT(document(text).weftColours, testing::Each(0));
  EXPECT_THAT(warningsOf(text), Contains(HasSubstr("no number is free; it is passed over")));
}

TEST(WifReader, LikeWarningsAreCounted) {
  std::string text = twillFile() + "[WEFT COLORS]\n";
  for (int n = 0; n < 1000; ++n) text += "0=1\n";
  const std::vector<std::string> warnings = warningsOf(text);
  EXPECT_LT(warnings.size(), 6u);
  EXPECT_THAT(warnings, Contains(HasSubstr("and 998 more like this: ")));
}

TEST(WifReader, OtherFilesAreRefusedInPlainWords) {
  EXPECT_THAT(refusalOf(""), HasSubstr("x.wif: expected a WIF draft"));
  EXPECT_THAT(refusalOf("You are in a maze of twisty little passages.\n"), HasSubstr("expected a WIF draft"));
  EXPECT_THAT(refusalOf("[package]\nname = \"x\"\n"), HasSubstr("expected a WIF draft"));
  EXPECT_THAT(refusalOf("[WIF]\nVersion=1.1\n[COLOR TABLE]\n1=1,1,1\n"), HasSubstr("expected a draft"));
  EXPECT_THAT(refusalOf("[WIF]\n[WARP]\n[WEFT]\n"),
              HasSubstr("[WARP] Threads: expected from 1 to 16384 threads, got none"));
  EXPECT_THAT(refusalOf(std::string("[WIF]\n\0\0x", 9)), HasSubstr("it is binary"));
}

}  // namespace
}  // namespace loomlight
