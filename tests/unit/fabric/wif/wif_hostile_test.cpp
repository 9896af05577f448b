#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/fabric/json/fabric_json.h"
#include "core/fabric/wif/wif_fabric.h"
#include "core/fabric/wif/wif_writer.h"
#include "tests/unit/fabric/wif/wif_drafts.h"

namespace loomlight {
namespace {

using testing::HasSubstr;

/// Reads or refuses, and what is read can be written and read again.
void expectSurvived(const std::string& bytes) {
  try {
    const WifImport import = fabricFromWif(bytes, "x.wif", Fabric{}, WifSizeChoice::file);
    EXPECT_LT(import.warnings.size(), 400u);
    for (const std::string& warning : inLines(import.warnings)) EXPECT_LT(warning.size(), 500u) << warning;
    const std::string text = wifFromFabric(import.fabric, "y.wif").text;
    const Fabric again = fabricFromWif(text, "y.wif", Fabric{}, WifSizeChoice::file).fabric;
    EXPECT_EQ(again.weave, import.fabric.weave);
    EXPECT_EQ(fabricFromJson(fabricToJson(import.fabric), "x.json"), import.fabric);
  } catch (const InputError& error) {
    const std::string said = error.what();
    EXPECT_THAT(said.substr(0, 2), testing::AnyOf("x.", "y.")) << said;
    EXPECT_LT(said.size(), 600u);
  }
}

TEST(HostileWif, ChangedFilesAreReadOrRefused) {
  // Pieces that mean something, put in the place of others.
  const char* const pieces[] = {"=",
                                ",",
                                "\n",
                                "[",
                                "]",
                                ";",
                                "-1",
                                "0",
                                "999999999",
                                "99",
                                "[WIF]",
                                "[LIFTPLAN]\n",
                                "1=1,2\n",
                                "\"",
                                "\xFF",
                                "e9",
                                " ",
                                "\r",
                                ".",
                                "2=",
                                "[WARP]\n",
                                "Threads=",
                                "yes",
                                "inches",
                                "PRIVATE ",
                                "\t\\",
                                "Range=3,",
                                "Form=HSV\n",
                                "0=",
                                "2-",
                                "+3",
                                ";4",
                                "#a0b1c2",
                                "Color=1,2,3\n",
                                "[TIEUP]\n0=1,0\n"};
  Random random(7);
  for (int i = 0; i < 3000; ++i) {
    std::string text = i % 2 ? twillFile() : wifFromDocument(randomDocument(random));
    for (uint32_t k = 0; k <= random.below(6); ++k) {
      const uint32_t at = random.below(static_cast<uint32_t>(text.size()));
      switch (random.below(5)) {
        case 0:
          text[at] = static_cast<char>(1 + random.below(255));
          break;
        case 1:
          text.insert(at, pieces[random.below(std::size(pieces))]);
          break;
        case 2:
          text.erase(at, 1 + random.below(40));
          break;
        case 3:
          text.insert(at, text.substr(random.below(static_cast<uint32_t>(text.size())), random.below(60)));
          break;
        default:
          text.resize(at + 1);
      }
    }
    expectSurvived(text);
    if (HasFailure()) {
      ADD_FAILURE() << "file " << i << ":\n" << text;
      return;
    }
  }
}

TEST(HostileWif, EveryTruncation) {
  const std::string text = twillFile();
  for (size_t length = 0; length < text.size(); length += 3) expectSurvived(text.substr(0, length));
}

TEST(HostileWif, RandomBytes) {
  Random random(8);
  for (int i = 0; i < 200; ++i) {
    std::string bytes(random.below(4000), ' ');
    for (char& c : bytes) c = static_cast<char>(random.below(256));
    expectSurvived(bytes);
    expectSurvived("\xFF\xFE" + bytes);
    for (char& c : bytes) c = c == '\0' ? '\n' : c;
    expectSurvived("[WARP]\n" + bytes);
  }
}

TEST(HostileWif, HugeNumbersTakeNoMemory) {
  for (const char* number : {"2147483647", "4294967297", "-2147483648", "99999999999999999999", "1e18", "16385"}) {
    std::string text = twillFile();
    for (const char* key : {"Threads=8", "Threads=6", "Shafts=4", "Treadles=4", "Entries=4"})
      text = replaced(text, key, std::string(key).substr(0, std::string(key).find('=') + 1) + number);
    const Fabric fabric = fabricFromWif(text, "x.wif", Fabric{}, WifSizeChoice::keep).fabric;
    EXPECT_EQ(fabric.weave.ends(), 8) << number;
    EXPECT_EQ(fabric.weave.picks(), 6) << number;
    EXPECT_EQ(fabric.draft->shafts, 4) << number;
    for (const char* section : {"THREADING", "TREADLING", "TIEUP", "COLOR TABLE", "WARP COLORS", "NOTES", "LIFTPLAN"})
      expectSurvived(twillFile() + fmt::format("[{0}]\n{1}=1,2,3\n1={1},{1},{1}\n", section, number));
  }
}

TEST(HostileWif, ADraftOfAHundredThousandLinesIsRead) {
  std::string text = "[WIF]\nVersion=1.1\n[WEAVING]\nShafts=8\nTreadles=8\nRising Shed=1\n";
  constexpr int kThreads = Weave::kMaxSide;
  text += fmt::format("[WARP]\nThreads={0}\nColor=1\n[WEFT]\nThreads={0}\nColor=2\n", kThreads);
  text += "[COLOR PALETTE]\nRange=0,255\nEntries=2\n[COLOR TABLE]\n1=255,255,255\n2=1,2,3\n[TIEUP]\n";
  for (int t = 1; t <= 8; ++t) text += fmt::format("{}={},{}\n", t, t, t % 8 + 1);
  for (const char* section : {"THREADING", "TREADLING"}) {
    text += fmt::format("[{}]\n", section);
    for (int n = 1; n <= kThreads; ++n) text += fmt::format("{}={}\n", n, n % 8 + 1);
  }
  for (const char* section : {"WARP COLORS", "WEFT COLORS", "WARP SPACING", "WEFT SPACING"}) {
    text += fmt::format("[{}]\n", section);
    for (int n = 1; n <= kThreads; ++n) text += fmt::format("{}={}\n", n, n % 2 + 1);
  }
  const WifDocument d = document(text);
  EXPECT_EQ(d.ends(), kThreads);
  EXPECT_EQ(d.picks(), kThreads);
  EXPECT_EQ(document(wifFromDocument(d)).draft, d.draft);
}

TEST(HostileWif, MoreThreadsThanAWeaveHasAreRefused) {
  std::string text = "[WIF]\n[WARP]\nThreads=20000\n[WEFT]\nThreads=2\n[THREADING]\n";
  for (int n = 1; n <= 20000; ++n) text += fmt::format("{}=1\n", n);
  EXPECT_EQ(refusalOf(text), "x.wif: [WARP] Threads: expected from 1 to 16384 threads, got 20000");
}

TEST(HostileWif, MillionsOfLinesSectionsAndSlips) {
  std::string lines = "[WARP]\n", sections = "[WARP]\n", going = "[THREADING]\n1=1,\n";
  for (int i = 0; i < 2'100'000; ++i) lines += "x\n";
  for (int i = 0; i < 5000; ++i) sections += fmt::format("[P {}]\n", i);
  for (int i = 0; i < 100'000; ++i) going += "2,\n";
  EXPECT_THAT(refusalOf(lines), HasSubstr("expected at most 2000000 lines"));
  EXPECT_THAT(refusalOf(sections), HasSubstr("expected at most 4096 sections"));
  EXPECT_EQ(document(going + "[WARP]\nThreads=1\n[WEFT]\nThreads=1\n").draft.threading[0], (std::vector<int>{1, 2}));
  std::string slips = "[WARP]\nThreads=5\n[WEFT]\nThreads=5\n[THREADING]\n";
  for (int i = 0; i < 300'000; ++i) slips += "slip\n";
  EXPECT_LT(warningsOf(slips).size(), 20u);
}

TEST(HostileWif, LinesOfAFabricFileHaveToBeRight) {
  const auto complaint = [](const std::string& wif) {
    try {
      fabricFromJson("{\"loomlight_version\": 1, \"wif\": " + wif + "}", "x.json");
      return std::string();
    } catch (const InputError& error) {
      return std::string(error.what());
    }
  };
  EXPECT_EQ(complaint("{}"), "");
  EXPECT_EQ(complaint("[]"), "x.json: wif: expected an object, got a list");
  EXPECT_THAT(complaint("{\"lines\": 7}"), HasSubstr("x.json: wif.lines: expected a list of texts"));
  EXPECT_THAT(complaint("{\"lines\": [7]}"), HasSubstr("x.json: wif.lines: expected texts, got 7"));
  EXPECT_THAT(complaint("{\"lines\": [\"[COLOR TABLE]\", \"oops\"]}"), HasSubstr("expected lines as in a WIF draft"));
  EXPECT_EQ(complaint("{\"lines\": [\"[PRIVATE A]\", \"b=\\u0000\"]}"),
            "x.json: wif.lines: expected texts, got one with a NUL character");
  std::string sections;
  for (int i = 0; i < 5000; ++i) sections += fmt::format("\"[P {}]\", ", i);
  EXPECT_EQ(complaint("{\"lines\": [" + sections + "\"\"]}"), "x.json: wif.lines: expected at most 4096 sections");
  EXPECT_THAT(complaint("{\"yarns\": 3}"), HasSubstr("x.json: wif.yarns: expected a list of objects"));
  EXPECT_THAT(complaint("{\"yarns\": [{\"colour\": -1}]}"), HasSubstr("x.json: wif.yarns[0].colour: expected"));
  std::string yarns;
  for (int i = 0; i < 64; ++i) yarns += "{}, ";
  EXPECT_THAT(complaint("{\"yarns\": [" + yarns + "{}]}"), HasSubstr("x.json: wif.yarns: expected at most 64"));
  EXPECT_THAT(complaint("{\"ends\": -3}"), HasSubstr("x.json: wif.ends: expected a whole number"));
}

}  // namespace
}  // namespace loomlight
