#include "core/fabric/wif/dtx_reader.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/fabric/json/fabric_json.h"
#include "core/fabric/wif/wif_fabric.h"
#include "core/fabric/wif/wif_writer.h"
#include "tests/unit/fabric/wif/wif_drafts.h"

namespace loomlight {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string dtxFile() {
  return R"(@@StartDTX
%%version 1

@@Description
Three shafts

@@Contents
Imprint
Info
EndDTX

@@Imprint
PCW 4.2 Silver

@@Info
%%shafts 3
%%treadles 4
%%ends 5
%%picks 3

@@Threading
 1  2  3
 3  1

@@Tieup
0011
0110
1100

@@Treadling
 1  2, 4  3

@@Color Palet
255,255,255
9,8,7
0,0,200

@@Warp Colors
0 2 0 2 1

@@Weft Spacing
4 8 4

@@Notes
first line
second line

@@EndDTX
)";
}

struct Read {
  WifDocument document;
  std::vector<std::string> warnings;
};

Read read(const std::string& text) {
  WifWarnings warnings;
  WifDocument document = readDtx(text, "x.dtx", warnings);
  return {std::move(document), inLines(warnings.list())};
}

TEST(DtxReader, ReadsADraft) {
  ASSERT_TRUE(isDtx(dtxFile()));
  EXPECT_FALSE(isDtx(twillFile()));
  const auto [d, warnings] = read(dtxFile());
  EXPECT_THAT(warnings, IsEmpty());
  EXPECT_EQ(d.title, "Three shafts");
  EXPECT_EQ(d.program, "Fiberworks PCW 4.2 Silver");
  EXPECT_THAT(d.notes, ElementsAre("first line", "second line"));
  EXPECT_EQ(d.draft.shafts, 3);
  EXPECT_EQ(d.draft.treadles, 4);
  EXPECT_TRUE(d.draft.risingShed);
  EXPECT_EQ(d.draft.threading, (std::vector<std::vector<int>>{{1}, {2}, {3}, {3}, {1}}));
  EXPECT_EQ(d.draft.tieUp, (std::vector<std::vector<int>>{{1}, {1, 2}, {2, 3}, {3}})) << "the last row is shaft 1";
  EXPECT_EQ(d.draft.treadling, (std::vector<std::vector<int>>{{1}, {2, 4}, {3}}));
  EXPECT_THAT(d.warpColours, ElementsAre(1, 3, 1, 3, 2)) << "written from 0";
  EXPECT_THAT(d.weftColours, testing::Each(2));
  EXPECT_EQ(d.rest.weft.spacings, (std::map<int, double>{{1, 0.212}, {2, 0.424}, {3, 0.212}}));
  EXPECT_TRUE(d.rest.warp.spacings.empty());
}

TEST(DtxReader, ADescriptionOfSeveralLinesIsKept) {
  const std::string text = replaced(dtxFile(), "Three shafts\n", "Three shafts,\n\n  after an old book\n");
  EXPECT_EQ(read(text).document.title, "Three shafts, after an old book");
  EXPECT_EQ(read(replaced(dtxFile(), "Three shafts\n", "")).document.title, "");
}

TEST(DtxReader, ASinkingShedAndALiftplan) {
  EXPECT_FALSE(read(replaced(dtxFile(), "@@Tieup\n", "@@Tieup\n%%%%sinking\n")).document.draft.risingShed);
  const std::string lifts = replaced(dtxFile(), "@@Treadling\n 1  2, 4  3\n", "@@Liftplan\n101\n010\n111\n");
  EXPECT_EQ(read(lifts).document.draft.liftplan, (std::vector<std::vector<int>>{{1, 3}, {2}, {1, 2, 3}}));
}

TEST(DtxReader, BecomesAFabricAndAWifDraft) {
  const WifImport import = fabricFromWif(dtxFile(), "x.dtx", Fabric{}, WifSizeChoice::keep);
  EXPECT_EQ(import.fabric.weave, drawdown(read(dtxFile()).document.draft));
  EXPECT_NE(import.fabric.weftYarn(1), import.fabric.weftYarn(0)) << "the second pick takes twice the room";
  const WifDocument wif = document(wifFromFabric(import.fabric, "y.wif").text);
  EXPECT_EQ(wif.draft, import.fabric.draft);
  EXPECT_EQ(wif.warpColours, read(dtxFile()).document.warpColours);
  EXPECT_EQ(wif.rest.weft, read(dtxFile()).document.rest.weft);
}

