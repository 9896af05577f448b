#include "app/editor/model/user_folders.h"

#include <pwd.h>
#include <unistd.h>

#include <cstdlib>

namespace loomlight {
namespace {

/// The variable if it is set to an absolute path, as the specification asks; else the folder below home.
std::filesystem::path baseFolder(const char* variable, const char* below) {
  const char* value = std::getenv(variable);
  if (value && *value == '/') return std::filesystem::path(value) / "loomlight";
  return homeFolder() / below / "loomlight";
}

}  // namespace

std::filesystem::path homeFolder() {
  const char* home = std::getenv("HOME");
  if (home && *home) return home;
  const passwd* const user = getpwuid(getuid());
  return user && user->pw_dir && *user->pw_dir ? user->pw_dir : "/";
}

std::filesystem::path presetFolder() {
  return baseFolder("XDG_DATA_HOME", ".local/share") / "presets";
}
std::filesystem::path viewFolder() {
  return baseFolder("XDG_DATA_HOME", ".local/share") / "views";
}
std::filesystem::path stateFolder() {
  return baseFolder("XDG_STATE_HOME", ".local/state");
}
std::filesystem::path settingsFile() {
  return baseFolder("XDG_CONFIG_HOME", ".config") / "editor.json";
}

}  // namespace loomlight
