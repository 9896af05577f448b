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
