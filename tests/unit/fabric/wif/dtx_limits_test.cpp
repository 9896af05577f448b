/// Drafts of Fiberworks of more shafts and treadles than a loom has: the cloth is the same, or the draft is refused.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

#include "core/fabric/wif/wif_fabric.h"
#include "tests/unit/fabric/wif/wif_drafts.h"

namespace loomlight {
namespace {

using testing::Contains;
using testing::HasSubstr;

constexpr int kMany = 5000;  // shafts, or treadles

std::string section(const char* name, const std::string& lines) {
  return fmt::format("@@{}\n{}\n", name, lines);
}

std::string countedTo(int last) {
  std::vector<int> numbers(static_cast<size_t>(last));
  std::iota(numbers.begin(), numbers.end(), 1);
  return fmt::format("{}", fmt::join(numbers, " "));
}

/// 1 in each second column: in the first, or in the second and so on.
std::string alternating(int columns, int first) {
  std::string row(static_cast<size_t>(columns), '0');
  for (size_t i = static_cast<size_t>(first); i < row.size(); i += 2) row[i] = '1';
  return row;
}

WifImport opened(const std::string& sections) {
  return fabricFromWif("@@StartDTX\n" + sections + "@@EndDTX\n", "x.dtx", Fabric{}, WifSizeChoice::keep);
}

std::string refusedFor(const std::string& sections) {
  try {
    opened(sections);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// Plain weave, the first end up in pick `up`.
void expectPlain(const Weave& weave, int picks, int ends, int up) {
  ASSERT_EQ(weave.picks(), picks);
  ASSERT_EQ(weave.ends(), ends);
  for (int p = 0; p < picks; ++p)
    for (int e = 0; e < ends; ++e) ASSERT_EQ(weave.at(p, e), (p + e) % 2 == up) << "pick " << p << ", end " << e;
}

TEST(DtxLimits, ShaftsOfALiftplanAreMergedByNeed) {
  const WifImport import = opened(section("Threading", countedTo(kMany)) +
                                  section("Liftplan", alternating(kMany, 0) + "\n" + alternating(kMany, 1) + "\n"));
  expectPlain(import.fabric.weave, 2, kMany, 0);
  EXPECT_EQ(import.fabric.draft->shafts, 2);
  EXPECT_THAT(inLines(import.warnings), Contains(HasSubstr("The draft names 5000 shafts, and there can be 4096")));
}

TEST(DtxLimits, ShaftsOfATieUpAreMergedByNeed) {
  std::string rows;  // the last is shaft 1
  for (int shaft = kMany; shaft >= 1; --shaft) rows += shaft % 2 == 1 ? "10\n" : "01\n";
  const std::string threading = section("Threading", countedTo(kMany)), treadling = section("Treadling", "1 2");
  const WifImport import = opened(threading + treadling + section("Tieup", rows));
  expectPlain(import.fabric.weave, 2, kMany, 0);
  EXPECT_EQ(import.fabric.draft->shafts, 2);
  EXPECT_THAT(inLines(import.warnings), Contains(HasSubstr("The draft names 5000 shafts, and there can be 4096")));
  expectPlain(opened(threading + treadling + section("Tieup", "%%sinking\n" + rows)).fabric.weave, 2, kMany, 1);
}

TEST(DtxLimits, OfTreadlesBeyondADraftsTheLiftsAreKept) {
  const WifImport import = opened(section("Threading", "1 2") + section("Treadling", countedTo(kMany)) +
                                  section("Tieup", alternating(kMany, 1) + "\n" + alternating(kMany, 0)));
  expectPlain(import.fabric.weave, kMany, 2, 0);
  EXPECT_THAT(inLines(import.warnings),
              Contains(HasSubstr("[treadling]: The draft uses 5000 treadles, and there can be 4096")));
}

TEST(DtxLimits, LiftsThatAreLeftOutAreTold) {
  const std::string threading = section("Threading", "1 2");
  const std::string liftplan = section("Liftplan", alternating(kMany, 0) + "\n" + alternating(kMany, 1));
  const WifImport import = opened(threading + liftplan);
  expectPlain(import.fabric.weave, 2, 2, 0);
  EXPECT_THAT(inLines(import.warnings), Contains(HasSubstr("Shafts up to 5000 are lifted, and there can be 4096; no "
                                                           "end hangs on those beyond, which are left out.")));
}

TEST(DtxLimits, AStatedNumberThatNoDraftHasIsSaid) {
  const std::string draft = section("Threading", "1 2") + section("Treadling", "1 2") + section("Tieup", "01\n10");
  const WifImport import = opened(section("Info", "%%shafts 5000\n%%treadles 6000") + draft);
  EXPECT_EQ(import.fabric.draft, opened(draft).fabric.draft);
  const std::vector<std::string> warnings = inLines(import.warnings);
  EXPECT_THAT(warnings, Contains("[info] shafts 5000: There can be 4096 shafts; the draft uses 2."));
  EXPECT_THAT(warnings, Contains("[info] treadles 6000: There can be 4096 treadles; the draft uses 2."));
}

TEST(DtxLimits, MoreThanAClothHasThreadsIsRefusedByNumber) {
  const std::string threading = section("Threading", "1 2"), treadling = section("Treadling", "1 2");
  const std::string wide = alternating(20'000, 0);
  EXPECT_EQ(refusedFor(threading + section("Liftplan", "01\n" + wide)),
            "x.dtx: @@liftplan: expected at most 16384 columns, got 20000");
  EXPECT_EQ(refusedFor(threading + treadling + section("Tieup", wide)),
            "x.dtx: @@tieup: expected at most 16384 columns, got 20000");
  std::string rows;
  for (int row = 0; row < 20'000; ++row) rows += "01\n";
  EXPECT_EQ(refusedFor(threading + treadling + section("Tieup", rows)),
            "x.dtx: @@tieup: expected at most 16384 rows, got 20000");
}

TEST(DtxLimits, ShaftsThatAllDifferAreRefusedByNumber) {
  std::string lifts;
  for (int bit = 0; bit < 13; ++bit) {
    for (int shaft = 0; shaft < kMany; ++shaft) lifts += (shaft >> bit) % 2 == 1 ? '1' : '0';
    lifts += '\n';
  }
  EXPECT_EQ(refusedFor(section("Threading", countedTo(kMany)) + section("Liftplan", lifts)),
            "x.dtx: @@threading: expected at most 4096 shafts that differ, got more among 5000");
}

// One by one, those of a large file would take long.
TEST(DtxLimits, OtherSignsOfARowAreSaidOnce) {
  const WifImport import =
      opened(section("Threading", "1 2") + section("Treadling", "1 2") + section("Tieup", "0xxxx\n1"));
  EXPECT_THAT(inLines(import.warnings),
              Contains("[tieup] 0xxxx: 0 or 1 should stand here; other signs are taken as 0."));
}

// Nobody hangs an end on so high a shaft; where a file says so, its end hangs on none, and that is said.
TEST(DtxLimits, NumbersBeyondAClothsThreadsAreSaid) {
  const WifImport import = opened(section("Threading", "1 16385") + section("Liftplan", "1\n0"));
  EXPECT_THAT(inLines(import.warnings), Contains(HasSubstr("[threading] 16385: Numbers from 0 to 16384")));
}

}  // namespace
}  // namespace loomlight
