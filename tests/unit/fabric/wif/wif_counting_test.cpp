#include "core/fabric/wif/wif_counting.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/unit/fabric/wif/wif_drafts.h"

namespace loomlight {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

/// The lines of some sections of a file with keys, values, or both one less.
std::string countedFromZero(const std::string& text, const std::vector<std::string>& sections, bool keys, bool values) {
  std::string made, section;
  for (size_t at = 0; at < text.size();) {
    const size_t end = text.find('\n', at);
    const std::string line = text.substr(at, end - at);
    at = end + 1;
    if (line.starts_with('[')) section = line.substr(1, line.size() - 2);
    const size_t equals = line.find('=');
    const bool chosen = std::find(sections.begin(), sections.end(), section) != sections.end();
    if (!chosen || equals == std::string::npos) {
      made += line + "\n";
      continue;
    }
    const auto less = [](const std::string& number) { return std::to_string(std::stoi(number) - 1); };
    const std::string key = line.substr(0, equals), value = line.substr(equals + 1);
    const size_t comma = value.find(',');
    std::string lessValue = values && comma == std::string::npos ? less(value) : value;
    if (values && comma != std::string::npos)
      lessValue = less(value.substr(0, comma)) + ',' + less(value.substr(comma + 1));
    made += (keys ? less(key) : key) + '=' + lessValue + "\n";
  }
  return made;
}

TEST(WifCounting, WhatHasALineZeroCountsFromIt) {
  const WifDocument expected = document(twillFile());
  const std::string treadles =
      countedFromZero(countedFromZero(twillFile(), {"TIEUP"}, true, false), {"TREADLING"}, false, true);
  EXPECT_EQ(document(treadles), expected);
  EXPECT_THAT(warningsOf(treadles),
              ElementsAre("[TIEUP]: Treadles are counted from 0 here, not from 1; they are read so."));
  EXPECT_EQ(document(countedFromZero(twillFile(), {"TIEUP"}, true, false)), expected)
      << "treadles pressed from 1, for there is no line 4 of the tie-up";
  const std::string threads =
      countedFromZero(twillFile(), {"THREADING", "TREADLING", "WARP COLORS", "WEFT SPACING"}, true, false);
  EXPECT_EQ(document(threads), expected) << threads;
  EXPECT_EQ(document(replaced(threads, "Threads=8", "Threads=")), expected) << "as many as there are lines";
  std::string all = countedFromZero(threads, {"TIEUP"}, true, true);
  all = countedFromZero(countedFromZero(all, {"THREADING", "TREADLING", "WARP COLORS"}, false, true), {"COLOR TABLE"},
                        true, false);
  all = replaced(replaced(all, "Color=1\n", "Color=0\n"), "Color=3\n", "Color=2\n");
  EXPECT_EQ(document(all), expected) << all;
  EXPECT_THAT(warningsOf(all), testing::SizeIs(5)) << "ends, picks, treadles, shafts, colours";
}

TEST(WifCounting, TreadlesOfOtherListsTellWhereTheyAreCountedFrom) {
  const std::string tied = countedFromZero(twillFile(), {"TIEUP"}, true, false);
  const std::string pressed = replaced(tied, "4=4\n5=1\n6=2,3\n", "4=3+4\n5=1\n6=2,3\n");
  EXPECT_THAT(document(pressed).draft.treadling[3], ElementsAre(3, 4)) << "a treadle 4: they count from 1";
}

TEST(WifCounting, ALineZeroBesideTheLastIsASlip) {
  const WifDocument expected = document(twillFile());
  for (const char* section : {"[THREADING]\n", "[TREADLING]\n", "[WARP COLORS]\n", "[COLOR TABLE]\n"}) {
    const std::string text = replaced(twillFile(), section, std::string(section) + "0=2\n");
    EXPECT_EQ(document(text), expected) << section;
    EXPECT_THAT(warningsOf(text),
                ElementsAre(testing::AnyOf(HasSubstr(" only; what is said of others"), HasSubstr("three numbers"))))
        << section;
  }
  EXPECT_EQ(document(replaced(twillFile(), "[TIEUP]\n", "[TIEUP]\n0=\n")), expected);
  EXPECT_EQ(document(replaced(twillFile(), "[TIEUP]\n", "[TIEUP]\n0=1,3\n")).draft.treadles, 5)
      << "something is tied to it: it is one of them";
}

TEST(WifCounting, KeptLinesOfThreadsAreHandedBackFromOne) {
  const std::string text = countedFromZero(twillFile(), {"THREADING", "WARP COLORS"}, true, false) +
                           "[WARP SYMBOLS]\n0='X'\n3=#219\n[WEFT SYMBOLS]\n2='O'\n";
  EXPECT_THAT(document(text).rest.kept, Contains(WifLines{"WARP SYMBOLS", {"1='X'", "4=#219"}}));
  EXPECT_THAT(document(text).rest.kept, Contains(WifLines{"WEFT SYMBOLS", {"2='O'"}}));
}

TEST(WifCounting, ColoursAndSizesMayCountFromOneWhereTheDraftDoesNot) {
  const std::string sizes = "[WARP THICKNESS]\n1=0.06\n8=0.05\n[WARP SYMBOLS]\n1='X'\n8='O'\n[WEFT COLORS]\n1=2\n6=4\n";
  const WifDocument expected = document(twillFile() + sizes);
  const std::string text = countedFromZero(twillFile() + sizes, {"THREADING", "TREADLING"}, true, false);
  EXPECT_EQ(document(replaced(text, "[WEFT SPACING]\n2=0.04\n", "[WEFT SPACING]\n1=0.04\n")), expected)
      << "two lines, neither 0 nor 6: they count as the draft does";
  EXPECT_EQ(document(text).warpColours, expected.warpColours);
  EXPECT_EQ(document(replaced(text, "Threads=8", "Threads=")).warpColours, expected.warpColours);
  EXPECT_THAT(warningsOf(text), Contains("[WARP COLORS]: Threads are counted from 1 here, though the draft counts them "
                                         "from 0; they are read so."));
}

}  // namespace
}  // namespace loomlight
