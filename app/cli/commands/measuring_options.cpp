#include "app/cli/commands/measuring_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "app/cli/common_options.h"
#include "app/cli/usage_error.h"

namespace loomlight {
namespace {

constexpr const char* kThreadsOfWindow = "threads; as in the window, all where not given";

/// Two files: a picture and its reference.
void addPair(CLI::App& app, const std::string& name, const std::string& help, std::optional<PictureNames>& pair) {
  app.add_option_function<std::vector<std::string>>(
         name, [&pair](const std::vector<std::string>& files) { pair = PictureNames{files.at(0), files.at(1)}; }, help)
      ->type_name("FILE FILE")
      ->type_size(2)
      ->expected(1)
      ->allow_extra_args(false);
}

ClearBenchCommand::Sharing parseSharing(const std::string& option, const std::string& text) {
  using Sharing = ClearBenchCommand::Sharing;
  if (text == "on") return Sharing::on;
  if (text == "off") return Sharing::off;
  if (text == "both") return Sharing::both;
  throw UsageError(option + ": expected on, off or both, got '" + text + "'");
}

}  // namespace

void addVolumeBench(CLI::App& app, BenchCommand& command) {
  app.add_option("FABRIC", command.input, "the fabric to measure")->type_name("")->required();
  addPictureOptions(app, command.options);
  addThreads(app, command.threads);
  addValue(app, "--resolutions", "R,R,...", "1,2,4,8 where not given",
           [&command](const auto& option, const auto& text) { command.resolutions = parseResolutions(option, text); });
  addValue(app, "--rounds", "N", "medians are of this many", [&command](const auto& option, const auto& text) {
    command.rounds = static_cast<int>(parseWhole(option, text, 1, 99));
  });
  app.add_flag("--json", command.json, "JSON instead of a table");
}

void addReportBench(CLI::App& app, ReportBenchCommand& command) {
  app.add_option("-o,--output", command.bench.folder, "the folder for page, pictures and tables; made where needed")
      ->type_name("DIR");
  app.add_flag("--quick", command.bench.quick, "small pieces, few paths: seconds instead of a quarter of an hour");
  addThreads(app, command.threads);
  addMemoryLimit(app, command.bench.memoryLimit_bytes);
}

void addUiBench(CLI::App& app, UiBenchOptions& options) {
  app.add_flag("--quick", options.quick, "a small jacquard and few frames: a second instead of half a minute");
  app.add_flag("--json", options.json, "JSON instead of a table");
  addThreads(app, options.threads);
}

void addEditBench(CLI::App& app, EditBenchCommand& command) {
  app.add_option("-o,--output", command.folder, "the folder for page and tables; made where needed")->type_name("DIR");
  app.add_flag("--quick", command.quick, "small cloths and pictures: seconds instead of a quarter of an hour");
  app.add_flag("--json", command.json, "the figures as JSON on stdout too");
  addThreads(app, command.threads, kThreadsOfWindow);
}

void addConvergeBench(CLI::App& app, ConvergeBenchCommand& command) {
  app.add_option("-o,--output", command.folder, "the folder for page and tables; made where needed")->type_name("DIR");
  app.add_flag("--quick", command.quick, "one cloth, a small picture: a second instead of minutes");
  addThreads(app, command.threads);
}

void addClearBench(CLI::App& app, ClearBenchCommand& command) {
  app.add_option("-o,--output", command.folder, "the folder for page and tables; made where needed")->type_name("DIR");
  app.add_flag("--quick", command.quick, "one setting, a small picture: a minute instead of hours");
  app.add_flag("--pictures", command.pictures, "also what was shown at some times");
  app.add_option("--only", command.only, "of cloths, drapes, lights or edits these, with commas between them")
      ->type_name("NAME,...")
      ->delimiter(',');
  addValue(app, "--size", "WxH", "pixels; 640x400 where not given", [&command](const auto& option, const auto& text) {
    const PictureSize size = parseSize(option, text);
    const auto [least, most] = std::minmax(size.width, size.height);
    if (least < ClearBenchCommand::kLeastSide || most > ClearBenchCommand::kMostSide)
      throw UsageError(fmt::format("{0}: expected {1}x{1} to {2}x{2}, got {3}x{4}", option,
                                   ClearBenchCommand::kLeastSide, ClearBenchCommand::kMostSide, size.width,
                                   size.height));
    command.width = size.width;
    command.height = size.height;
  });
  addValue(app, "--share", "on|off|both", "light between repeats; both where not given",
           [&command](const auto& option, const auto& text) { command.sharing = parseSharing(option, text); });
  addValue(
      app, "--seconds", "N", "that each edit is looked at; 12 where not given",
      [&command](const auto& option, const auto& text) { command.seconds = parseNumber(option, text, 0.001, 3600); });
  addValue(app, "--reference", "N", "samples of the converged pictures; 1024 where not given",
           [&command](const auto& option, const auto& text) {
             command.referenceSamples = static_cast<int>(parseWhole(option, text, 1, 1 << 20));
           });
  addThreads(app, command.threads, kThreadsOfWindow);
}

void addClothsBench(CLI::App& app, ClothsBenchCommand& command) {
  app.add_option("-o,--output", command.folder, "the folder for page and tables; made where needed")->type_name("DIR");
}

void addBrdf(CLI::App& app, BrdfCommand& command) {
  addInput(app, "FABRIC", command.input);
  app.add_option("-o,--output", command.output, "writes OUT.exr, OUT.png and OUT.csv")->type_name("OUT")->required();
  addValue(
      app, "--light-angle", "DEG", "of parallel light, from the normal; beyond 90 from behind; 0 where not given",
      [&command](const auto& option, const auto& text) { command.lightAngle_deg = parseNumber(option, text, 0, 180); });
  addValue(app, "--cameras", "AxI", "how many azimuths and inclinations; 64x16 where not given",
           [&command](const auto& option, const auto& text) { command.grid = parseHalfDome(option, text); });
  addTraceOptions(app, command.options, "paths for each camera; 4096 where not given");
  addResolution(app, command.options);
  addThreads(app, command.threads);
  addMemoryLimit(app, command.memoryLimit_bytes);
  addFibreExtent(app, command.fibreExtent);
  addTone(app, command.tone);
}

void addBvdf(CLI::App& app, BvdfCommand& command) {
  addInput(app, "FABRIC", command.input);
  app.add_option("-o,--output", command.output, "tables (.exr) with a picture (.png) beside them, or the picture alone")
      ->type_name("OUT")
      ->required();
  addResolution(app, command.options);
  addValue(app, "--rays", "N", "shadow rays for each kind of yarn; 2 million where not given, 100 million with --full",
           [&command](const auto& option, const auto& text) {
             command.rays = static_cast<uint64_t>(parseWhole(option, text, 1, 100'000'000'000));
           });
  app.add_flag("--full", command.full, "32 x 64 x 64 x 64 bins, as in the report, in place of 8 x 8 x 16 x 32");
  addThreads(app, command.threads);
}

void addColour(CLI::App& app, ColourCommand& command) {
  addInputFile(app, "FABRIC", command.sample.file);
  app.add_option("--part", command.sample.part,
                 "only where this lies on top: a yarn's or a fibre's name, or its number, as 'yarn 2' or 1 of a fibre; "
                 "all of the piece where not given")
      ->type_name("NAME");
  app.add_option("--standard", command.standard.file,
                 "what it ought to look like: a measured swatch (CGATS .txt, .cxf, .qtx, .csv; FILE:NAME for one of "
                 "several), or a fabric. Exit status 3 where it does not under the first lamp")
      ->type_name("FILE");
  app.add_option("--standard-part", command.standard.part,
                 "of the standard only this, as --part; without --standard of FABRIC itself")
      ->type_name("NAME");
  app.add_option("--standard-colourway", command.standard.options.colourway,
                 "the standard's colours of this name; without --standard those of FABRIC itself")
      ->type_name("NAME");
  app.add_option("--illuminant", command.illuminants,
                 "lamps to judge by, with commas between; D65,F11,A where not given. Also 2856 K, or a text file of nm "
                 "and power. Metamerism is told from the first")
      ->type_name("NAME,...")
      ->delimiter(',');
  addValue(app, "--observer", "2|10", "the CIE observer for so many degrees; 10 where not given",
           [&command](const auto& option, const auto& text) { command.observer = parseObserver(option, text); });
  addValue(app, "--tolerance", "N", "the largest CMC(2:1) that passes; 1 where not given",
           [&command](const auto& option, const auto& text) { command.tolerance = parseNumber(option, text, 0, 100); });
  addColourway(app, command.sample.options);
  addWifChoices(app, command.wif);
  addThreads(app, command.threads);
  app.add_flag("--json", command.json, "JSON instead of a table");
}

void addCompare(CLI::App& app, CompareCommand& command) {
  app.add_option("PICTURE", command.pictures.picture, "an .exr, or a .png as a screen shows it")
      ->type_name("")
      ->required();
  app.add_option("REFERENCE", command.pictures.reference, "one of the same size: what it ought to look like")
      ->type_name("")
      ->required();
  addPair(app, "--again", "picture and reference with other seeds, for a bias without noise", command.again);
  addPair(app, "--yardstick", "two fibre arrangements of the same yarns, compared likewise", command.yardstick);
  addPair(app, "--yardstick-again", "the same two with other seeds", command.yardstickAgain);
  addValue(app, "--exposure", "STOPS", "of the display, for FLIP and CIEDE2000",
           [&command](const auto& option, const auto& text) {
             command.viewing.exposure_stops = parseNumber(option, text, -20, 20);
           });
  addValue(app, "--ppd", "N", "pixels per degree of visual angle, for FLIP; 67 where not given",
           [&command](const auto& option, const auto& text) {
             command.viewing.pixelsPerDegree =
                 parseNumber(option, text, Viewing::kMinPixelsPerDegree, Viewing::kMaxPixelsPerDegree);
           });
  app.add_option("-o,--output", command.heatMap, "a heat map of FLIP")->type_name("OUT.png");
  addValue(
      app, "--range", "MAX", "FLIP at the white end of the heat map; 1 where not given",
      [&command](const auto& option, const auto& text) { command.heatRange = parseNumber(option, text, 1e-6, 1); });
  addThreads(app, command.threads);
  app.add_flag("--json", command.json, "JSON instead of a table");
}

}  // namespace loomlight
