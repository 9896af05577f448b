#include "app/commands/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>

#include "app/commands/structure_choice.h"
#include "app/commands/usage_error.h"
#include "core/fabric/field_tables.h"

namespace loomlight {
namespace {

using Setter = std::function<void(const std::string& option, const std::string& text)>;

// Values are parsed by our own functions, so that every message names the option and says what was expected.
void addValue(CLI::App& app, const std::string& name, const std::string& value, const std::string& help,
              const Setter& set) {
  const std::string option = name.substr(name.rfind(',') + 1);
  app.add_option_function<std::string>(
         name, [option, set](const std::string& text) { set(option, text); }, help)
      ->type_name(value);
}

template <class Object, class Number>
int parseWholeField(const std::string& option, const std::string& text, Number Object::*member) {
  const FieldInfo info = fieldInfo(member);
  return static_cast<int>(parseWhole(option, text, static_cast<int64_t>(info.min), static_cast<int64_t>(info.max)));
}

void addInput(CLI::App& app, const std::string& name, std::string& input) {
  app.add_option(name, input, "a fabric (.json), draft (.wif), weave bitmap (.png) or picture (.exr)")
      ->type_name("")
      ->required();
}

void addResolution(CLI::App& app, FabricOptions& options) {
  addValue(app, "--resolution", "R", "voxels per yarn diameter: 1, 2, 4, 8 or 16; beyond 8 no finer than a fibre",
           [&options](const auto& option, const auto& text) { options.resolution = parseResolution(option, text); });
}

void addFabricOptions(CLI::App& app, FabricOptions& options) {
  addValue(app, "--drape", "flat|cylinder|sphere|FILE", "the surface the cloth lies on",
           [&options](const auto& option, const auto& text) { options.drape = parseDrape(option, text); });
  addValue(app, "--uv-scale", "MM", "millimetres of cloth per unit of a mesh's texture coordinates",
           [&options](const auto& option, const auto& text) {
             const FieldInfo info = fieldInfo(&Drape::uvScale_mm);
             options.uvScale_mm = parseNumber(option, text, info.min, info.max);
           });
  addResolution(app, options);
}

/// How light is traced, for pictures and measurements alike.
void addTraceOptions(CLI::App& app, FabricOptions& options, const std::string& samplesHelp) {
  addValue(app, "--spp", "N", samplesHelp, [&options](const auto& option, const auto& text) {
    options.samplesPerPixel = parseWholeField(option, text, &RenderSettings::samplesPerPixel);
  });
  addValue(app, "--seed", "N", "another number gives another pattern of noise",
           [&options](const auto& option, const auto& text) { options.seed = parseSeed(option, text); });
  addValue(app, "--light", "LIGHT", "ibl[:FILE], sky[:AZ,EL], directional[:AZ,EL], dome, point, back or furnace",
           [&options](const auto& option, const auto& text) { options.light = parseLight(option, text); });
  addValue(app, "--method", "volume|fibres", "what light is traced through: the volume, or every fibre as it is",
           [&options](const auto& option, const auto& text) { options.method = parseMethod(option, text); });
  addValue(app, "--estimator", "none|report|loomlight", "how the volume sees what is smaller than a voxel",
           [&options](const auto& option, const auto& text) { options.estimator = parseEstimator(option, text); });
  addValue(app, "--max-depth", "N", "scattering events of a path, at most",
           [&options](const auto& option, const auto& text) {
             options.maxDepth = parseWholeField(option, text, &RenderSettings::maxDepth);
           });
  addValue(app, "--event-law", "projected|report",
           "without an estimator, how a path chooses its fibre: ours, or Eq. 12 of the report",
           [&options](const auto& option, const auto& text) { options.eventLaw = parseEventLaw(option, text); });
}

void addPictureOptions(CLI::App& app, FabricOptions& options) {
  addValue(app, "--size", "WxH", "pixels",
           [&options](const auto& option, const auto& text) { options.size = parseSize(option, text); });
  addTraceOptions(app, options, "samples per pixel");
  addValue(app, "--temperature", "K", "colour of the light: 2700 a warm lamp, 6500 as it is, 9000 a blue sky",
           [&options](const auto& option, const auto& text) {
             const FieldInfo info = fieldInfo(&Light::temperature_K);
             options.temperature_K = parseNumber(option, text, info.min, info.max);
           });
  app.add_option("--colourway", options.colourway, "the colours of the fabric that have this name")->type_name("NAME");
  addValue(app, "--view", "NAME|AZ,EL[,MM]", viewPresetNames() + ", or angles in degrees and a distance",
           [&options](const auto& option, const auto& text) { options.view = parseView(option, text); });
}

void addThreads(CLI::App& app, int& threads) {
  addValue(app, "--threads", "N", "threads; all where not given", [&threads](const auto& option, const auto& text) {
    threads = static_cast<int>(parseWhole(option, text, 1, 1024));
  });
}

void addMemoryLimit(CLI::App& app, double& limit_bytes) {
  addValue(app, "--memory-limit", "GB", "what fibres may take; three quarters of the memory where not given",
           [&limit_bytes](const auto& option, const auto& text) {
             limit_bytes = 1e9 * parseNumber(option, text, 1e-3, 1e6);
           });
}

void addFibreExtent(CLI::App& app, FibreExtent& extent) {
  addValue(app, "--fibres-extent", "auto|piece|repeat",
           "all fibres of the piece, or of a flat one a repeat, side by side; auto: as memory allows",
           [&extent](const auto& option, const auto& text) { extent = parseFibreExtent(option, text); });
}

void addExposure(CLI::App& app, Tone& tone) {
  addValue(app, "--exposure", "STOPS", "brighter or darker; only a .png has it",
           [&tone](const auto& option, const auto& text) {
             tone.exposure_stops = static_cast<float>(parseNumber(option, text, -20, 20));
           });
}

void addEdit(CLI::App& app, EditorOptions& options) {
  app.add_option("FABRIC", options.fabricFile, "the fabric to open")->type_name("");
  addThreads(app, options.threads);
  addValue(app, "--window", "WxH", "size of the window, pixels", [&options](const auto& option, const auto& text) {
    const PictureSize size = parseSize(option, text);
    options.width = size.width;
    options.height = size.height;
  });
  addValue(app, "--scale", "S", "of text and controls, 0.5 to 4; the monitor's where not given",
           [&options](const auto& option, const auto& text) {
             options.scale = static_cast<float>(parseNumber(option, text, 0.5, 4));
           });
  app.add_option("--widget-dump", options.widgetDump, "for tests: keep in this file where the widgets are, as JSON")
      ->type_name("FILE");
}

/// Of a draft, which is mostly drawn with the default sizes of some program.
void addWifSizes(CLI::App& app, WifSizeChoice& sizes) {
  addValue(app, "--wif-sizes", "file|keep", "sett and yarn count of a draft: as its file says, or the default's",
           [&sizes](const auto& option, const auto& text) { sizes = parseWifSizes(option, text); });
}

void addRender(CLI::App& app, RenderCommand& command) {
  app.add_option("FABRIC", command.input, "a fabric (.json) or draft (.wif), or a picture (.exr) to render again")
      ->type_name("");
  app.add_option("-o,--output", command.output, "the picture: .exr or .png")->type_name("OUT")->required();
  addPictureOptions(app, command.options);
  addFabricOptions(app, command.options);
  addWifSizes(app, command.wifSizes);
  addThreads(app, command.threads);
  addMemoryLimit(app, command.memoryLimit_bytes);
  addFibreExtent(app, command.fibreExtent);
  addExposure(app, command.tone);
  app.add_option("--stats", command.stats, "write counts and times of every stage, as JSON")->type_name("FILE.json");
  app.add_flag("--keep-sums", command.keepSums, "keep in the .exr what --resume needs");
  app.add_option("--resume", command.resume, "go on with this picture until it has --spp samples")
      ->type_name("FILE.exr");
}

void addInfo(CLI::App& app, InfoCommand& command) {
  addInput(app, "FABRIC", command.input);
  addFabricOptions(app, command.options);
  addWifSizes(app, command.wifSizes);
  app.add_flag("--json", command.json, "JSON instead of a table");
}

void addConvert(CLI::App& app, ConvertCommand& command) {
  addInput(app, "IN", command.input);
  app.add_option("OUT", command.output, "a fabric (.json), draft (.wif; for print .pdf) or weave bitmap (.png)")
      ->type_name("")
      ->required();
  app.add_flag("--draft", command.drawsDraft, "a .png shows the draft as it is printed, not a pixel a crossing");
  app.add_option("--like", command.like, "a fabric that gives yarns and all else but the weave")->type_name("FABRIC");
  addValue(app, "--structure", "NAME[,N...]", "in place of the weave: satin,8,3; other names are said",
           [&command](const auto& option, const auto& text) { command.structure = parseStructure(option, text); });
  app.add_option_function<std::vector<std::string>>(
         "--weave-colour",
         [&command](const std::vector<std::string>& texts) {
           for (const std::string& text : texts) command.colours.push_back(parseStructure("--weave-colour", text));
         },
         "IN is a picture, and its next colour, from dark to light, is woven as this: once for each of 1 to 32")
      ->type_name("NAME[,N...]")
      ->allow_extra_args(false);
  addValue(app, "--repeat", "WxH", "ends and picks that the picture takes; its pixels where not given",
           [&command](const auto& option, const auto& text) { command.repeat = parseSize(option, text); });
  addWifSizes(app, command.wifSizes);
}

void checkConvert(const ConvertCommand& command) {
  if (command.colours.size() > 32) throw UsageError("--weave-colour: expected at most 32 colours");
  if (command.structure && !command.colours.empty())
    throw UsageError("--weave-colour: expected no --structure, which stands in place of the whole weave");
  if (command.repeat && command.colours.empty()) throw UsageError("--repeat: expected --weave-colour as well");
}

void addTile(CLI::App& app, TileCommand& command) {
  addInput(app, "FABRIC", command.input);
  app.add_option("-o,--output", command.folder, "where the maps go; made where there is none")
      ->type_name("FOLDER")
      ->required();
  addValue(app, "--size", "N", "pixels of the longer side; 1024 where not given",
           [&command](const auto& option, const auto& text) {
             command.longestSide = static_cast<int>(parseWhole(option, text, 16, 16384));
           });
  addValue(app, "--spp", "N", "samples per pixel; 128 where not given",
           [&command](const auto& option, const auto& text) {
             command.options.samplesPerPixel = parseWholeField(option, text, &RenderSettings::samplesPerPixel);
           });
  addValue(app, "--seed", "N", "another number gives another pattern of noise",
           [&command](const auto& option, const auto& text) { command.options.seed = parseSeed(option, text); });
  addValue(app, "--method", "volume|fibres", "what light is traced through: the volume, or every fibre as it is",
           [&command](const auto& option, const auto& text) { command.options.method = parseMethod(option, text); });
  addResolution(app, command.options);
  addThreads(app, command.threads);
  addMemoryLimit(app, command.memoryLimit_bytes);
}

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
  addValue(app, "--threads", "N", "threads; as in the window, all but one, where not given",
           [&command](const auto& option, const auto& text) {
             command.threads = static_cast<int>(parseWhole(option, text, 1, 1024));
           });
}

void addConvergeBench(CLI::App& app, ConvergeBenchCommand& command) {
  app.add_option("-o,--output", command.folder, "the folder for page and tables; made where needed")->type_name("DIR");
  app.add_flag("--quick", command.quick, "one cloth, a small picture: a second instead of minutes");
  addThreads(app, command.threads);
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
  addExposure(app, command.tone);
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

/// Two files: a picture and its reference.
void addPair(CLI::App& app, const std::string& name, const std::string& help, std::optional<PictureNames>& pair) {
  app.add_option_function<std::vector<std::string>>(
         name,
         [&pair](const std::vector<std::string>& files) {
           pair = PictureNames{files.at(0), files.at(1)};
         },
         help)
      ->type_name("FILE FILE")
      ->type_size(2)
      ->expected(1)
      ->allow_extra_args(false);
}

void addCompare(CLI::App& app, CompareCommand& command) {
  app.add_option("PICTURE", command.pictures.picture, "an .exr")->type_name("")->required();
  app.add_option("REFERENCE", command.pictures.reference, "an .exr of the same size: what it ought to look like")
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

}  // namespace

Command parseCommandLine(const std::vector<std::string>& words) {
  EditCommand edit;
  RenderCommand render;
  InfoCommand info;
  ConvertCommand convert;
  TileCommand tile;
  BenchCommand bench;
  CompareCommand compare;
  BvdfCommand bvdf;
  BrdfCommand brdf;
  ReportBenchCommand table1{ReportBenchCommand::Suite::table1, {"bench-table1", false, defaultMemoryLimit_bytes()}};
  ReportBenchCommand figures{ReportBenchCommand::Suite::figures, {"bench-figures", false, defaultMemoryLimit_bytes()}};
  ReportBenchCommand accuracy{ReportBenchCommand::Suite::accuracy,
                              {"bench-accuracy", false, defaultMemoryLimit_bytes()}};
  EditBenchCommand editBench{"bench-edit"};
  UiBenchCommand uiBench;
  ConvergeBenchCommand convergeBench{"bench-converge"};

  CLI::App app("Woven fabric, path-traced from the optics of its fibres.", "loomlight");
  app.set_version_flag("--version", "loomlight " LOOMLIGHT_VERSION);
  app.require_subcommand(0, 1);
  addEdit(app, edit.options);
  CLI::App* const edits = app.add_subcommand("edit", "open the editor (also without this word)");
  addEdit(*edits, edit.options);
  CLI::App* const renders = app.add_subcommand("render", "render a fabric to a picture");
  addRender(*renders, render);
  CLI::App* const informs = app.add_subcommand("info", "what follows from a fabric: mass, cover, floats, voxels");
  addInfo(*informs, info);
  CLI::App* const converts = app.add_subcommand("convert", "between fabrics, drafts and weave bitmaps");
  addConvert(*converts, convert);
  CLI::App* const tiles =
      app.add_subcommand("tile", "a seamless tile for other programs: color, normal, height, opacity");
  addTile(*tiles, tile);
  CLI::App* const brdfs = app.add_subcommand("brdf", "how a flat patch reflects, seen from a half-dome of cameras");
  addBrdf(*brdfs, brdf);
  CLI::App* const benches =
      app.add_subcommand("bench", "measure: what a volume costs, or the report's table and figures");
  std::vector<std::string> noSuite;  // what stands where a suite should
  benches->add_option("SUITE", noSuite)->group("");
  CLI::App* const volumes = benches->add_subcommand("volume", "voxels, memory and speed at several resolutions");
  addVolumeBench(*volumes, bench);
  CLI::App* const tables = benches->add_subcommand("table1", "Table 1 of the report: explicit fibres and the volume");
  addReportBench(*tables, table1);
  CLI::App* const figuresOf = benches->add_subcommand("figures", "the report's figures, ours beside explicit fibres");
  addReportBench(*figuresOf, figures);
  CLI::App* const accuracies =
      benches->add_subcommand("accuracy", "how near the volume comes to its own fibres, by every estimator");
  addReportBench(*accuracies, accuracy);
  CLI::App* const editBenches =
      benches->add_subcommand("edit", "how soon the editor shows an edit, of every kind and on cloths of every size");
  addEditBench(*editBenches, editBench);
  CLI::App* const uiBenches =
      benches->add_subcommand("ui", "how long the window's thread does anything but draw while all is rebuilt");
  addUiBench(*uiBenches, uiBench.options);
  CLI::App* const convergeBenches =
      benches->add_subcommand("converge", "how fast pictures converge, with each way of sampling paths on and off");
  addConvergeBench(*convergeBenches, convergeBench);
  CLI::App* const compares = app.add_subcommand("compare", "how far a picture is from its reference");
  addCompare(*compares, compare);
  CLI::App* const visibilities = app.add_subcommand("bvdf", "bake the local visibility of a fabric's yarns (Fig. 8)");
  addBvdf(*visibilities, bvdf);

  try {
    app.parse(std::vector<std::string>(words.rbegin(), words.rend()));  // CLI11 takes them last to first
  } catch (const CLI::CallForHelp&) {
    return TextCommand{app.help()};  // of the command whose word was given, if one was
  } catch (const CLI::CallForVersion& version) {
    return TextCommand{std::string(version.what()) + "\n"};
  } catch (const CLI::ParseError& error) {
    throw UsageError(error.what());
  }

  if (*renders) {
    if (render.input.empty() && render.resume.empty()) throw UsageError("render: expected a FABRIC, or --resume");
    return render;
  }
  if (*informs) return info;
  if (*brdfs) {
    if (brdf.options.light && brdf.lightAngle_deg)
      throw UsageError("--light-angle: expected it alone or --light alone, got both");
    return brdf;
  }
  if (*converts) {
    checkConvert(convert);
    return convert;
  }
  if (*tiles) return tile;
  if (*tables) return table1;
  if (*figuresOf) return figures;
  if (*accuracies) return accuracy;
  if (*editBenches) return editBench;
  if (*uiBenches) return uiBench;
  if (*convergeBenches) return convergeBench;
  if (*volumes) return bench;
  if (*benches)
    throw UsageError(fmt::format("bench: expected volume, table1, figures, accuracy, edit, ui or converge, got '{}'",
                                 noSuite.empty() ? "" : noSuite.front()));
  if (*visibilities) return bvdf;
  if (*compares) {
    if (compare.yardstickAgain && !compare.yardstick)
      throw UsageError("--yardstick-again: expected --yardstick as well");
    return compare;
  }
  return edit;
}

}  // namespace loomlight
