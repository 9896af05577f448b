#pragma once

#include <filesystem>

namespace loomlight {

/// Where the editor keeps what belongs to its user (XDG base directories).
std::filesystem::path homeFolder();
std::filesystem::path presetFolder();  ///< $XDG_DATA_HOME/loomlight/presets
std::filesystem::path stateFolder();   ///< $XDG_STATE_HOME/loomlight: autosaves
std::filesystem::path viewFolder();    ///< $XDG_DATA_HOME/loomlight/views: kept views
std::filesystem::path settingsFile();  ///< $XDG_CONFIG_HOME/loomlight/editor.json

}  // namespace loomlight
