#include "app/cli/commands/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

#include "app/cli/commands/measuring_options.h"
#include "app/cli/common_options.h"
#include "app/cli/structure_choice.h"
#include "app/cli/usage_error.h"
#include "app/cli/version_text.h"
#include "app/export/program_folders.h"
#include "core/base/text.h"
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
  addThreads(app, command.threads);
  addMemoryLimit(app, command.memoryLimit_bytes);
  addFibreExtent(app, command.fibreExtent);
}

void addPartOptions(CLI::App& app, PartChoice& part) {
  addValue(app, "--samples-from", "N",
           "a part, for `loomlight merge`: only samples from this number on, counted from 0",
           [&part](const auto& option, const auto& text) {
             part.firstSample = static_cast<int>(parseWhole(option, text, 0, Film::maxSamples - 1));
           });
  addValue(app, "--samples", "K", "so many of them; up to --spp where not given",
           [&part](const auto& option, const auto& text) {
             part.samples = static_cast<int>(parseWhole(option, text, 1, Film::maxSamples));
           });
  addValue(app, "--crop", "X,Y,WxH", "a part: only these pixels, from the top left",
           [&part](const auto& option, const auto& text) { part.crop = parseCrop(option, text); });
}

void addSeriesOptions(CLI::App& app, RenderCommand& command) {
  addValue(app, "--turn", "camera|light[:N[,DEG]]",
           "N frames (36 where not given), in which one of them goes about the cloth, by 360 degrees or DEG",
           [&command](const auto& option, const auto& text) { command.turn = parseTurntable(option, text); });
  addValue(app, "--frames", "A..B", "only these frames of --turn, counted from 1",
           [&command](const auto& option, const auto& text) { command.frames = parseFrames(option, text); });
  addProgress(app, command.progress);
}

void addMerge(CLI::App& app, MergeCommand& command) {
  app.add_option("PART", command.parts, "what `loomlight render` made with --samples-from, --crop or --keep-sums")
      ->type_name("")
      ->required();
  app.add_option("-o,--output", command.output, "the picture: .exr or .png")->type_name("OUT")->required();
  app.add_flag("--partial", command.partial,
               "merge what there is, into a larger part, where some of the picture is missing");
  app.add_flag("--keep-sums", command.keepSums, "keep in the .exr what --resume and merge need");
  addTone(app, command.tone);
  addProgress(app, command.progress);
}

void addRender(CLI::App& app, RenderCommand& command) {
  app.add_option("FABRIC", command.inputs,
                 "fabrics (.json, .loomlight), drafts (.wif, .plm, .dtx, .twa), or pictures (.exr) to render again")
      ->type_name("");
  app.add_option("-o,--output", command.output,
                 "the picture: .exr or .png; of several, {} is the fabric's name and #### the frame's number")
      ->type_name("OUT")
      ->required();
  app.add_option("--list", command.list,
                 "a text file with the name of a fabric in each line (./#NAME where it begins with #)")
      ->type_name("FILE");
  addWifChoices(app, command.wif);
  addPartOptions(app, command.part);
  addSeriesOptions(app, command);
  addPathOptions(app, command);
  addTone(app, command.tone);
  app.add_option("--stats", command.stats, "write counts and times of every stage, as JSON")->type_name("FILE.json");
  app.add_flag("--keep-sums", command.keepSums, "keep in the .exr what --resume needs");
  app.add_option("--resume", command.resume, "go on with this picture until it has --spp samples")
      ->type_name("FILE.exr");
}

void addInfo(CLI::App& app, InfoCommand& command) {
  addInput(app, "FABRIC", command.input);
  addFabricOptions(app, command.options);
  addValue(app, "--piece", "MxCM", "length in metres and width in cm that yarn is needed for; 10x150 where not given",
           [&command](const auto& option, const auto& text) { command.piece = parsePieceSize(option, text); });
  addValue(app, "--float-limit", "MM", "floats that are longer are listed with their places; 4 where not given",
           [&command](const auto& option, const auto& text) {
             command.floatLimit_mm = parseNumber(option, text, 0.1, 100);
           });
  app.add_flag("--json", command.json, "JSON instead of a table");
}