TEST(DtxReader, WhatIsWrongIsSaidOrRefused) {
  EXPECT_THAT(read(replaced(dtxFile(), "9,8,7", "9,8")).warnings, Contains(HasSubstr("three numbers from 0 to 255")));
  EXPECT_EQ(read(replaced(dtxFile(), "%%picks 3", "%%picks 90")).document.named.picks, 3);
  EXPECT_THAT(read(replaced(dtxFile(), "0110\n", "01x0\n")).warnings, Contains(HasSubstr("0 or 1 should stand here")));
  EXPECT_EQ(read(replaced(dtxFile(), "%%ends 5", "%%ends 99999999")).document.ends(), 5);
  const auto refusal = [](const std::string& text) {
    try {
      read(text);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THAT(refusal("@@StartDTX\n@@Notes\nnothing\n"), HasSubstr("x.dtx: expected a draft"));
  std::string many = "@@StartDTX\n@@Threading\n";
  for (int i = 0; i < 20000; ++i) many += "1 ";
  EXPECT_THAT(refusal(many), HasSubstr("x.dtx: @@Info ends: expected from 1 to 16384"));
}

/// A draft as that program writes it: of one shaft an end, and one treadle or more a pick.
std::string written(const WifDocument& d) {
  const Draft& draft = d.draft;
  std::string text = fmt::format("@@StartDTX\n@@Info\n%%shafts {}\n%%treadles {}\n%%ends {}\n%%picks {}\n@@Threading\n",
                                 draft.shafts, draft.treadles, d.ends(), d.picks());
  for (const auto& shafts : draft.threading) text += fmt::format("{} ", shafts.empty() ? 0 : shafts[0]);
  const auto rows = [](const std::vector<std::vector<int>>& lists, int columns) {
    std::string all;
    for (const auto& list : lists) {
      std::string row(static_cast<size_t>(columns), '0');
      for (const int n : list) row[static_cast<size_t>(n) - 1] = '1';
      all += row + "\n";
    }
    return all;
  };
  if (!draft.liftplan.empty()) text += "\n@@Liftplan\n" + rows(draft.liftplan, draft.shafts);
  if (!draft.treadling.empty()) {
    text += "\n@@Treadling\n";
    for (const auto& pressed : draft.treadling)
      text += pressed.empty() ? "0 " : fmt::format("{} ", fmt::join(pressed, ", "));
    text += std::string("\n@@Tieup\n") + (draft.risingShed ? "" : "%%%%sinking\n");
    for (int shaft = draft.shafts; shaft >= 1; --shaft) {
      for (const auto& tied : draft.tieUp) text += std::find(tied.begin(), tied.end(), shaft) != tied.end() ? '1' : '0';
      text += "\n";
    }
  }
  return text + "@@EndDTX\n";
}

TEST(DtxReader, AnyDraftComesBack) {
  Random random(21);
  for (int i = 0; i < 500; ++i) {
    WifDocument d = randomDocument(random);
    for (auto& shafts : d.draft.threading)
      if (shafts.size() > 1) shafts = std::vector<int>(1, shafts[0]);
    if (d.draft.treadling.empty()) d.draft.treadles = 0;
    const Draft drafted = read(written(d)).document.draft;
    ASSERT_EQ(drafted.threading, d.draft.threading) << written(d);
    ASSERT_EQ(drafted.liftplan, d.draft.liftplan) << written(d);
    ASSERT_EQ(drafted.treadling, d.draft.treadling) << written(d);
    ASSERT_EQ(drafted.tieUp, d.draft.tieUp) << written(d);
    if (!d.draft.treadling.empty()) {
      ASSERT_EQ(drafted.risingShed, d.draft.risingShed) << written(d);
    }
  }
}

TEST(HostileDtx, ChangedFilesAreReadOrRefused) {
  const char* const pieces[] = {"@@",
                                "%%",
                                "\n",
                                ",",
                                "0",
                                "1",
                                "99999999999",
                                "-1",
                                "@@Threading\n",
                                "@@Tieup\n",
                                "@@Liftplan\n",
                                "%%ends 16384\n",
                                "%%picks 99999\n",
                                "[WIF]\n",
                                "]",
                                "@@P]x\nline\n",
                                "\xFF"};
  Random random(22);
  for (int i = 0; i < 1000; ++i) {
    std::string text = dtxFile();
    for (uint32_t k = 0; k <= random.below(6); ++k) {
      const uint32_t at = 12 + random.below(static_cast<uint32_t>(text.size() - 12));
      if (random.below(3) == 0)
        text.erase(at, 1 + random.below(30));
      else if (random.below(2) == 0)
        text.insert(at, pieces[random.below(std::size(pieces))]);
      else
        text[at] = static_cast<char>(1 + random.below(255));
      text.resize(std::max<size_t>(text.size(), 20), ' ');
    }
    try {
      const WifImport import = fabricFromWif(text, "x.dtx", Fabric{}, WifSizeChoice::file);
      EXPECT_EQ(fabricFromJson(fabricToJson(import.fabric), "x.json"), import.fabric) << text;
      const Fabric again =
          fabricFromWif(wifFromFabric(import.fabric, "y.wif").text, "y.wif", Fabric{}, WifSizeChoice::file).fabric;
      EXPECT_EQ(again.weave, import.fabric.weave) << text;
    } catch (const InputError& error) {
      EXPECT_THAT(std::string(error.what()).substr(0, 2), "x.") << text;
    }
    if (HasFailure()) return;
  }
}

TEST(DtxReader, NamesOfOwnSectionsAreCutBetweenLetters) {
  std::string name = "odd";
  for (int i = 0; i < 20; ++i) name += "\xC2\xB9";
  WifWarnings warnings;
  WifDocument read = readDtx(dtxFile() + "\n@@" + name + "\nsomething\n@@EndDTX\n", "x.dtx", warnings);
  WifDocument again = readWif(wifFromDocument(read), "x.wif", warnings);
  again.program = read.program;
  EXPECT_EQ(again.rest.kept, read.rest.kept);
  EXPECT_EQ(read.rest.kept.back().section, "PRIVATE DTX " + name.substr(0, 39));
}

}  // namespace
}  // namespace loomlight
