#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/fabric/json/fabric_json.h"
#include "tests/unit/fabric/json/fabric_with.h"

namespace loomlight {
namespace {

std::string repeated(const std::string& text, size_t times) {
  std::string all;
  all.reserve(text.size() * times);
  for (size_t i = 0; i < times; ++i) all += text;
  return all;
}

/// Refused with a message, and a short one: never a crash, a hang, or another exception.
void expectRefused(const std::string& text, const std::string& what) {
  try {
    fabricFromJson(text, "x.json");
    ADD_FAILURE() << what << " was accepted";
  } catch (const InputError& error) {
    const std::string said = error.what();
    EXPECT_EQ(said.rfind("x.json: ", 0), 0u) << what << ": " << said;
    EXPECT_LT(said.size(), 600u) << what;
    EXPECT_EQ(said.find("exception"), std::string::npos) << what << ": " << said;
    for (const char c : said) EXPECT_TRUE(c >= 0x20 && c < 0x7F) << what << ": " << said;
  }
}

TEST(HostileJson, NotJsonAtAll) {
  expectRefused("", "nothing");
  expectRefused(" \n\t", "white space");
  expectRefused("null", "null");
  expectRefused("42", "a number");
  expectRefused("[]", "a list");
  expectRefused("\"text\"", "a text");
  expectRefused("[WIF]\nVersion=1.1\n", "a WIF draft");
  expectRefused("\x89PNG\r\n\x1a\n", "a picture");
  expectRefused(std::string(1000, '\0'), "zeros");
  expectRefused("{\"name\": \"\xff\xfe\"}", "no UTF-8");
  expectRefused("{'loomlight_version': 1}", "other quotes");
  expectRefused("{\"loomlight_version\": 1,}", "a comma too many");
  expectRefused(test::fabricWith("\"name\": \"a\" /* note */"), "a comment");
}

TEST(HostileJson, RandomBytes) {
  Random random(1);
  for (int file = 0; file < 200; ++file) {
    std::string bytes(random.below(4000), ' ');
    for (char& c : bytes) c = static_cast<char>(random.below(256));
    expectRefused(bytes, "random bytes");
  }
}

TEST(HostileJson, EveryTruncationOfAFile) {
  const std::string text = fabricToJson(Fabric{});
  for (size_t length = 0; length + 2 < text.size(); ++length) expectRefused(text.substr(0, length), "a truncated file");
}

TEST(HostileJson, ChangedBytesAreReadOrRefused) {
  const std::string text = fabricToJson(Fabric{});
  Random random(2);
  for (int i = 0; i < 3000; ++i) {
    std::string changed = text;
    for (uint32_t k = 0; k <= random.below(3); ++k)
      changed[random.below(static_cast<uint32_t>(changed.size()))] = static_cast<char>(random.below(256));
    try {
      const Fabric fabric = fabricFromJson(changed, "x.json");
      EXPECT_EQ(fabricFromJson(fabricToJson(fabric), "x.json"), fabric);
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).rfind("x.json: ", 0), 0u) << error.what();
    }
  }
}

