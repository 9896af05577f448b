#include "app/cli/commands/command_line.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/cli/usage_error.h"
#include "core/base/error.h"
#include "core/base/rgb.h"
#include "tests/support/scratch_folder.h"

namespace loomlight {
namespace {

using testing::HasSubstr;

template <class Kind>
Kind parsed(const std::vector<std::string>& words) {
  const Command command = parseCommandLine(words);
  EXPECT_TRUE(std::holds_alternative<Kind>(command));
  return std::get<Kind>(command);
}

std::string complaint(const std::vector<std::string>& words) {
  try {
    parseCommandLine(words);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "no complaint";
}

TEST(CommandLine, EditsByDefault) {
  EXPECT_EQ(parsed<EditCommand>({}).options.fabricFile, "");
  EXPECT_EQ(parsed<EditCommand>({"a.json"}).options.fabricFile, "a.json");
  EXPECT_EQ(parsed<EditCommand>({"edit"}).options.fabricFile, "");
  EXPECT_EQ(parsed<EditCommand>({"edit", "a.json"}).options.fabricFile, "a.json");
  const EditorOptions window = parsed<EditCommand>({"edit", "--window", "1280x720", "--scale", "1.5"}).options;
  EXPECT_EQ(window.width, 1280);
  EXPECT_EQ(window.height, 720);
  EXPECT_FLOAT_EQ(window.scale, 1.5f);
}

TEST(CommandLine, RenderTakesAllItsOptions) {
  const auto render = parsed<RenderCommand>({"render",       "a.json",
                                             "-o",           "b.exr",
                                             "--size",       "64x48",
                                             "--spp",        "16",
                                             "--seed",       "7",
                                             "--threads",    "3",
                                             "--view",       "top",
                                             "--drape",      "sphere",
                                             "--light",      "dome",
                                             "--method",     "fibres",
                                             "--resolution", "4",
                                             "--max-depth",  "99",
                                             "--event-law",  "report",
                                             "--exposure",   "-1",
                                             "--tone",       "plain",
                                             "--stats",      "s.json",
                                             "--keep-sums",  "--resume",
                                             "c.exr",        "--uv-scale",
                                             "10",           "--estimator",
                                             "report",       "--grain",
                                             "-45",          "--memory-limit",
                                             "2.5",          "--fibres-extent",
                                             "repeat",       "--temperature",
                                             "2700"});
  EXPECT_EQ(render.inputs.front(), "a.json");
  EXPECT_EQ(render.output, "b.exr");
  EXPECT_EQ(render.options.size->width, 64);
  EXPECT_EQ(render.options.samplesPerPixel, 16);
  EXPECT_EQ(render.options.seed, 7u);
  EXPECT_EQ(render.threads, 3);
  EXPECT_DOUBLE_EQ(render.options.view->elevation_deg, 90);
  EXPECT_EQ(render.options.drape->kind, DrapeKind::sphere);
  EXPECT_EQ(render.options.light->kind, LightKind::dome);
  EXPECT_EQ(render.options.resolution, 4);
  EXPECT_EQ(render.options.maxDepth, 99);
  EXPECT_EQ(render.options.method, Method::fibres);
  EXPECT_EQ(render.options.estimator, Estimator::report);
  EXPECT_DOUBLE_EQ(render.memoryLimit_bytes, 2.5e9);
  EXPECT_EQ(render.fibreExtent, FibreExtent::oneRepeat);
  EXPECT_EQ(render.options.eventLaw, EventLaw::report);
  EXPECT_FLOAT_EQ(render.tone.exposure_stops, -1);
  EXPECT_FALSE(render.tone.filmic);
  EXPECT_EQ(render.stats, "s.json");
  EXPECT_TRUE(render.keepSums);
  EXPECT_EQ(render.resume, "c.exr");
  EXPECT_DOUBLE_EQ(render.options.uvScale_mm.value(), 10);
  EXPECT_DOUBLE_EQ(withOptions(Fabric{}, render.options, "a.json").drape.grain_deg, -45);
  EXPECT_DOUBLE_EQ(withOptions(Fabric{}, render.options, "a.json").light.temperature_K, 2700);
}

// A law without the estimator that obeys it would change nothing.
TEST(CommandLine, AnEventLawMeansNoEstimator) {
  const auto law = parsed<RenderCommand>({"render", "a.json", "-o", "b.png", "--event-law", "report"});
  EXPECT_EQ(withOptions(Fabric{}, law.options, "a.json").render.estimator, Estimator::none);
  const auto both =
      parsed<RenderCommand>({"render", "a.json", "-o", "b.png", "--event-law", "report", "--estimator", "loomlight"});
  EXPECT_EQ(withOptions(Fabric{}, both.options, "a.json").render.estimator, Estimator::loomlight);
}

TEST(CommandLine, WhatIsNotGivenIsLeftToTheFabric) {
  const auto render = parsed<RenderCommand>({"render", "a.json", "-o", "b.png"});
  Fabric fabric;
  fabric.render.samplesPerPixel = 5;
  fabric.camera.distance_mm = 17;
  const Fabric same = withOptions(fabric, render.options, "a.json");
  EXPECT_EQ(same.render.samplesPerPixel, 5);
  EXPECT_EQ(same.camera.distance_mm, 17);
  EXPECT_EQ(same.light.kind, fabric.light.kind);
  EXPECT_EQ(render.threads, 0);
}

TEST(CommandLine, AColourwayThatIsNotThereIsRefusedByTheFabricsFile) {
  FabricOptions options;
  options.colourway = "Moss";
  EXPECT_EQ(test::messageOf<InputError>([&] { withOptions(Fabric{}, options, "a.json"); }),
            "a.json: colourway 'Moss': expected one of the fabric's, which has none");
}

TEST(CommandLine, ASkyHasItsSunAboveTheHorizon) {
  Fabric fabric;
  fabric.light.kind = LightKind::directional;
  fabric.light.elevation_deg = -30;
  FabricOptions options;
  options.light = parseLight("--light", "ibl");
  EXPECT_GT(withOptions(fabric, options, "a.json").light.elevation_deg, 0);
  options.light = parseLight("--light", "directional");
  EXPECT_EQ(withOptions(fabric, options, "a.json").light.elevation_deg, -30);
}

TEST(CommandLine, InfoConvertAndBench) {
  const auto info = parsed<InfoCommand>({"info", "a.json", "--json", "--resolution", "2"});
  EXPECT_EQ(info.input.file, "a.json");
  EXPECT_TRUE(info.json);
  EXPECT_EQ(info.options.resolution, 2);
  const auto convert = parsed<ConvertCommand>({"convert", "a.png", "b.json", "--like", "c.json"});
  EXPECT_EQ(convert.input.file, "a.png");
  EXPECT_EQ(convert.output, "b.json");
  EXPECT_EQ(convert.like, "c.json");
  EXPECT_EQ(convert.input.wif.sizes, WifSizeChoice::keep);
  EXPECT_EQ(parsed<ConvertCommand>({"convert", "a.wif", "b.json", "--wif-sizes", "file"}).input.wif.sizes,
            WifSizeChoice::file);
  EXPECT_EQ(parsed<InfoCommand>({"info", "a.wif", "--wif-sizes", "file"}).input.wif.sizes, WifSizeChoice::file);
  const PieceSize piece = parsed<InfoCommand>({"info", "a.json", "--piece", "2.5x90"}).piece;
  EXPECT_DOUBLE_EQ(piece.length_m, 2.5);
  EXPECT_DOUBLE_EQ(piece.width_cm, 90);
  EXPECT_DOUBLE_EQ(info.piece.length_m, PieceSize{}.length_m);
  EXPECT_EQ(parsed<ConvertCommand>({"convert", "a.wif", "b.json", "--wif-threads", "named"}).input.wif.threads,
            WifThreadChoice::named);
  EXPECT_THAT(complaint({"convert", "a.wif", "b.json", "--wif-threads", "some"}), HasSubstr("--wif-threads: expected"));
  EXPECT_THAT(complaint({"convert", "a.wif", "b.json", "--wif-sizes", "mine"}), HasSubstr("--wif-sizes: expected"));
  const auto bench = parsed<BenchCommand>({"bench", "volume", "a.json", "--resolutions", "2,4", "--rounds", "1"});
  EXPECT_THAT(bench.resolutions, testing::ElementsAre(2, 4));
  EXPECT_EQ(bench.rounds, 1);
}

TEST(CommandLine, ConvertTakesSeveralColoursOfTheCloth) {
  const auto convert = parsed<ConvertCommand>(
      {"convert", "a.json", "--cloth-colour", "warp=2=#102aFF", "b.json", "--cloth-colour", "3=#000000"});
  EXPECT_EQ(convert.output, "b.json");
  ASSERT_EQ(convert.clothColours.size(), 2u);
  EXPECT_EQ(convert.clothColours[0].fibre, "warp=2");
  EXPECT_FLOAT_EQ(convert.clothColours[0].colour.linear.g, decodeSrgb(0x2a / 255.0f));
  EXPECT_EQ(convert.clothColours[1].fibre, "3");
  const auto lab = parsed<ConvertCommand>({"convert", "a.json", "b.json", "--cloth-colour", "cotton=Lab 40.5 52 -38"});
  ASSERT_TRUE(lab.clothColours[0].colour.lab);
  EXPECT_EQ(lab.clothColours[0].colour.lab->L, 40.5);
  for (const char* wrong : {"1=Lab 40 52", "1=Lab 140 0 0", "#102030", "=#102030", "1=102030", "1=#10203", "1=#1020300",
                            "1=#-10203", "1=#10203g"})
    EXPECT_THAT(complaint({"convert", "a.json", "b.json", "--cloth-colour", wrong}),
                HasSubstr("--cloth-colour: expected FIBRE=#RRGGBB"));
  EXPECT_THAT(complaint({"convert", "a.json", "b.png", "--cloth-colour", "1=#102030"}),
              HasSubstr("--cloth-colour: expected an OUT with colours"));
}

TEST(CommandLine, BrdfTakesCamerasAndALight) {
  const auto brdf = parsed<BrdfCommand>(
      {"brdf", "a.json", "-o", "out", "--light-angle", "45", "--cameras", "32x8", "--spp", "99", "--method", "fibres"});
  EXPECT_EQ(brdf.input.file, "a.json");
  EXPECT_EQ(parsed<BrdfCommand>({"brdf", "a.wif", "--wif-sizes", "file", "-o", "b"}).input.wif.sizes,
            WifSizeChoice::file);
  EXPECT_EQ(brdf.output, "out");
  EXPECT_DOUBLE_EQ(brdf.lightAngle_deg.value(), 45);
  EXPECT_EQ(brdf.grid.azimuths, 32);
  EXPECT_EQ(brdf.grid.inclinations, 8);
  EXPECT_EQ(brdf.options.samplesPerPixel, 99);
  EXPECT_EQ(brdf.options.method, Method::fibres);
  EXPECT_THAT(complaint({"brdf", "a.json", "-o", "out", "--cameras", "300x8"}), HasSubstr("--cameras: expected"));
}

TEST(CommandLine, BenchKnowsItsSuites) {
  const auto table = parsed<ReportBenchCommand>({"bench", "table1", "--quick"});
  EXPECT_EQ(table.suite, ReportBenchCommand::Suite::table1);
  EXPECT_TRUE(table.bench.quick);
  EXPECT_FALSE(table.bench.folder.empty());
  const auto figures = parsed<ReportBenchCommand>({"bench", "figures", "-o", "out", "--threads", "2"});
  EXPECT_EQ(figures.suite, ReportBenchCommand::Suite::figures);
  EXPECT_EQ(figures.bench.folder, "out");
  EXPECT_EQ(figures.threads, 2);
  const auto accuracy = parsed<ReportBenchCommand>({"bench", "accuracy"});
  EXPECT_EQ(accuracy.suite, ReportBenchCommand::Suite::accuracy);
  EXPECT_NE(accuracy.bench.folder, table.bench.folder);
  EXPECT_EQ(parsed<ReportBenchCommand>({"bench", "closeup"}).suite, ReportBenchCommand::Suite::closeup);
  const auto edit = parsed<EditBenchCommand>({"bench", "edit", "--json"});
  EXPECT_TRUE(edit.json);
  EXPECT_FALSE(edit.quick);
  EXPECT_FALSE(edit.folder.empty());
  EXPECT_TRUE(parsed<UiBenchCommand>({"bench", "ui", "--quick"}).options.quick);
  EXPECT_THAT(complaint({"bench", "races", "a.json"}), HasSubstr("races"));
  EXPECT_THAT(complaint({"bench"}), HasSubstr("table1"));
}

TEST(CommandLine, CompareTakesPairsOfPictures) {
  const auto compare = parsed<CompareCommand>(
      {"compare",           "--again", "a2.exr", "r2.exr", "a.exr", "r.exr",   "--yardstick", "y.exr", "z.exr",
       "--yardstick-again", "y2.exr",  "z2.exr", "-o",     "h.png", "--range", "0.2",         "--ppd", "30",
       "--exposure",        "-2",      "--json"});
  EXPECT_EQ(compare.pictures.picture, "a.exr");
  EXPECT_EQ(compare.pictures.reference, "r.exr");
  EXPECT_EQ(compare.again->picture, "a2.exr");
  EXPECT_EQ(compare.again->reference, "r2.exr");
  EXPECT_EQ(compare.yardstick->reference, "z.exr");
  EXPECT_EQ(compare.yardstickAgain->picture, "y2.exr");
  EXPECT_EQ(compare.heatMap, "h.png");
  EXPECT_DOUBLE_EQ(compare.heatRange, 0.2);
  EXPECT_DOUBLE_EQ(compare.viewing.pixelsPerDegree, 30);
  EXPECT_DOUBLE_EQ(compare.viewing.exposure_stops, -2);
  EXPECT_TRUE(compare.json);
  EXPECT_THAT(complaint({"compare", "a.exr"}), HasSubstr("REFERENCE"));
  EXPECT_THAT(complaint({"compare", "a.exr", "r.exr", "--again", "a2.exr"}), HasSubstr("--again"));
  EXPECT_THAT(complaint({"compare", "a.exr", "r.exr", "--yardstick-again", "y", "z"}),
              HasSubstr("--yardstick as well"));
  EXPECT_THAT(complaint({"compare", "a.exr", "r.exr", "--ppd", "0"}), HasSubstr("--ppd: expected"));
}

TEST(CommandLine, HelpNamesEveryCommandAndOption) {
  const std::string help = parsed<TextCommand>({"--help"}).text;
  for (const char* word : {"edit", "render", "info", "convert", "bench", "compare"}) EXPECT_THAT(help, HasSubstr(word));
  const std::string render = parsed<TextCommand>({"render", "--help"}).text;
  for (const char* option :
       {"--size", "--spp", "--seed", "--threads", "--view", "--drape", "--light", "--method", "--resolution",
        "--max-depth", "--estimator", "--memory-limit", "--event-law", "--exposure", "--tone", "--stats", "--resume"})
    EXPECT_THAT(render, HasSubstr(option));
  EXPECT_THAT(parsed<TextCommand>({"--version"}).text, HasSubstr(LOOMLIGHT_VERSION));
}

TEST(CommandLine, SlipsAreNamed) {
  EXPECT_THAT(complaint({"render", "a.json"}), HasSubstr("--output"));
  EXPECT_THAT(complaint({"render", "-o", "b.png"}), HasSubstr("FABRIC"));
  EXPECT_THAT(complaint({"render", "a.json", "-o", "b.png", "--ssp", "3"}), HasSubstr("--ssp"));
  EXPECT_THAT(complaint({"render", "a.json", "-o", "b.png", "--spp"}), HasSubstr("--spp"));
  EXPECT_THAT(complaint({"render", "a.json", "-o", "b.png", "--spp", "0"}),
              HasSubstr("--spp: expected a whole number"));
  EXPECT_THAT(complaint({"render", "a.json", "-o", "b.png", "--method", "magic"}), HasSubstr("--method: expected"));
  EXPECT_THAT(complaint({"render", "a.json", "-o", "b.png", "--threads", "0"}), HasSubstr("--threads"));
  EXPECT_THAT(complaint({"info"}), HasSubstr("FABRIC"));
  EXPECT_THAT(complaint({"convert", "a.json"}), HasSubstr("OUT"));
  EXPECT_THAT(complaint({"bench", "speed", "a.json"}), HasSubstr("volume"));
  EXPECT_NE(complaint({"a.json", "b.json"}), "no complaint");
}

}  // namespace
}  // namespace loomlight
