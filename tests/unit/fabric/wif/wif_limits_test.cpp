/// Drafts of more shafts and treadles than a loom has.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>

#include "core/base/error.h"
#include "core/fabric/model/wif_origin.h"
#include "core/fabric/wif/wif_fabric.h"
#include "tests/support/scratch_folder.h"
#include "tests/unit/fabric/wif/wif_drafts.h"

namespace loomlight {
namespace {

using testing::Contains;
using testing::HasSubstr;

// A jacquard's hooks, each end its own: no draft has as many, but what goes together can be one.
TEST(WifLimits, ShaftsBeyondADraftsAreMergedByNeed) {
  constexpr int kHooks = 6000;
  std::string text = fmt::format("[WIF]\n[WEAVING]\nRising Shed=1\n[WARP]\nThreads={}\n[WEFT]\nThreads=2\n", kHooks);
  std::string threading = "[THREADING]\n", lifts[2] = {"[LIFTPLAN]\n1=", "\n2="};
  for (int end = 1; end <= kHooks; ++end) {
    threading += fmt::format("{0}={0}\n", end);
    lifts[end % 2] += fmt::format("{}{}", end > 2 ? "," : "", end);
  }
  const WifImport import =
      fabricFromWif(text + threading + lifts[0] + lifts[1], "x.wif", Fabric{}, WifSizeChoice::keep);
  ASSERT_EQ(import.fabric.weave.ends(), kHooks);
  for (int end = 0; end < kHooks; ++end) ASSERT_EQ(import.fabric.weave.at(0, end), end % 2 == 1) << end;
  EXPECT_EQ(import.fabric.draft->shafts, 2);
  EXPECT_THAT(inLines(import.warnings), Contains(HasSubstr("The draft names 6000 shafts, and there can be 4096")));
}

TEST(WifLimits, OfTreadlesBeyondADraftsTheLiftsAreKept) {
  constexpr int kTreadles = 5000;
  std::string text = "[WIF]\n[WEAVING]\nRising Shed=1\nShafts=2\nTreadles=5000\n[WARP]\nThreads=2\n[WEFT]\n";
  text += fmt::format("Threads={}\n[THREADING]\n1=1\n2=2\n", kTreadles);
  std::string tieUp = "[TIEUP]\n", treadling = "[TREADLING]\n";
  for (int treadle = 1; treadle <= kTreadles; ++treadle) {
    tieUp += fmt::format("{}={}\n", treadle, 1 + treadle % 2);
    treadling += fmt::format("{0}={0}\n", treadle);
  }
  const WifImport import = fabricFromWif(text + tieUp + treadling, "x.wif", Fabric{}, WifSizeChoice::keep);
  for (int pick = 0; pick < kTreadles; ++pick) ASSERT_EQ(import.fabric.weave.at(pick, 0), (pick + 1) % 2 == 0) << pick;
  EXPECT_THAT(inLines(import.warnings), Contains(HasSubstr("The draft uses 5000 treadles, and there can be 4096")));
  EXPECT_THAT(inLines(import.warnings), testing::Not(Contains(HasSubstr("another number"))));
}

TEST(WifLimits, LiftsThatAreLeftOutAreTold) {
  const std::string text =
      "[WIF]\n[WEAVING]\nRising Shed=1\n[WARP]\nThreads=2\n[WEFT]\nThreads=2\n[THREADING]\n1=1\n2=2\n"
      "[LIFTPLAN]\n1=1,5000\n2=2\n";
  const WifImport import = fabricFromWif(text, "x.wif", Fabric{}, WifSizeChoice::keep);
  EXPECT_THAT(inLines(import.warnings), Contains(HasSubstr("no end hangs on those beyond, which are left out")));
}

TEST(WifLimits, TooManyShaftsAreRefusedByNumber) {
  std::vector<Weave::Row> rows(13, Weave::Row(5000, 0));
  for (int e = 0; e < 5000; ++e)
    for (int bit = 0; bit < 13; ++bit) rows[bit][e] = (e >> bit) & 1;
  Fabric fabric;
  fabric.weave = Weave(rows);
  try {
    wifFromFabric(fabric, "y.wif");
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "y.wif: draft.shafts: expected a whole number from 0 to 4096, got 5000");
  }
}

TEST(WifLimits, AColourBeyondTheLastNumberIsRefusedByItsSection) {
  Fabric fabric = imported(twillFile());
  auto full = std::make_shared<WifOrigin>(*fabric.wif);
  for (int number = 1; number <= kMaxWifNumber; ++number) full->rest.palette.colours.try_emplace(number, 0, 0, 0);
  fabric.wif = full;
  fabric.fibres[fabric.yarns[fabric.weftYarn(0)].fibre].absorption_per_mm = Rgb(9, 4, 1);
  EXPECT_EQ(test::messageOf<InputError>([&] { wifFromFabric(fabric, "y.wif"); }),
            "y.wif: [COLOR TABLE]: expected a free number up to 65536 for another colour, got none");
}

}  // namespace
}  // namespace loomlight