void addConvert(CLI::App& app, ConvertCommand& command) {
  addInput(app, "IN", command.input);
  app.add_option(
         "OUT", command.output,
         "a fabric (.json, .loomlight), draft (.wif; for print .pdf) or weave bitmap (.png; for looms .tif, .bmp)")
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
  addValues(
      app, "--cloth-colour", "FIBRE=#RRGGBB|Lab|FILE",
      "dye a fibre, by its name or its number from 1, so that the cloth has this colour (#RRGGBB, or Lab "
      "L a b in daylight) where it lies on top, or reflects like a measured swatch (CGATS .txt, .cxf, .qtx, .csv; "
      "FILE:NAME for one of several); once for each fibre, or piece=... for all alike",
      [&command](const auto& option, const auto& text) {
        command.clothColours.push_back(parseClothColour(option, text));
      });
  app.add_option("--illuminant", command.illuminant,
                 "the lamp under which the cloth comes as near as it can to a measured swatch that it cannot reflect "
                 "like: as of colour; D65 where not given")
      ->type_name("NAME");
}

void checkConvert(const ConvertCommand& command) {
  if (command.colours.size() > 32) throw UsageError("--weave-colour: expected at most 32 colours");
  if (command.structure && !command.colours.empty())
    throw UsageError("--weave-colour: expected no --structure, which stands in place of the whole weave");
  for (const MadeStructure& structure : command.colours)
    if (!structure.warpColours.empty())
      throw UsageError(fmt::format("--weave-colour: expected a structure of one colour, got {}", structure.name));
  if (command.repeat && command.colours.empty()) throw UsageError("--repeat: expected --weave-colour as well");
  const auto isMeasured = [](const ClothColour& wish) { return !wish.swatch.empty(); };
  if (command.illuminant && std::none_of(command.clothColours.begin(), command.clothColours.end(), isMeasured))
    throw UsageError("--illuminant: expected --cloth-colour with a measured swatch as well");
  if (!command.clothColours.empty() && !command.drawsDraft && lowerExtension(command.output) == ".png")
    throw UsageError("--cloth-colour: expected an OUT with colours, got a weave bitmap, which has none");
}

/// What `tile` and `handover` have in common.
template <class TilingCommand>
void addTiling(CLI::App& app, TilingCommand& command) {
  addInput(app, "FABRIC", command.input);
  app.add_option("-o,--output", command.folder, "where the files go; made where there is none")
      ->type_name("FOLDER")
      ->required();
  addValue(app, "--size", "N", "pixels of the longer side; where not given 1024, or 16 for each thread",
           [&command](const auto& option, const auto& text) {
             command.order.longestSide = static_cast<int>(parseWhole(option, text, 16, 16384));
           });
  app.add_flag_callback(
      "--free-twist", [&command] { command.order.joinTwist = false; },
      "let twist end at the tile's edges, which may leave it many times smaller");
  addSampling(app, command.options, fmt::format("samples per pixel; {} where not given", TilingCommand::kSamples));
  addColourway(app, command.options);
  addResolution(app, command.options);
  addThreads(app, command.threads);
  addMemoryLimit(app, command.memoryLimit_bytes);
}

void addTile(CLI::App& app, TileCommand& command) {
  addTiling(app, command);
}

void addHandover(CLI::App& app, HandoverCommand& command) {
  addTiling(app, command);
  app.add_flag("--colourways", command.allColourways, "its colourways as well, each in a folder of its own");
  addValue(app, "--measure", "N", "paths for each camera that the surface is fitted to; 512 where not given",
           [&command](const auto& option, const auto& text) {
             command.order.measuringSamples = static_cast<int>(parseWhole(option, text, 1, 65536));
           });
}

void addSheet(CLI::App& app, SheetCommand& command) {
  addInput(app, "FABRIC", command.input);
  app.add_option("-o,--output", command.output, "the page, a .pdf")->type_name("OUT.pdf")->required();
  app.add_flag("--colourways", command.colourways, "all colourways at 1 : 1, in the place of the sheet");
  addValue(app, "--width", "CM", "of the finished cloth; 150 where not given",
           [&command](const auto& option, const auto& text) {
             command.options.width_cm = parseNumber(option, text, kPieceWidth_cm[0], kPieceWidth_cm[1]);
           });
  addValue(app, "--spp", "N", "samples per pixel of its pictures; 16 where not given",
           [&command](const auto& option, const auto& text) {
             command.options.samplesPerPixel = static_cast<int>(parseWhole(option, text, 1, 65536));
           });
  addValues(
      app, "--standard", "[PART=]FILE",
      "judge the cloth beside a measured swatch (CGATS .txt, .cxf, .qtx, .csv; FILE:NAME for one of several), or a "
      "yarn or fibre of that name where it lies on top; once for each",
      [&command](const auto&, const auto& text) { command.standards.push_back(text); });
  addValue(app, "--tolerance", "N", "the largest CMC(2:1) that passes; 1 where not given",
           [&command](const auto& option, const auto& text) {
             command.options.tolerance_cmc = parseNumber(option, text, 0, 100);
           });
  addThreads(app, command.threads);
  addMemoryLimit(app, command.options.memoryLimit_bytes);
}

