#include "core/fabric/json/fabric_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/fabric/model/yarn_count.h"
#include "core/fabric/weave/jacquard.h"
#include "tests/unit/fabric/json/fabric_with.h"

namespace loomlight {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

std::string complaint(std::string_view text) {
  try {
    fabricFromJson(text, "x.json");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// A file of this version with one more entry.
TEST(FabricJson, KeysLeftOutHaveTheirDefaults) {
  EXPECT_EQ(fabricFromJson("{\"loomlight_version\": 1}", "x.json"), Fabric{});
}

TEST(FabricJson, EveryValueComesBack) {
  Fabric f;
  f.name = "Ünïcode \"quoted\"\n";
  f.description = "über";
  f.weave = Weave(std::vector<Weave::Row>{{1, 0, 0}, {0, 1, 1}});
  f.ends_per_cm = 23.456789012345678;
  f.picks_per_cm = 0.2;
  f.warpSequence = {0, 1, 1};
  f.weftSequence = {1};
  f.warpSpacing = {1, 2.5, 1.0 / 3};
  f.weftSpacing = {1, 10};
  f.fibres.resize(2);
  f.fibres[1].absorption_per_mm = Rgb(0.1f, 1.0f / 3.0f, 9999.99f);
  f.fibres[1].section = FibreSection::trilobal;
  f.fibres[1].scaleTilt_deg = -2.5;
  f.yarns.resize(2);
  f.yarns[1].fibre = 1;
  f.yarns[1].fibresPerPly = 77;
  f.yarns[1].plies = 3;
  f.yarns[1].plyTwistDirection = TwistDirection::s;
  f.yarns[1].cords = 2;
  f.yarns[1].cableTwist_per_m = 210;
  f.yarns[1].cableTwistDirection = TwistDirection::s;
  f.yarns[1].layout = FibreLayout::random;
  f.yarns[1].blendFibre = 0;
  f.yarns[1].blendShare = 0.35;
  f.colourways.resize(2);
  f.colourways[0].name = "Rust";
  f.colourways[0].absorption_per_mm = {Rgb(0.1f, 20, 30), Rgb(1, 2, 3)};
  f.mill.reed_per_10cm = 118.5;
  f.mill.endsPerDent = {3, 3, 0};
  f.mill.loomEnds_per_cm = 22;
  f.mill.washedPicks_per_cm = 0.25;
  f.mill.selvedgeEnds = 24;
  f.mill.selvedgeYarn = 1;
  f.mill.selvedgeWeave = "tucked in";
  f.drape.kind = DrapeKind::mesh;
  f.drape.file = "folds.obj";
  f.drape.grain_deg = -30.5;
  f.light.kind = LightKind::environment;
  f.light.file = "sky.exr";
  f.light.illuminant = StandardIlluminant::ledB3;
  f.light.illuminantFile = "lamp.txt";
  f.camera.target_mm = {1, -2.25, 1e-9};
  f.camera.fov_deg = 0;
  f.render.seed = 18446744073709551615u;
  f.render.resolution = 16;
  f.render.method = Method::fibres;
  f.render.estimator = Estimator::none;
  f.render.eventLaw = EventLaw::report;
  f.render.observer = Observer::degrees10;
  const std::string text = fabricToJson(f);
  const Fabric back = fabricFromJson(text, "x.json");
  EXPECT_EQ(back, f);
  EXPECT_EQ(fabricToJson(back), text);
}

TEST(FabricJson, FloatsAreWrittenShortAndReadExactly) {
  Fabric f;
  for (int i = 0; i < 1000; ++i) {
    f.fibres[0].absorption_per_mm =
        Rgb(static_cast<float>(i) * 0.1f, std::exp(static_cast<float>(i) * 0.009f), 1.0f / static_cast<float>(i + 1));
    EXPECT_EQ(fabricFromJson(fabricToJson(f), "x").fibres[0].absorption_per_mm, f.fibres[0].absorption_per_mm);
  }
  f.fibres[0].absorption_per_mm = Rgb(0.3f);
  EXPECT_THAT(fabricToJson(f), HasSubstr("[0.3, 0.3, 0.3]"));
}

TEST(FabricJson, SpectraAndRecipesComeBack) {
  Fabric f;
  f.colourways.resize(1);
  Spectrum bands;
  for (size_t j = 0; j < kBands; ++j) bands[j] = 0.1f * static_cast<float>(j);
  Absorption measured(bands), recipe(Rgb(1, 2, 3));
  recipe.dyes = {{"navy", 2.5, bands}, {"red", 0, Spectrum{}}};
  for (const Absorption& absorption : {measured, recipe}) {
    f.fibres[0].absorption_per_mm = absorption;
    f.colourways[0].absorption_per_mm = {absorption};
    const std::string text = fabricToJson(f);
    EXPECT_EQ(fabricFromJson(text, "x.json"), f);
    EXPECT_EQ(fabricToJson(fabricFromJson(text, "x.json")), text);
  }
}

TEST(FabricJson, OtherSamplesAreReadOffAtTheBands) {
  const Fabric f = fabricFromJson(
      test::fabricWith(
          R"("fibres": [{"absorption_per_mm": {"bands": {"from_nm": 400, "step_nm": 100, "values": [2, 4, 8, 10]}}}])"),
      "x.json");
  const Spectrum& bands = *f.fibres[0].absorption_per_mm.bands;
  EXPECT_EQ(bands[0], 2) << "as at the end";
  EXPECT_EQ(bands[2], 2);
  EXPECT_FLOAT_EQ(bands[5], 2.6f);
  EXPECT_EQ(bands[12], 4);
  EXPECT_EQ(bands[kBands - 1], 10);
}

TEST(FabricJson, BadSpectraAreRefusedWhereTheyAre) {
  const auto of = [](const std::string& absorption) {
    return complaint(test::fabricWith(R"("fibres": [{"absorption_per_mm": )" + absorption + "}]"));
  };
  EXPECT_EQ(of(R"({"bands": [1, 2]})"),
            "x.json: fibres[0].absorption_per_mm.bands: expected a list of 36 numbers, from 380 to 730 nm, got 2");
  EXPECT_EQ(of(R"({"bands": {"values": [1]}})"),
            "x.json: fibres[0].absorption_per_mm.bands.values: expected from 2 to 1001 numbers, got 1");
  EXPECT_EQ(of(R"({"bands": {"step_nm": 0, "values": [1, 2]}})"),
            "x.json: fibres[0].absorption_per_mm.bands.step_nm: expected a number from 0.1 to 100, got 0");
  EXPECT_EQ(of(R"({"bands": {"values": [1, -2]}})"),
            "x.json: fibres[0].absorption_per_mm.bands.values[1]: expected a number from 0 to 10000, got -2");
  EXPECT_EQ(of(R"({"dyes": [{"amount_percent": 101}]})"),
            "x.json: fibres[0].absorption_per_mm.dyes[0].amount_percent: expected a number from 0 to 100, got 101");
  EXPECT_EQ(
      of(R"({"bands": {"from_nm": 500, "step_nm": 10, "values": [1, 2]}})"),
      "x.json: fibres[0].absorption_per_mm.bands.values: expected values from 400 to 700 nm at least, got from 500 "
      "to 510");
  EXPECT_EQ(of(R"({"band": []})"),
            "x.json: fibres[0].absorption_per_mm: expected primaries, bands and dyes, got \"band\"");
  EXPECT_EQ(of(R"({"dyes": [{"colour": 1}]})"),
            "x.json: fibres[0].absorption_per_mm.dyes[0]: expected a dye's name, amount_percent and "
            "absorption_per_mm, got \"colour\"");
  EXPECT_EQ(of(R"({"dyes": 3})"), "x.json: fibres[0].absorption_per_mm.dyes: expected a list of dyes, got 3");
}

TEST(FabricJson, FirstWeaveTextIsTheTopOfThePicture) {
  const Fabric f = fabricFromJson(test::fabricWith(R"("weave": ["##.", "..#"])"), "x.json");
  EXPECT_TRUE(f.weave.at(1, 0) && f.weave.at(1, 1) && !f.weave.at(1, 2)) << "the first text is the last pick";
  EXPECT_TRUE(!f.weave.at(0, 0) && !f.weave.at(0, 1) && f.weave.at(0, 2));
}

TEST(FabricJson, DraftMakesTheWeaveAndIsWrittenInItsPlace) {
  const std::string draft = R"("draft": {"shafts": 2, "treadles": 2, "threading": [1, 2, [1, 2]], "tie_up": [1, 2],
    "treadling": [1, 2], "note": "kept"})";
  const Fabric f = fabricFromJson(test::fabricWith(draft), "x.json");
  ASSERT_TRUE(f.draft);
  EXPECT_EQ(f.weave, Weave(std::vector<Weave::Row>{{1, 0, 1}, {0, 1, 1}}));
  const std::string text = fabricToJson(f);
  EXPECT_THAT(text, testing::Not(HasSubstr("\"weave\"")));
  EXPECT_THAT(text, HasSubstr("\"note\": \"kept\""));
  EXPECT_EQ(fabricFromJson(text, "x.json"), f);
  EXPECT_EQ(complaint(test::fabricWith(draft + R"(, "weave": ["##"])")),
            "x.json: draft: expected a draft that makes the weave, got another weave");
}

TEST(FabricJson, UnknownKeysAreKeptInEveryObject) {
  const std::string text = R"({"loomlight_version": 1, "mood": {"deep": [1, {"a": null}]},
    "yarns": [{"slub": 3}], "fibres": [{"spectrum": [400, 700]}], "drape": {"pins": true}, "light": {"gobo": "leaf"},
    "camera": {"lens": 50}, "render": {"denoise": 0.5}})";
  const auto back = nlohmann::json::parse(fabricToJson(fabricFromJson(text, "x.json")));
  EXPECT_EQ(back["mood"], nlohmann::json::parse(R"({"deep": [1, {"a": null}]})"));
  EXPECT_EQ(back["yarns"][0]["slub"], 3);
  EXPECT_EQ(back["fibres"][0]["spectrum"], nlohmann::json::parse("[400, 700]"));
  EXPECT_EQ(back["drape"]["pins"], true);
  EXPECT_EQ(back["light"]["gobo"], "leaf");
  EXPECT_EQ(back["camera"]["lens"], 50);
  EXPECT_EQ(back["render"]["denoise"], 0.5);
}

TEST(FabricJson, NewerVersionsAreRefusedAndNoVersionToo) {
  EXPECT_THAT(complaint("{\"loomlight_version\": 2}"),
              HasSubstr("loomlight_version: expected at most 1, got 2: a newer"));
  EXPECT_THAT(complaint("{}"), StartsWith("x.json: loomlight_version: expected 1"));
  EXPECT_NE(complaint("{\"loomlight_version\": \"1\"}"), "");
  EXPECT_NE(complaint("{\"loomlight_version\": 0}"), "");
}

TEST(FabricJson, MessagesNameFilePlaceAndExpectation) {
  EXPECT_EQ(complaint(test::fabricWith(R"("yarns": [{}, {"ply_twist_per_m": -3}])")),
            "x.json: yarns[1].ply_twist_per_m: expected a number from 0 to 5000, got -3");
  EXPECT_EQ(complaint(test::fabricWith(R"("yarns": [{"plies": 2.5}])")),
            "x.json: yarns[0].plies: expected a whole number from 1 to 8, got 2.5");
  EXPECT_EQ(complaint(test::fabricWith(R"("yarns": [{"plies": true}])")),
            "x.json: yarns[0].plies: expected a whole number from 1 to 8, got true");
  EXPECT_EQ(complaint(test::fabricWith(R"("fibres": [{"absorption_per_mm": [1, "deep", 1]}])")),
            "x.json: fibres[0].absorption_per_mm[1]: expected a number from 0 to 10000, got \"deep\"");
  EXPECT_EQ(complaint(test::fabricWith(R"("fibres": [{"absorption_per_mm": [1, 2]}])")),
            "x.json: fibres[0].absorption_per_mm: expected a list of 3 numbers, got 2");
  EXPECT_EQ(complaint(test::fabricWith(R"("yarns": [{"layout": "tidy"}])")),
            "x.json: yarns[0].layout: expected \"random\" or \"packed\", got \"tidy\"");
  EXPECT_EQ(complaint(test::fabricWith(R"("weave": ["#.", "#.#"])")),
            "x.json: weave[1]: expected 2 ends as in the first pick listed, got 3");
  EXPECT_EQ(complaint(test::fabricWith(R"("weave": ["#.", "#x"])")),
            "x.json: weave[1]: expected only \"#\" (warp over) and \".\" (weft over), got \"x\" at 2");
  EXPECT_EQ(complaint(test::fabricWith(R"("drape": [])")), "x.json: drape: expected an object, got a list");
  EXPECT_EQ(complaint(test::fabricWith(R"("name": 7)")), "x.json: name: expected a text, got 7");
  EXPECT_EQ(complaint(test::fabricWith(R"("warp_sequence": [0, 1])")),
            "x.json: warp_sequence[1]: expected the number of a yarn from 0 to 0, got 1");
  EXPECT_EQ(complaint(test::fabricWith(R"("warp_spacing": [1, 0.05])")),
            "x.json: warp_spacing[1]: expected a number from 0.1 to 10, got 0.05");
  EXPECT_EQ(complaint(test::fabricWith(R"("weft_spacing": "even")")),
            "x.json: weft_spacing: expected a list of numbers, got \"even\"");
  EXPECT_EQ(complaint(test::fabricWith(R"("weft_spacing": [1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,2])")),
            "x.json: weft_spacing: expected at most 16 distances, got 17");
  EXPECT_EQ(complaint(test::fabricWith(R"("render": {"seed": -1})")),
            "x.json: render.seed: expected a whole number from 0 to 18446744073709551615, got -1");
}

TEST(FabricJson, SyntaxErrorsNameLineAndColumn) {
  EXPECT_THAT(complaint("{\n  \"loomlight_version\": 1,\n  \"name\": oops\n}"),
              StartsWith("x.json: line 3, column 11: "));
  EXPECT_THAT(complaint(""), StartsWith("x.json: line 1, column 1: "));
  EXPECT_THAT(complaint("{\"a\": 1"), StartsWith("x.json: line 1, column 8: "));
}

TEST(FabricJson, LayoutIsCompactWhereItIsLong) {
  const std::string text = fabricToJson(Fabric{});
  EXPECT_THAT(text, HasSubstr("\n  \"weave\": [\n    \".#\",\n    \"#.\"\n  ]"));
  EXPECT_THAT(text, HasSubstr("\n  \"warp_sequence\": [0],\n"));
  EXPECT_EQ(text.back(), '\n');
}

TEST(FabricFile, WritesAndReadsBack) {
  const auto folder = std::filesystem::path(testing::TempDir()) / ("fabric-file-test-" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  const std::string file = (folder / "a.json").string();
  Fabric f;
  f.name = "On disk";
  f.drape.file = (folder / "meshes/folds.obj").string();
  f.light.file = "/elsewhere/sky.exr";
  writeFabric(f, file);
  EXPECT_EQ(readFabric(file), f);
  const std::string text = readFile(file, 1'000'000);
  EXPECT_THAT(text, HasSubstr("\"file\": \"meshes/folds.obj\"")) << "what lies beside the fabric moves along with it";
  EXPECT_THAT(text, HasSubstr("\"file\": \"/elsewhere/sky.exr\""));
  std::filesystem::remove_all(folder);
}

TEST(FabricFile, OneFromBeforePressingIsToldOfOnce) {
  std::string text = fabricToJson(Fabric{});
  EXPECT_THAT(fabricReadingOf(text, "a.json").remarks, IsEmpty());
  const size_t press = text.find("  \"press\"");
  ASSERT_NE(press, std::string::npos);
  text.erase(press, text.find('\n', press) + 1 - press);
  const FabricReading old = fabricReadingOf(text, "a.json");
  EXPECT_EQ(old.fabric, Fabric{});
  EXPECT_THAT(old.remarks, ElementsAre(HasSubstr("pressed by 0.5")));
  EXPECT_THAT(fabricReadingOf(fabricToJson(old.fabric), "a.json").remarks, IsEmpty()) << "as it is saved";
  EXPECT_THAT(fabricReadingOf(R"({"loomlight_version": 1, "yarns": [{}]})", "a.json").remarks, IsEmpty())
      << "what a person writes has only what they want";
}

TEST(FabricFile, InvalidFabricLeavesTheOldFileThere) {
  const std::string file = testing::TempDir() + "keep-" + std::to_string(getpid()) + ".json";
  writeFabric(Fabric{}, file);
  Fabric bad;
  bad.ends_per_cm = -1;
  EXPECT_THROW(writeFabric(bad, file), InputError);
  EXPECT_EQ(readFabric(file), Fabric{});
  std::filesystem::remove(file);
}

/// Everything in samples/ and samples/cloths/: valid, written as this version writes it, without warnings of a weaver.
class Samples : public testing::TestWithParam<std::string> {};

std::vector<std::string> sampleFiles() {
  std::vector<std::string> files;
  for (const std::string folder : {"", "cloths/"})
    for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(LOOMLIGHT_SAMPLES) / folder))
      if (entry.path().extension() == ".json") files.push_back(folder + entry.path().stem().string());
  std::sort(files.begin(), files.end());
  return files;
}

TEST_P(Samples, RoundTripIsByteStable) {
  const std::string file = std::string(LOOMLIGHT_SAMPLES) + "/" + GetParam() + ".json";
  const std::string text = readFile(file, kMaxFabricBytes);
  const Fabric fabric = fabricFromJson(text, file);
  const std::string written = fabricToJson(fabric);
  EXPECT_EQ(written, text) << "samples are committed as writeFabric() writes them";
  EXPECT_EQ(fabricFromJson(written, file), fabric);
}

TEST_P(Samples, NoSpunYarnIsMoreEvenThanChance) {
  const Fabric fabric = readFabric(std::string(LOOMLIGHT_SAMPLES) + "/" + GetParam() + ".json");
  for (const Yarn& yarn : fabric.yarns) {
    if (!isSpun(yarn) || yarn.evennessCv_percent == 0) continue;
    EXPECT_GT(yarn.evennessCv_percent, limitCv_percent(yarn, meanFibre(yarn, fabric.fibres))) << yarn.name;
  }
}

INSTANTIATE_TEST_SUITE_P(All, Samples, testing::ValuesIn(sampleFiles()), [](const auto& test) {
  std::string name = test.param;
  std::replace(name.begin(), name.end(), '/', '_');
  return name;
});

TEST(Samples, TheReportsFourAndTheOthersAreThere) {
  EXPECT_THAT(sampleFiles(), testing::IsSupersetOf({"blue_cloth", "colourful_cloth", "black_and_white_cloth",
                                                    "green_cloth", "denim", "sheer_silk", "jacquard"}));
}

TEST(Samples, JacquardIsTheOneWeGenerate) {
  const Fabric fabric = readFabric(std::string(LOOMLIGHT_SAMPLES) + "/jacquard.json");
  EXPECT_GE(fabric.weave.ends(), 600);
  EXPECT_GE(fabric.weave.picks(), 600);
  EXPECT_EQ(fabric.weave, damaskJacquard(640, 640));
}

}  // namespace
}  // namespace loomlight
