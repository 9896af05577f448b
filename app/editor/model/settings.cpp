#include "app/editor/model/settings.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <type_traits>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/memory.h"
#include "core/fabric/json/json_text.h"
#include "ui/dialogs/preferences_dialog.h"
#include "ui/inspector/cloth_colour.h"
#include "ui/viewport/viewport_panel.h"

namespace loomlight {

double defaultFibreMemory_GB() {
  return std::clamp(std::round(3.75e-9 * static_cast<double>(physicalMemory_bytes())) / 10, 0.1, 65536.0);
}

namespace {

/// What the file says, or the default where it says nothing of the kind: one value that makes no sense costs no other.
template <class T>
T valueOf(const nlohmann::json& json, const char* key, T otherwise) {
  const auto found = json.find(key);
  if (found == json.end()) return otherwise;
  constexpr bool isCount = std::is_integral_v<T> && !std::is_same_v<T, bool>;
  if (isCount && !found->is_number_integer()) return otherwise;  // 1e300 fits no int
  try {
    return found->template get<T>();
  } catch (const nlohmann::json::exception&) {
    return otherwise;
  }
}

/// Origins by name, so that the file says what it means.
constexpr const char* kOrigins[] = {"bottom_left", "bottom_right", "top_left", "top_right"};

DraftPreferences draftPreferences(const nlohmann::json& json, DraftPreferences draft) {
  const std::string origin = valueOf(json, "draft_origin", std::string());
  for (int i = 0; i < static_cast<int>(std::size(kOrigins)); ++i)
    if (origin == kOrigins[i]) draft.origin = static_cast<DraftPreferences::Origin>(i);
  draft.inches = valueOf(json, "draft_inches", draft.inches);
  draft.rulers = valueOf(json, "draft_rulers", draft.rulers);
  draft.loom.shafts = std::clamp(valueOf(json, "loom_shafts", draft.loom.shafts), 1, 256);
  draft.loom.treadles = std::clamp(valueOf(json, "loom_treadles", draft.loom.treadles), 1, 256);
  draft.longFloat_mm = std::clamp(valueOf(json, "long_float_mm", draft.longFloat_mm), 0.1, 100.0);
  return draft;
}

ViewSettings viewSettings(const nlohmann::json& json, ViewSettings view) {
  view.denoised = valueOf(json, "denoised", view.denoised);
  view.filmic = valueOf(json, "filmic", view.filmic);
  view.exposure_stops =
      std::clamp(valueOf(json, "exposure_stops", view.exposure_stops), -kMostExposure_stops, kMostExposure_stops);
  view.draftInColour = valueOf(json, "draft_in_colour", view.draftInColour);
  view.draftBack = valueOf(json, "draft_back", view.draftBack);
  view.marksFloats = valueOf(json, "draft_marks_floats", view.marksFloats);
  view.booth = valueOf(json, "booth_side_by_side", view.booth);
  return view;
}

/// Sources by name.
constexpr const char* kProfileSources[] = {"srgb", "system", "file"};

DisplayColours displayColours(const nlohmann::json& json, DisplayColours colours) {
  const std::string source = valueOf(json, "display_profile", std::string());
  for (int i = 0; i < static_cast<int>(std::size(kProfileSources)); ++i)
    if (source == kProfileSources[i]) colours.source = static_cast<DisplayColours::Source>(i);
  colours.displayFile = valueOf(json, "display_profile_file", colours.displayFile);
  colours.printerFile = valueOf(json, "printer_profile_file", colours.printerFile);
  colours.proofs = valueOf(json, "soft_proof", colours.proofs);
  colours.warnsOfGamut = valueOf(json, "gamut_warning", colours.warnsOfGamut);
  return colours;
}

/// All but the caption, which is of one picture.
SnapshotOptions snapshotOptions(const nlohmann::json& json, SnapshotOptions options) {
  options.inMillimetres = valueOf(json, "snapshot_in_mm", options.inMillimetres);
  options.width_mm =
      std::clamp(valueOf(json, "snapshot_width_mm", options.width_mm), kPrintSide_mm[0], kPrintSide_mm[1]);
  options.height_mm =
      std::clamp(valueOf(json, "snapshot_height_mm", options.height_mm), kPrintSide_mm[0], kPrintSide_mm[1]);
  options.dpi =
      std::clamp(valueOf(json, "snapshot_dpi", options.dpi), kPrintResolution_dpi[0], kPrintResolution_dpi[1]);
  options.scale = valueOf(json, "snapshot_actual_size", false) ? SnapshotScale::actualSize : SnapshotScale::asSeen;
  options.scaleBar = valueOf(json, "snapshot_scale_bar", options.scaleBar);
  return options;
}

constexpr CountSystem kCounts[] = {CountSystem::tex,    CountSystem::dtex,    CountSystem::denier, CountSystem::metric,
                                   CountSystem::cotton, CountSystem::worsted, CountSystem::linen};

TradeUnits tradeUnits(const nlohmann::json& json, TradeUnits units) {
  const std::string count = valueOf(json, "count_unit", std::string());
  for (const CountSystem system : kCounts)
    if (count == countUnit(system)) units.count = system;
  units.twistAsMultiplier = valueOf(json, "twist_multiplier", units.twistAsMultiplier);
  units.piece.length_m =
      std::clamp(valueOf(json, "piece_length_m", units.piece.length_m), kPieceLength_m[0], kPieceLength_m[1]);
  units.piece.width_cm =
      std::clamp(valueOf(json, "piece_width_cm", units.piece.width_cm), kPieceWidth_cm[0], kPieceWidth_cm[1]);
  return units;
}

BookShelf bookShelf(const nlohmann::json& json) {
  BookShelf shelf;
  for (const nlohmann::json& file : valueOf(json, "colour_books", nlohmann::json::array()))
    if (file.is_string() && shelf.files.size() < kMostBooks) shelf.files.push_back(file.get<std::string>());
  const int open = valueOf(json, "colour_book", -1);
  if (open >= 0 && open < static_cast<int>(shelf.files.size())) shelf.wanted = open;
  return shelf;
}

std::vector<RecentFile> recentFiles(const nlohmann::json& json) {
  std::vector<RecentFile> files;
  for (const nlohmann::json& file : json)
    if (file.is_string() && files.size() < kMostRecentFiles) files.push_back({file.get<std::string>(), false});
  return files;
}

}  // namespace

Settings readSettings(const std::filesystem::path& file) {
  constexpr size_t kMostBytes = 1'000'000;
  Settings settings;
  try {
    const nlohmann::json json = nlohmann::json::parse(readFile(file.string(), kMostBytes));
    settings.windowWidth = std::clamp(valueOf(json, "window_width", settings.windowWidth), 960, 16384);
    settings.windowHeight = std::clamp(valueOf(json, "window_height", settings.windowHeight), 600, 16384);
    settings.darkTheme = valueOf(json, "dark_theme", settings.darkTheme);
    settings.interfaceSize =
        std::clamp(valueOf(json, "interface_size", settings.interfaceSize), kInterfaceSizes[0], kInterfaceSizes[4]);
    settings.rulerFactor =
        std::clamp(valueOf(json, "ruler_factor", settings.rulerFactor), kRulerFactor[0], kRulerFactor[1]);
    settings.dock.draftWidth = std::clamp(valueOf(json, "draft_width", settings.dock.draftWidth), 0.0f, 4000.0f);
    settings.dock.inspectorWidth =
        std::clamp(valueOf(json, "inspector_width", settings.dock.inspectorWidth), 0.0f, 4000.0f);
    settings.limits.fibreMemory_GB =
        std::clamp(valueOf(json, "fibre_memory_gb", settings.limits.fibreMemory_GB), 0.1, 65536.0);
    settings.limits.samples =
        std::clamp(valueOf(json, "viewport_samples", settings.limits.samples), kSampleLimits[0], kSampleLimits[1]);
    settings.folder = valueOf(json, "folder", settings.folder);
    settings.recent = recentFiles(valueOf(json, "recent", nlohmann::json::array()));
    settings.hintsSeen = valueOf(json, "hints_seen", true);
    settings.draft = draftPreferences(json, settings.draft);
    settings.colours = displayColours(json, settings.colours);
    settings.units = tradeUnits(json, settings.units);
    settings.books = bookShelf(json);
    settings.tolerance_cmc =
        std::clamp(valueOf(json, "tolerance_cmc", settings.tolerance_cmc), kTolerance_cmc[0], kTolerance_cmc[1]);
    settings.view = viewSettings(json, settings.view);
    settings.snapshot = snapshotOptions(json, settings.snapshot);
  } catch (const InputError&) {
    return Settings();
  } catch (const nlohmann::json::exception&) {
    return Settings();
  }
  return settings;
}

void writeSettings(const std::filesystem::path& file, const Settings& settings) {
  nlohmann::json recent = nlohmann::json::array();
  for (const RecentFile& file : settings.recent) recent.push_back(file.file);
  const nlohmann::json json = {{"window_width", settings.windowWidth},
                               {"window_height", settings.windowHeight},
                               {"dark_theme", settings.darkTheme},
                               {"interface_size", settings.interfaceSize},
                               {"ruler_factor", settings.rulerFactor},
                               {"draft_width", settings.dock.draftWidth},
                               {"inspector_width", settings.dock.inspectorWidth},
                               {"fibre_memory_gb", settings.limits.fibreMemory_GB},
                               {"viewport_samples", settings.limits.samples},
                               {"draft_origin", kOrigins[static_cast<int>(settings.draft.origin)]},
                               {"draft_inches", settings.draft.inches},
                               {"draft_rulers", settings.draft.rulers},
                               {"loom_shafts", settings.draft.loom.shafts},
                               {"loom_treadles", settings.draft.loom.treadles},
                               {"long_float_mm", settings.draft.longFloat_mm},
                               {"display_profile", kProfileSources[static_cast<int>(settings.colours.source)]},
                               {"display_profile_file", settings.colours.displayFile},
                               {"printer_profile_file", settings.colours.printerFile},
                               {"soft_proof", settings.colours.proofs},
                               {"gamut_warning", settings.colours.warnsOfGamut},
                               {"denoised", settings.view.denoised},
                               {"filmic", settings.view.filmic},
                               {"exposure_stops", settings.view.exposure_stops},
                               {"draft_in_colour", settings.view.draftInColour},
                               {"draft_back", settings.view.draftBack},
                               {"draft_marks_floats", settings.view.marksFloats},
                               {"booth_side_by_side", settings.view.booth},
                               {"snapshot_in_mm", settings.snapshot.inMillimetres},
                               {"snapshot_width_mm", settings.snapshot.width_mm},
                               {"snapshot_height_mm", settings.snapshot.height_mm},
                               {"snapshot_dpi", settings.snapshot.dpi},
                               {"snapshot_actual_size", settings.snapshot.scale == SnapshotScale::actualSize},
                               {"snapshot_scale_bar", settings.snapshot.scaleBar},
                               {"count_unit", countUnit(settings.units.count)},
                               {"twist_multiplier", settings.units.twistAsMultiplier},
                               {"piece_length_m", settings.units.piece.length_m},
                               {"piece_width_cm", settings.units.piece.width_cm},
                               {"colour_books", settings.books.files},
                               {"colour_book", settings.books.open},
                               {"tolerance_cmc", settings.tolerance_cmc},
                               {"folder", settings.folder},
                               {"recent", recent},
                               {"hints_seen", settings.hintsSeen}};
  // The name of a folder may be no UTF-8, which is no reason to lose the rest.
  const std::string text = jsonText(json, 2);
  std::error_code ignored;  // where the folder cannot be made, writing says so
  std::filesystem::create_directories(file.parent_path(), ignored);
  writeFileAtomically(file.string(), text + "\n");
}

}  // namespace loomlight