void checkSheet(const SheetCommand& command) {
  if (command.colourways && !command.standards.empty())
    throw UsageError("--standard: expected no --colourways, whose page judges none of them");
}

void addThumbnail(CLI::App& app, ThumbnailCommand& command) {
  addInputFile(app, "FABRIC", command.input);
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

void checkRender(const RenderCommand& command) {
  const bool several = command.inputs.size() > 1 || !command.list.empty() || command.turn;
  if (command.inputs.empty() && command.list.empty() && command.resume.empty())
    throw UsageError("render: expected a FABRIC, --list, or --resume");
  if (several && !command.resume.empty()) throw UsageError("--resume: expected one picture, not several");
  if (command.frames && !command.turn) throw UsageError("--frames: expected --turn as well");
}

void checkMerge(const MergeCommand& command) {
  if ((command.partial || command.keepSums) && lowerExtension(command.output) != ".exr")
    throw UsageError("--partial and --keep-sums: expected an .exr, which can keep sums, got " + command.output);
}

void checkBrdf(const BrdfCommand& command) {
  if (command.options.light && command.lightAngle_deg)
    throw UsageError("--light-angle: expected it alone or --light alone, got both");
}

void checkCompare(const CompareCommand& command) {
  if (command.yardstickAgain && !command.yardstick) throw UsageError("--yardstick-again: expected --yardstick as well");
}

void addUi(CLI::App& app, UiBenchCommand& command) {
  addUiBench(app, command.options);
}

ReportBenchCommand reportBench(ReportBenchCommand::Suite suite, const char* folder) {
  return {suite, {folder, false, defaultMemoryLimit_bytes()}};
}

/// The words that choose a command, each with the options that it takes.
class CommandWords {
 public:
  /// `check`: throws UsageError for those that do not go together.
  template <class Options>
  void add(CLI::App& under, const char* word, const char* help, void (*addOptions)(CLI::App&, Options&),
           void (*check)(const std::type_identity_t<Options>&) = nullptr) {
    addGiven(under, word, help, addOptions, std::make_shared<Options>(), check);
  }
  /// `options`: what they are where none is given.
  template <class Options>
  void addBench(CLI::App& under, const char* word, const char* help, void (*addOptions)(CLI::App&, Options&),
                std::type_identity_t<Options> options) {
    addGiven<Options>(under, word, help, addOptions, std::make_shared<Options>(std::move(options)), nullptr);
  }
  /// None where no word was given.
  std::optional<Command> chosen() const {
    for (const auto& [app, command] : choices_)
      if (*app) return command();
    return std::nullopt;
  }

 private:
  template <class Options>
  void addGiven(CLI::App& under, const char* word, const char* help, void (*addOptions)(CLI::App&, Options&),
                const std::shared_ptr<Options>& given, void (*check)(const Options&)) {
    CLI::App* const app = under.add_subcommand(word, help);
    addOptions(*app, *given);
    choices_.emplace_back(app, [given, check]() -> Command {
      if (check) check(*given);
      return *given;
    });
  }

  std::vector<std::pair<CLI::App*, std::function<Command()>>> choices_;
};

void addBenches(CommandWords& words, CLI::App& benches) {
  using Suite = ReportBenchCommand::Suite;
  words.add(benches, "volume", "voxels, memory and speed at several resolutions", addVolumeBench);
  words.addBench(benches, "table1", "Table 1 of the report: explicit fibres and the volume", addReportBench,
                 reportBench(Suite::table1, "bench-table1"));
  words.addBench(benches, "figures", "the report's figures, ours beside explicit fibres", addReportBench,
                 reportBench(Suite::figures, "bench-figures"));
  words.addBench(benches, "accuracy", "how near the volume comes to its own fibres, by every estimator", addReportBench,
                 reportBench(Suite::accuracy, "bench-accuracy"));
  words.addBench(benches, "closeup", "what close-ups cost beside the volume, and how near they come to fibres",
                 addReportBench, reportBench(Suite::closeup, "bench-closeup"));
  words.addBench(benches, "edit", "how soon the editor shows an edit, of every kind and on cloths of every size",
                 addEditBench, {"bench-edit"});
  words.add(benches, "ui", "how long the window's thread does anything but draw while all is rebuilt", addUi);
  words.addBench(benches, "converge", "how fast pictures converge, with each way of sampling paths on and off",
                 addConvergeBench, {"bench-converge"});
  words.addBench(benches, "clear", "how soon after an edit the editor's picture is clear, on every drape and light",
                 addClearBench, {"bench-clear"});
  words.addBench(benches, "cloths", "what the trade says of cloths that have a name, beside what ours turn out as",
                 addClothsBench, {"bench-cloths"});
}

}  // namespace

