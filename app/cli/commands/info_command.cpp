#include "app/cli/commands/info_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "app/cli/inputs.h"
#include "app/cli/interrupt.h"
#include "app/cli/progress.h"
#include "app/cli/volume_json.h"
#include "core/fabric/json/json_text.h"
#include "core/fabric/model/finish.h"
#include "core/fabric/model/thread_spacing.h"
#include "core/fabric/model/validate.h"
#include "core/fabric/model/wif_origin.h"
#include "core/fabric/model/yarn_count.h"
#include "core/fabric/weave/draft_derivation.h"
#include "core/fabric/weave/weave_code.h"
#include "core/fabric/yarn/cloth_states.h"
#include "core/fabric/yarn/derived.h"
#include "core/fabric/yarn/long_floats.h"
#include "render/scene/fibre_bricks.h"
#include "render/scene/scene.h"
#include "render/transport/yarn_names.h"

namespace loomlight {
namespace {

/// How a loom weaves it: the fabric's draft, or the smallest one of a weave that has none.
struct Loom {
  int shafts = 0, treadles = 0;
  const char* means = "";  ///< what says which shafts a pick lifts
  bool risingShed = true;
};

Loom loomOf(const Fabric& fabric) {
  const Draft draft = fabric.draft ? *fabric.draft : smallestDraft(fabric.weave);
  const char* const means = !fabric.draft ? "drawdown" : draft.liftplan.empty() ? "treadling" : "liftplan";
  return {draft.shafts, draft.treadles, means, draft.risingShed};
}

struct Information {
  Floats floats;
  LongFloats longFloats;
  Binding binding;
  Loom loom;
  CoverFactors cover;
  ClothMeasures measures;
  ClothStates states;
  PieceSize orderedPiece;
  std::vector<YarnNeed> needs;         ///< of the yarns, for that piece
  std::vector<std::string> yarnNames;  ///< of the same
  std::vector<std::string> warnings;
  VolumeCounts volume;
  int pieceEnds = 0, piecePicks = 0;
};

std::string selvedgeYarnName(const Fabric& fabric, const Information& of) {
  return fabric.mill.selvedgeYarn ? of.yarnNames[static_cast<size_t>(*fabric.mill.selvedgeYarn)] : std::string();
}

/// In the order in which a cloth goes through them, by their keys.
std::array<std::pair<const char*, const ClothState*>, 4> namedStates(const ClothStates& of) {
  return {{{"reed", &of.reed}, {"loom", &of.loom}, {"finished", &of.finished}, {"washed", &of.washed}}};
}

/// Of those yarns that are woven.
nlohmann::ordered_json needsJson(const Information& of) {
  nlohmann::ordered_json json;
  json["length_m"] = of.orderedPiece.length_m;
  json["width_cm"] = of.orderedPiece.width_cm;
  json["yarns"] = nlohmann::ordered_json::array();
  for (size_t i = 0; i < of.needs.size(); ++i) {
    const YarnNeed& need = of.needs[i];
    if (need.warp_m + need.weft_m > 0)
      json["yarns"].push_back(
          {{"name", of.yarnNames[i]}, {"warp_m", need.warp_m}, {"weft_m", need.weft_m}, {"mass_kg", need.mass_kg}});
  }
  return json;
}

/// How the yarns that are woven are spun, as a laboratory measures them.
struct SpunYarn {
  std::string name;
  double count_tex = 0;
  double hairinessH = 0;
  double evennessCv_percent = 0;
};

std::vector<SpunYarn> spunYarns(const Fabric& fabric, const Information& of) {
  std::vector<SpunYarn> spun;
  for (size_t i = 0; i < of.needs.size(); ++i) {
    if (of.needs[i].warp_m + of.needs[i].weft_m == 0) continue;
    const Yarn& yarn = fabric.yarns[i];
    const Fibre fibre = meanFibre(yarn, fabric.fibres);
    spun.push_back({of.yarnNames[i], yarnCount_tex(yarn, fibre), hairinessH(yarn, fibre), yarn.evennessCv_percent});
  }
  return spun;
}

nlohmann::ordered_json yarnsJson(const Fabric& fabric, const Information& of) {
  auto json = nlohmann::ordered_json::array();
  for (const SpunYarn& yarn : spunYarns(fabric, of))
    json.push_back({{"name", yarn.name},
                    {"count_tex", yarn.count_tex},
                    {"hairiness_h", yarn.hairinessH},
                    {"evenness_cv_percent", yarn.evennessCv_percent}});
  return json;
}

/// Ends and picks count from 1, as in a draft.
nlohmann::ordered_json longFloatsJson(const LongFloats& of) {
  nlohmann::ordered_json json{{"limit_mm", of.limit_mm}, {"count", of.count}};
  json["longest"] = nlohmann::ordered_json::array();
  for (const FloatRun& run : of.longest)
    json["longest"].push_back({{"system", run.system == System::warp ? "warp" : "weft"},
                               {"face", run.onFace},
                               {"thread", run.across + 1},
                               {"first", run.first + 1},
                               {"cells", run.cells},
                               {"endless", run.isEndless},
                               {"length_mm", run.length_mm}});
  return json;
}

/// What the mill has written, and each state of the cloth; a sett that is unknown is null.
void addMill(nlohmann::ordered_json& json, const Fabric& fabric, const Information& of) {
  const MillData& mill = fabric.mill;
  json["reed_per_10cm"] = mill.reed_per_10cm > 0 ? nlohmann::ordered_json(mill.reed_per_10cm) : nullptr;
  json["ends_per_dent"] = mill.endsPerDent;
  json["selvedge"] = {{"ends", mill.selvedgeEnds},
                      {"ends_per_dent", mill.selvedgeEndsPerDent},
                      {"yarn", selvedgeYarnName(fabric, of)},
                      {"weave", mill.selvedgeWeave}};
  const auto settJson = [](const KnownSett& sett) {
    nlohmann::ordered_json known{{"per_cm", nullptr}, {"from", sourceText(sett.source)}};
    if (sett.per_cm > 0) known["per_cm"] = sett.per_cm;
    return known;
  };
  for (const auto& [name, state] : namedStates(of.states))
    json["setts"][name] = {{"ends", settJson(state->ends)}, {"picks", settJson(state->picks)}};
  const auto width_cm = reedWidth_cm(fabric, of.states, of.orderedPiece.width_cm);
  json["reed_width_cm"] = width_cm ? nlohmann::ordered_json(*width_cm) : nullptr;
}

nlohmann::ordered_json toJson(const Fabric& fabric, const Information& of) {
  nlohmann::ordered_json json;
  json["name"] = fabric.name;
  json["ends"] = fabric.weave.ends();
  json["picks"] = fabric.weave.picks();
  if (const auto code = isoWeaveCode(fabric.weave)) json["iso_9354"] = *code;
  json["shafts"] = of.loom.shafts;
  json["treadles"] = of.loom.treadles;
  json["draft"] = {{"by", of.loom.means}, {"rising_shed", of.loom.risingShed}};
  if (fabric.wif) json["program"] = fabric.wif->program;
  json["warp_up_cells"] = of.binding.warpUpCells;
  json["warp_on_face"] = of.binding.warpOnFace;
  json["interlacings"] = of.binding.warpInterlacings + of.binding.weftInterlacings;
  json["max_warp_float"] = of.floats.warp();
  json["max_weft_float"] = of.floats.weft();
  json["max_warp_float_mm"] = floatLength_mm(fabric, System::warp, of.floats.warp());
  json["max_weft_float_mm"] = floatLength_mm(fabric, System::weft, of.floats.weft());
  json["unbound_ends"] = of.floats.idleEnds;
  json["unbound_picks"] = of.floats.idlePicks;
  json["max_warp_float_face"] = of.floats.warpFace;
  json["max_weft_float_face"] = of.floats.weftFace;
  json["long_floats"] = longFloatsJson(of.longFloats);
  json["ends_per_cm"] = fabric.ends_per_cm;
  json["picks_per_cm"] = fabric.picks_per_cm;
  if (!fabric.warpSpacing.empty()) json["warp_spacing"] = fabric.warpSpacing;
  if (!fabric.weftSpacing.empty()) json["weft_spacing"] = fabric.weftSpacing;
  json["repeat_width_mm"] = fabric.weave.ends() * fabric.warpPitch_mm();
  json["repeat_height_mm"] = fabric.weave.picks() * fabric.weftPitch_mm();
  json["pattern_ends"] = patternEnds(fabric);
  json["pattern_picks"] = patternPicks(fabric);
  json["pattern_width_mm"] = static_cast<double>(patternEnds(fabric)) * fabric.warpPitch_mm();
  json["pattern_height_mm"] = static_cast<double>(patternPicks(fabric)) * fabric.weftPitch_mm();
  json["warp_count_tex"] = meanCount_tex(fabric, System::warp);
  json["weft_count_tex"] = meanCount_tex(fabric, System::weft);
  json["cover_factor"] = of.cover.cloth;
  json["cover_factor_warp"] = of.cover.warp;
  json["cover_factor_weft"] = of.cover.weft;
  json["cover_fraction"] = of.cover.fraction;
  json["area_covered"] = of.measures.cover;
  json["areal_mass_g_m2"] = of.measures.arealMass_g_m2;
  json["thickness_mm"] = of.measures.thickness_mm;
  json["crimp_warp"] = of.measures.crimpWarp;
  json["crimp_weft"] = of.measures.crimpWeft;
  json["press"] = fabric.press;
  json["milling"] = fabric.milling;
  addMill(json, fabric, of);
  json["yarns"] = yarnsJson(fabric, of);
  json["yarn_need"] = needsJson(of);
  json["warnings"] = of.warnings;
  json["piece_ends"] = of.pieceEnds;
  json["piece_picks"] = of.piecePicks;
  json["resolution"] = fabric.render.resolution;
  addVolume(json, of.volume);
  json["segments_represented"] = of.volume.segmentsRepresented;
  return json;
}

void line(const std::string& label, const std::string& value, const std::string& remark = "") {
  fmt::print("  {:<22}{:>14}{}{}\n", label, value, remark.empty() ? "" : "  ", remark);
}

/// What is known of it; that the rest is not reckoned is said.
void printShrinkage(const ClothStates& states) {
  const auto text = [](const std::optional<double>& percent) {
    return percent ? fmt::format("{:.1f}", *percent) : std::string("?");
  };
  const auto shrinks = [&](const char* label, const ClothState& before, const ClothState& after) {
    const std::optional<double> width = shrinkage_percent(before.ends, after.ends);
    const std::optional<double> length = shrinkage_percent(before.picks, after.picks);
    if (width || length) line(label, fmt::format("{} x {}", text(width), text(length)), "%, width x length");
  };
  shrinks("shrinks from the reed", states.reed, states.finished);
  shrinks("shrinks off the loom", states.loom, states.finished);
  shrinks("shrinks in the wash", states.finished, states.washed);
  fmt::print("  Shrinkage is not modelled: setts off the loom and after the wash are what the mill has counted.\n");
}

void printMill(const Fabric& fabric, const Information& of) {
  fmt::print("\nFrom the reed to the wash\n");
  const MillData& mill = fabric.mill;
  if (mill.reed_per_10cm > 0)
    line("reed", fmt::format("{:g}", mill.reed_per_10cm),
         fmt::format("dents/10 cm, ends per dent {}", dentingText(mill.endsPerDent)));
  const std::string selvedges = selvedgeText(mill, selvedgeYarnName(fabric, of));
  if (!selvedges.empty()) line("selvedges", "", selvedges);
  const char* const labels[] = {"sett in the reed", "sett in loom state", "sett, finished", "sett, washed"};
  const auto states = namedStates(of.states);
  for (size_t i = 0; i < states.size(); ++i) {
    const auto& [ends, picks] = *states[i].second;
    const std::string remark = ends.source == picks.source ? std::string(sourceText(ends.source))
                                                           : fmt::format("ends: {}; picks: {}", sourceText(ends.source),
                                                                         sourceText(picks.source));
    line(labels[i], fmt::format("{} x {}", settText(ends, "?"), settText(picks, "?")), "per cm, " + remark);
  }
  if (const auto width_cm = reedWidth_cm(fabric, of.states, of.orderedPiece.width_cm))
    line("width in the reed", fmt::format("{:.1f}", *width_cm),
         fmt::format("cm, with the selvedges, for {:g} cm finished", of.orderedPiece.width_cm));
  printShrinkage(of.states);
}

void printYarns(const Fabric& fabric, const Information& of) {
  fmt::print("\nYarns as they are spun\n");
  for (const SpunYarn& yarn : spunYarns(fabric, of))
    line(yarn.name, fmt::format("{:.1f} tex", yarn.count_tex),
         fmt::format("hairiness H {:.1f}, CVm {:g} %", yarn.hairinessH, yarn.evennessCv_percent));
}

void printNeeds(const Information& of) {
  fmt::print("\nYarn for a piece of {:g} m x {:g} cm\n", of.orderedPiece.length_m, of.orderedPiece.width_cm);
  for (size_t i = 0; i < of.needs.size(); ++i) {
    const YarnNeed& need = of.needs[i];
    if (need.warp_m + need.weft_m > 0)
      line(of.yarnNames[i], fmt::format("{:.0f} m", need.warp_m + need.weft_m),
           fmt::format("{:.3f} kg; warp {:.0f} m, weft {:.0f} m", need.mass_kg, need.warp_m, need.weft_m));
  }
}

/// The longest of them, each with its place.
void printLongFloats(const LongFloats& of) {
  constexpr size_t kShown = 10;
  line("long floats", fmt::format("{}", of.count), fmt::format("a repeat, of more than {:g} mm", of.limit_mm));
  for (size_t i = 0; i < std::min(kShown, of.longest.size()); ++i) {
    const FloatRun& run = of.longest[i];
    const bool isWarp = run.system == System::warp;
    line("", fmt::format("{:.2f} mm", run.length_mm),
         fmt::format("{} {}, from {} {} over {}{}, on the {}", isWarp ? "end" : "pick", run.across + 1,
                     isWarp ? "pick" : "end", run.first + 1, run.cells, run.isEndless ? ", bound by none" : "",
                     run.onFace ? "face" : "back"));
  }
}

/// The pattern is the weave together with its orders of colours.
void printRepeat(const Fabric& fabric, const char* label, int64_t ends, int64_t picks) {
  line(label,
       fmt::format("{:.2f} x {:.2f}", static_cast<double>(ends) * fabric.warpPitch_mm(),
                   static_cast<double>(picks) * fabric.weftPitch_mm()),
       fmt::format("mm, {} x {} threads", ends, picks));
}

/// Of a thread that nothing binds no number can be said.
void printLongestFloat(const Fabric& fabric, System system, const Floats& floats) {
  const bool isWarp = system == System::warp;
  const int unbound = isWarp ? floats.idleEnds : floats.idlePicks, cells = isWarp ? floats.warp() : floats.weft();
  const char* const label = isWarp ? "longest warp float" : "longest weft float";
  if (unbound > 0)
    line(label, "endless", fmt::format("{} bound by none: {}", isWarp ? "ends" : "picks", unbound));
  else
    line(label, fmt::format("{}", cells),
         fmt::format("{}, {:.2f} mm", isWarp ? "picks" : "ends", floatLength_mm(fabric, system, cells)));
}

void printTable(const Fabric& fabric, const Information& of) {
  fmt::print("{}\n\nWeave\n", fabric.name);
  line("repeat", fmt::format("{} x {}", fabric.weave.ends(), fabric.weave.picks()), "ends x picks");
  if (const auto code = isoWeaveCode(fabric.weave)) line("ISO 9354", *code);
  line("shafts", fmt::format("{}", of.loom.shafts), fabric.draft ? "" : "the fewest that weave it");
  line("treadles", fmt::format("{}", of.loom.treadles));
  if (fabric.draft) line("draft", of.loom.means, of.loom.risingShed ? "rising shed" : "sinking shed");
  if (fabric.wif) line("written by", fabric.wif->program);
  line("warp on the face", fmt::format("{:.0f} %", 100 * of.binding.warpOnFace),
       fmt::format("{} of {} crossings", of.binding.warpUpCells,
                   static_cast<int64_t>(fabric.weave.ends()) * fabric.weave.picks()));
  printLongestFloat(fabric, System::warp, of.floats);
  printLongestFloat(fabric, System::weft, of.floats);
  printLongFloats(of.longFloats);
  line("interlacings", fmt::format("{}", of.binding.warpInterlacings + of.binding.weftInterlacings), "a repeat");
  fmt::print("\nCloth\n");
  line("sett", fmt::format("{:g} x {:g}", fabric.ends_per_cm, fabric.picks_per_cm), "per cm");
  for (const auto& [label, spacing] :
       {std::pair("ends apart", fabric.warpSpacing), {"picks apart", fabric.weftSpacing}})
    if (!spacing.empty()) line(label, spacingText(spacing), "over each other, repeating");
  printRepeat(fabric, "weave repeat", fabric.weave.ends(), fabric.weave.picks());
  printRepeat(fabric, "pattern repeat", patternEnds(fabric), patternPicks(fabric));
  line("yarn count",
       fmt::format("{:.1f} x {:.1f}", meanCount_tex(fabric, System::warp), meanCount_tex(fabric, System::weft)),
       "tex, warp x weft");
  line("cover factor", fmt::format("{:.1f}", of.cover.cloth),
       fmt::format("Peirce: ends or picks per inch over the root of Ne; warp {:.1f}, weft {:.1f}, 28 is closed",
                   of.cover.warp, of.cover.weft));
  line("area covered", fmt::format("{:.0f} %", 100 * of.measures.cover),
       fmt::format(
           "seen from straight above, by yarns as they are pressed; by round ones {:.0f} %, the cover factor over 28",
           100 * of.cover.fraction));
  line("mass", fmt::format("{:.1f}", of.measures.arealMass_g_m2), "g/m2");
  line("thickness", fmt::format("{:.3f}", of.measures.thickness_mm), "mm");
  line("crimp of the warp", fmt::format("{:.1f} %", 100 * of.measures.crimpWarp));
  line("crimp of the weft", fmt::format("{:.1f} %", 100 * of.measures.crimpWeft));
  line("press", fmt::format("{:g}", fabric.press), "0 washed, 0.5 pressed, 1 calendered");
  if (fabric.milling > 0) line("milling", fmt::format("{:g}", fabric.milling), "0 clear, 1 felted");
  fmt::print("  All of this is of the finished cloth, at the setts given.\n");
  printMill(fabric, of);
  printYarns(fabric, of);
  printNeeds(of);
  fmt::print("\nVolume\n");
  line("piece", fmt::format("{} x {}", of.pieceEnds, of.piecePicks), "ends x picks");
  line("resolution", fmt::format("{}", fabric.render.resolution), "voxels per yarn diameter");
  line("distinct bricks", fmt::format("{}", of.volume.bricks));
  line("voxels", fmt::format("{}", of.volume.voxels));
  line("components", fmt::format("{}", of.volume.components));
  line("memory", fmt::format("{:.2f}", static_cast<double>(of.volume.bytes) / 1e6), "MB");
  line("fibre segments", fmt::format("{:.3g}", of.volume.segmentsRepresented), "represented");
  if (!of.warnings.empty()) fmt::print("\nWarnings\n");
  for (const std::string& warning : of.warnings) fmt::print("  {}\n", warning);
}

}  // namespace

int run(const InfoCommand& command) {
  const Interrupt interrupt;
  FabricInput input = readInput(command.input);
  Fabric fabric = withOptions(std::move(input.fabric), command.options, command.input.file);
  validate(fabric, command.input.file);
  const auto named = std::make_shared<const Fabric>(fabric);  // under its own lamps
  fabric.light = Light{};
  fabric.light.kind = LightKind::dome;  // no figure depends on light, so no environment need be loaded

  std::shared_ptr<const Scene> scene;
  {
    Progress progress("voxelising");
    scene = makeScene(std::make_shared<const Fabric>(fabric), progress.of(interrupt.task(0)));
  }
  auto names = scene ? yarnNames(*named, interrupt.task(0)) : std::nullopt;
  if (!names) return Interrupt::kExitStatus;
  const ClothGeometry& geometry = scene->cloth->volume->geometry();
  Information information;
  information.floats = floats(fabric.weave);
  information.longFloats = longFloats(fabric, command.floatLimit_mm);
  information.binding = binding(fabric.weave);
  information.loom = loomOf(fabric);
  information.cover = coverFactors(fabric);
  information.measures = geometry.measure();
  information.states = clothStates(fabric, Crimps{information.measures.crimpWarp, information.measures.crimpWeft});
  information.orderedPiece = command.piece;
  information.needs = yarnNeed(fabric, command.piece, information.measures.crimpWarp, information.measures.crimpWeft);
  information.yarnNames = std::move(*names);
  information.warnings = std::move(input.warnings);
  for (std::string& warning : warnings(fabric, information.floats, information.longFloats))
    information.warnings.push_back(std::move(warning));
  for (std::string& remark : geometry.spacingRemarks()) information.warnings.push_back(std::move(remark));
  information.volume = scene->cloth->volume->counts();
  if (std::string none = FibreBricks::whyNone(information.volume); !none.empty())
    information.warnings.push_back(std::move(none));
  information.pieceEnds = geometry.ends();
  information.piecePicks = geometry.picks();
  if (command.json)
    fmt::print("{}\n", jsonText(toJson(fabric, information), 2));
  else
    printTable(fabric, information);
  return 0;
}

}  // namespace loomlight