TEST(HostileJson, DeepNesting) {
  const std::vector<std::string> openings = {"[", "{\"a\":", "[{\"a\":"};
  for (const std::string& opening : openings) {
    expectRefused(repeated(opening, 2'000'000), "deep nesting");
    expectRefused(test::fabricWith("\"x\": " + repeated(opening, 100'000)), "deep nesting inside");
  }
}

TEST(HostileJson, ModerateNestingOfUnknownKeysIsKept) {
  const std::string text = test::fabricWith("\"x\": " + std::string(60, '[') + std::string(60, ']'));
  const Fabric fabric = fabricFromJson(text, "x.json");
  EXPECT_EQ(fabricToJson(fabricFromJson(fabricToJson(fabric), "x.json")), fabricToJson(fabric));
}

TEST(HostileJson, NumbersBeyondAllRanges) {
  for (const std::string number :
       {"1e400", "-1e400", "1e308", "-1e308", "99999999999999999999", "1e-400", "-0.0000001", "2147483648"})
    expectRefused(test::fabricWith("\"ends_per_cm\": " + number), number);
  expectRefused(test::fabricWith("\"ends_per_cm\": NaN"), "NaN");
  expectRefused(test::fabricWith("\"ends_per_cm\": Infinity"), "Infinity");
  expectRefused(test::fabricWith("\"ends_per_cm\": " + std::string(100'000, '9')), "a number of 100000 digits");
  expectRefused(test::fabricWith("\"yarns\": [{\"plies\": 1e300}]"), "a huge whole number");
  expectRefused(test::fabricWith("\"yarns\": [{\"plies\": 4294967297}]"), "a number that would wrap to 1");
  expectRefused(test::fabricWith("\"warp_sequence\": [1e19]"), "a huge index");
  expectRefused(test::fabricWith("\"render\": {\"seed\": 18446744073709551616}"), "a seed of 65 bits");
  expectRefused(test::fabricWith("\"loomlight_version\": 1"), "two versions");
  expectRefused("{\"loomlight_version\": 1e18}", "a huge version");
}

TEST(HostileJson, WrongTypesEverywhere) {
  const std::set<std::pair<std::string, std::string>> fitting = {
      {"name", "\"\""}, {"description", "\"\""}, {"yarns", "[{}]"}, {"fibres", "[{}]"},    {"drape", "{}"},
      {"light", "{}"},  {"camera", "{}"},        {"render", "{}"},  {"warp_spacing", "[]"}};
  for (const std::string key :
       {"name", "description", "weave", "draft", "ends_per_cm", "picks_per_cm", "warp_sequence", "weft_sequence",
        "warp_spacing", "yarns", "fibres", "drape", "light", "camera", "render"}) {
    for (const std::string value : {"null", "true", "{}", "[]", "[[]]", "[{}]", "[null]", "\"\"", "-1", "[\"\"]"}) {
      try {
        fabricFromJson(test::fabricWith(fmt::format("\"{}\": {}", key, value)), "x.json");
        EXPECT_TRUE(fitting.count({key, value})) << key << " " << value;
      } catch (const InputError& error) {
        EXPECT_EQ(std::string(error.what()).rfind("x.json: " + key, 0), 0u) << error.what();
      }
    }
  }
}

TEST(HostileJson, KeysGivenTwice) {
  expectRefused(test::fabricWith("\"name\": \"a\", \"name\": \"b\""), "a name twice");
  expectRefused(test::fabricWith("\"yarns\": [{\"plies\": 1, \"plies\": 2}]"), "plies twice");
  expectRefused(test::fabricWith("\"x\": {\"y\": [{}, {\"z\": 1, \"z\": 1}]}"), "an unknown key twice");
  try {
    fabricFromJson(test::fabricWith("\"yarns\": [{}, {\"plies\": 1, \"plies\": 2}]"), "x.json");
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "x.json: yarns[1].plies: expected every key once, got it twice");
  }
}

TEST(HostileJson, NumbersBeyondAllAreSaidWithTheirPlace) {
  try {
    fabricFromJson(test::fabricWith("\"yarns\": [{}, {\"count_tex\": 1e99999}]"), "x.json");
    ADD_FAILURE() << "expected to be refused";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "x.json: yarns[1].count_tex: expected a number within the range of floating point, got one beyond it");
  }
}

TEST(HostileJson, MillionsOfValues) {
  expectRefused(test::fabricWith("\"x\": [" + repeated("0,", 6'000'000) + "0]"), "six million numbers");
  expectRefused(test::fabricWith("\"yarns\": [" + repeated("{},", 4'000'000) + "{}]"), "too many yarns");
  expectRefused(test::fabricWith("\"warp_sequence\": [" + repeated("0,", 16384) + "0]"), "too long a sequence");
  std::string keys;
  for (int i = 0; i < 5000; ++i) keys += fmt::format("\"k{}\": 0, ", i);
  expectRefused(test::fabricWith(keys + "\"z\": 0"), "too many keys");
}

TEST(HostileJson, WeavesOfWrongSizes) {
  expectRefused(test::fabricWith("\"weave\": []"), "no picks");
  expectRefused(test::fabricWith("\"weave\": [\"\"]"), "no ends");
  expectRefused(test::fabricWith("\"weave\": [\"" + std::string(16385, '#') + "\"]"), "too many ends");
  expectRefused(test::fabricWith("\"weave\": [" + repeated("\"#\",", 16384) + "\"#\"]"), "too many picks");
  const Fabric widest = fabricFromJson(test::fabricWith("\"weave\": [\"" + std::string(16384, '#') + "\"]"), "x.json");
  EXPECT_EQ(widest.weave.ends(), 16384);
}

TEST(HostileJson, DraftOfMostWorkComesToAnEnd) {
  // Every end on 8 shafts, hardly two picks of one shed; the test's own time limit is what a hang would break.
  std::string threading, treadling, tieUp;
  for (int i = 0; i < 4096; ++i) tieUp += fmt::format("{}{}", i > 0 ? "," : "", i + 1);
  for (int i = 0; i < 16384; ++i) {
    threading += i > 0 ? ",[1,2,3,4,5,6,7,8]" : "[1,2,3,4,5,6,7,8]";
    treadling += fmt::format("{}[{},{}]", i > 0 ? "," : "", i % 4096 + 1, (i / 4096 * 1000 + i) % 4096 + 1);
  }
  const std::string loom = "\"shafts\": 4096, \"treadles\": 4096, \"tie_up\": [" + tieUp + "], ";
  const Fabric fabric = fabricFromJson(test::fabricWith("\"draft\": {" + loom + "\"threading\": [" + threading +
                                                        "], \"treadling\": [" + treadling + "]}"),
                                       "x.json");
  EXPECT_EQ(fabric.weave.picks(), 16384);
  expectRefused(test::fabricWith("\"draft\": {" + loom + "\"threading\": [" + repeated("[1,2,3,4,5,6,7,8],", 16383) +
                                 "[1,2,3,4,5,6,7,8,9]], \"treadling\": [1]}"),
                "more shafts an end than the limit");
}

}  // namespace
}  // namespace loomlight