Command parseCommandLine(const std::vector<std::string>& words) {
  CLI::App app("Woven fabric, path-traced from the optics of its fibres.", "loomlight");
  if (const auto samples = sampleFolder()) app.footer("Fabrics to begin with: " + samples->string());
  app.set_version_flag("--version", [] { return versionText(); });
  app.require_subcommand(0, 1);
  EditCommand edit;
  addEdit(app, edit.options);
  addEdit(*app.add_subcommand("edit", "open the editor (also without this word)"), edit.options);
  CommandWords commands;
  commands.add(app, "render", "render a fabric to a picture", addRender, checkRender);
  commands.add(app, "merge", "put together what was rendered in parts, to the bit of one run", addMerge, checkMerge);
  commands.add(app, "info", "what follows from a fabric: mass, cover, floats, voxels", addInfo);
  commands.add(app, "convert", "between fabrics, drafts and weave bitmaps", addConvert, checkConvert);
  commands.add(app, "tile", "a seamless tile for other programs: color, normal, height, opacity", addTile);
  commands.add(app, "handover",
               "both sides for CLO, Browzwear, Blender and others: U3M, glTF, MaterialX, maps, .jfab (experimental)",
               addHandover);
  commands.add(app, "sheet", "a page for the mill: cloth at 1 : 1, draft, colour orders, yarns, sett, mass", addSheet,
               checkSheet);
  commands.add(app, "colour", "what a spectrophotometer and a light booth say of a cloth, alone or beside a standard",
               addColour);
  commands.add(app, "thumbnail", "a small picture of the weave, for file managers", addThumbnail);
  commands.add(app, "trace", "the path of one sample of one pixel, event by event", addTrace);
  bool keysAlone = false;
  CLI::App* const schemas = app.add_subcommand("schema", "what a fabric's file may say, as a JSON schema");
  schemas->add_flag("--keys", keysAlone, "a list of all keys, for people");
  commands.add(app, "brdf", "how a flat patch reflects, seen from a half-dome of cameras", addBrdf, checkBrdf);
  CLI::App* const benches =
      app.add_subcommand("bench", "measure: what a volume costs, or the report's table and figures");
  std::vector<std::string> noSuite;  // what stands where a suite should
  benches->add_option("SUITE", noSuite)->group("");
  addBenches(commands, *benches);
  commands.add(app, "compare", "how far a picture is from its reference", addCompare, checkCompare);
  commands.add(app, "bvdf", "bake the local visibility of a fabric's yarns (Fig. 8)", addBvdf);

  try {
    app.parse(std::vector<std::string>(words.rbegin(), words.rend()));  // CLI11 takes them last to first
  } catch (const CLI::CallForHelp&) {
    return TextCommand{app.help()};  // of the command whose word was given, if one was
  } catch (const CLI::CallForVersion& version) {
    return TextCommand{version.what()};
  } catch (const CLI::ParseError& error) {
    throw UsageError(error.what());
  }

  if (*schemas) return TextCommand{keysAlone ? fabricKeys() : fabricSchema()};
  if (auto command = commands.chosen()) return *std::move(command);
  if (*benches)
    throw UsageError(fmt::format(
        "bench: expected volume, table1, figures, accuracy, closeup, edit, clear, cloths, ui or converge, got '{}'",
        noSuite.empty() ? "" : noSuite.front()));
  return edit;
}

}  // namespace loomlight
