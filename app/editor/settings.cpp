#include "app/editor/settings.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/memory.h"

namespace loomlight {

double defaultFibreMemory_GB() {
  return std::clamp(std::round(3.75e-9 * static_cast<double>(physicalMemory_bytes())) / 10, 0.1, 65536.0);
}

namespace {

/// Origins by name, so that the file says what it means.
constexpr const char* kOrigins[] = {"bottom_left", "bottom_right", "top_left", "top_right"};

DraftPreferences draftPreferences(const nlohmann::json& json, DraftPreferences draft) {
  const std::string origin = json.value("draft_origin", std::string());
  for (int i = 0; i < static_cast<int>(std::size(kOrigins)); ++i)
    if (origin == kOrigins[i]) draft.origin = static_cast<DraftPreferences::Origin>(i);
  draft.inches = json.value("draft_inches", draft.inches);
  draft.rulers = json.value("draft_rulers", draft.rulers);
  draft.loom.shafts = std::clamp(json.value("loom_shafts", draft.loom.shafts), 1, 256);
  draft.loom.treadles = std::clamp(json.value("loom_treadles", draft.loom.treadles), 1, 256);
  draft.longFloat_mm = std::clamp(json.value("long_float_mm", draft.longFloat_mm), 0.1, 100.0);
  return draft;
}

}  // namespace

Settings readSettings(const std::filesystem::path& file) {
  constexpr size_t kMostBytes = 65536;
  Settings settings;
  try {
    const nlohmann::json json = nlohmann::json::parse(readFile(file.string(), kMostBytes));
    settings.windowWidth = std::clamp(json.value("window_width", settings.windowWidth), 960, 16384);
    settings.windowHeight = std::clamp(json.value("window_height", settings.windowHeight), 600, 16384);
    settings.darkTheme = json.value("dark_theme", settings.darkTheme);
    settings.desk.draftWidth = std::clamp(json.value("draft_width", settings.desk.draftWidth), 100.0f, 4000.0f);
    settings.desk.inspectorWidth =
        std::clamp(json.value("inspector_width", settings.desk.inspectorWidth), 100.0f, 4000.0f);
    settings.fibreMemory_GB = std::clamp(json.value("fibre_memory_gb", settings.fibreMemory_GB), 0.1, 65536.0);
    settings.folder = json.value("folder", settings.folder);
    settings.draft = draftPreferences(json, settings.draft);
  } catch (const InputError&) {
    return Settings();
  } catch (const nlohmann::json::exception&) {
    return Settings();
  }
  return settings;
}

void writeSettings(const std::filesystem::path& file, const Settings& settings) {
  const nlohmann::json json = {{"window_width", settings.windowWidth},
                               {"window_height", settings.windowHeight},
                               {"dark_theme", settings.darkTheme},
                               {"draft_width", settings.desk.draftWidth},
                               {"inspector_width", settings.desk.inspectorWidth},
                               {"fibre_memory_gb", settings.fibreMemory_GB},
                               {"draft_origin", kOrigins[static_cast<int>(settings.draft.origin)]},
                               {"draft_inches", settings.draft.inches},
                               {"draft_rulers", settings.draft.rulers},
                               {"loom_shafts", settings.draft.loom.shafts},
                               {"loom_treadles", settings.draft.loom.treadles},
                               {"long_float_mm", settings.draft.longFloat_mm},
                               {"folder", settings.folder}};
  try {
    std::error_code ignored;
    std::filesystem::create_directories(file.parent_path(), ignored);
    writeFileAtomically(file.string(), json.dump(2) + "\n");
  } catch (const InputError&) {
    return;
  }
}

}  // namespace loomlight
