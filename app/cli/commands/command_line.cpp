#include "app/cli/commands/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "app/cli/commands/measuring_options.h"
#include "app/cli/common_options.h"
#include "app/cli/structure_choice.h"
#include "app/cli/usage_error.h"
#include "app/cli/version_text.h"
#include "app/export/file_name.h"
#include "app/export/program_folders.h"
#include "core/fabric/json/fabric_schema.h"
#include "render/film/film.h"

namespace loomlight {
namespace {

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

/// All that a path of a picture depends on, so that `trace` can follow a path of what `render` made.
template <class PathCommand>
void addPathOptions(CLI::App& app, PathCommand& command) {
  addPictureOptions(app, command.options);
  addFabricOptions(app, command.options);
  addWifSizes(app, command.wifSizes);
  addThreads(app, command.threads);
  addMemoryLimit(app, command.memoryLimit_bytes);
  addFibreExtent(app, command.fibreExtent);
}

void addRender(CLI::App& app, RenderCommand& command) {
  app.add_option("FABRIC", command.input,
                 "a fabric (.json, .loomlight) or draft (.wif), or a picture (.exr) to render again")
      ->type_name("");
  app.add_option("-o,--output", command.output, "the picture: .exr or .png")->type_name("OUT")->required();
  addPathOptions(app, command);
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
  addValue(app, "--piece", "MxCM", "length in metres and width in cm that yarn is needed for; 10x150 where not given",
           [&command](const auto& option, const auto& text) { command.piece = parsePieceSize(option, text); });
  app.add_flag("--json", command.json, "JSON instead of a table");
}

void addConvert(CLI::App& app, ConvertCommand& command) {
  addInput(app, "IN", command.input);
  app.add_option("OUT", command.output,
                 "a fabric (.json, .loomlight), draft (.wif; for print .pdf) or weave bitmap (.png)")
      ->type_name("")
      ->required();
  app.add_flag("--draft", command.drawsDraft, "a .png shows the draft as it is printed, not a pixel a crossing");
  app.add_option("--like", command.like, "a fabric that gives yarns and all else but the weave")->type_name("FABRIC");
  addValue(app, "--structure", "NAME[,N...]", "in place of the weave: satin,8,3; other names are said",
           [&command](const auto& option, const auto& text) { command.structure = parseStructure(option, text); });
  addValues(
      app, "--weave-colour", "NAME[,N...]",
      "IN is a picture, and its next colour, from dark to light, is woven as this: once for each of 1 to 32",
      [&command](const auto& option, const auto& text) { command.colours.push_back(parseStructure(option, text)); });
  addValue(app, "--repeat", "WxH", "ends and picks that the picture takes; its pixels where not given",
           [&command](const auto& option, const auto& text) { command.repeat = parseSize(option, text); });
  addValues(app, "--cloth-colour", "FIBRE=#RRGGBB",
            "dye a fibre, by its name or its number from 1, so that the cloth has this colour where it lies on top; "
            "once for each fibre",
            [&command](const auto& option, const auto& text) {
              command.clothColours.push_back(parseClothColour(option, text));
            });
  addWifSizes(app, command.wifSizes);
}

void checkConvert(const ConvertCommand& command) {
  if (command.colours.size() > 32) throw UsageError("--weave-colour: expected at most 32 colours");
  if (command.structure && !command.colours.empty())
    throw UsageError("--weave-colour: expected no --structure, which stands in place of the whole weave");
  for (const MadeStructure& structure : command.colours)
    if (!structure.warpColours.empty())
      throw UsageError(fmt::format("--weave-colour: expected a structure of one colour, got {}", structure.name));
  if (command.repeat && command.colours.empty()) throw UsageError("--repeat: expected --weave-colour as well");
  if (!command.clothColours.empty() && !command.drawsDraft && lowerExtension(command.output) == ".png")
    throw UsageError("--cloth-colour: expected an OUT with colours, got a weave bitmap, which has none");
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
  addSampling(app, command.options, "samples per pixel; 128 where not given");
  addColourway(app, command.options);
  addResolution(app, command.options);
  addThreads(app, command.threads);
  addMemoryLimit(app, command.memoryLimit_bytes);
}

void addThumbnail(CLI::App& app, ThumbnailCommand& command) {
  addInput(app, "FABRIC", command.input);
  app.add_option("-o,--output", command.output, "the picture, a PNG whatever its name")->type_name("OUT")->required();
  addValue(app, "--size", "N", "pixels a side; 256 where not given", [&command](const auto& option, const auto& text) {
    command.side = static_cast<int>(parseWhole(option, text, 16, 2048));
  });
}

void addTrace(CLI::App& app, TraceCommand& command) {
  addInput(app, "FABRIC", command.input);
  addValue(app, "--pixel", "X,Y", "of the picture, from its top left, counted from 0",
           [&command](const auto& option, const auto& text) { command.pixel = parsePixel(option, text); });
  addValue(app, "--sample", "N", "of the pixel, counted from 0", [&command](const auto& option, const auto& text) {
    command.sample = static_cast<uint32_t>(parseWhole(option, text, 0, Film::maxSamples - 1));
  });
  for (const char* needed : {"--pixel", "--sample"}) app.get_option(needed)->required();
  addPathOptions(app, command);
}

}  // namespace

Command parseCommandLine(const std::vector<std::string>& words) {
  EditCommand edit;
  RenderCommand render;
  InfoCommand info;
  ConvertCommand convert;
  TileCommand tile;
  ThumbnailCommand thumbnail;
  BenchCommand bench;
  TraceCommand trace;
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
  ClearBenchCommand clearBench{"bench-clear"};

  CLI::App app("Woven fabric, path-traced from the optics of its fibres.", "loomlight");
  if (const auto samples = sampleFolder()) app.footer("Fabrics to begin with: " + samples->string());
  app.set_version_flag("--version", [] { return versionText(); });
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
  CLI::App* const thumbnails = app.add_subcommand("thumbnail", "a small picture of the weave, for file managers");
  addThumbnail(*thumbnails, thumbnail);
  CLI::App* const traces = app.add_subcommand("trace", "the path of one sample of one pixel, event by event");
  addTrace(*traces, trace);
  bool keysAlone = false;
  CLI::App* const schemas = app.add_subcommand("schema", "what a fabric's file may say, as a JSON schema");
  schemas->add_flag("--keys", keysAlone, "a list of all keys, for people");
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
  CLI::App* const clearBenches = benches->add_subcommand(
      "clear", "how soon after an edit the editor's picture is clear, on every drape and light");
  addClearBench(*clearBenches, clearBench);
  CLI::App* const compares = app.add_subcommand("compare", "how far a picture is from its reference");
  addCompare(*compares, compare);
  CLI::App* const visibilities = app.add_subcommand("bvdf", "bake the local visibility of a fabric's yarns (Fig. 8)");
  addBvdf(*visibilities, bvdf);

  try {
    app.parse(std::vector<std::string>(words.rbegin(), words.rend()));  // CLI11 takes them last to first
  } catch (const CLI::CallForHelp&) {
    return TextCommand{app.help()};  // of the command whose word was given, if one was
  } catch (const CLI::CallForVersion& version) {
    return TextCommand{version.what()};
  } catch (const CLI::ParseError& error) {
    throw UsageError(error.what());
  }

  if (*renders) {
    if (render.input.empty() && render.resume.empty()) throw UsageError("render: expected a FABRIC, or --resume");
    return render;
  }
  if (*informs) return info;
  if (*schemas) return TextCommand{keysAlone ? fabricKeys() : fabricSchema()};
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
  if (*thumbnails) return thumbnail;
  if (*traces) return trace;
  if (*tables) return table1;
  if (*figuresOf) return figures;
  if (*accuracies) return accuracy;
  if (*editBenches) return editBench;
  if (*uiBenches) return uiBench;
  if (*convergeBenches) return convergeBench;
  if (*clearBenches) return clearBench;
  if (*volumes) return bench;
  if (*benches)
    throw UsageError(
        fmt::format("bench: expected volume, table1, figures, accuracy, edit, clear, ui or converge, got '{}'",
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
