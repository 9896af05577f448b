#include "app/editor/preset_store.h"

#include <fmt/core.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/fabric/fabric_json.h"

namespace loomlight {
namespace fs = std::filesystem;
namespace {

/// A name for people as a name for a file: short enough for any file system, with a number behind it too.
std::string fileNameOf(const std::string& name) {
  constexpr size_t kLongest = 100;
  const auto continuesCharacter = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; };
  size_t length = std::min(kLongest, name.size());
  while (length < name.size() && length > 0 && continuesCharacter(name[length])) --length;
  std::string file;
  for (const char c : name.substr(0, length)) file += c == '/' || static_cast<unsigned char>(c) < 32 ? '-' : c;
  while (!file.empty() && (file.front() == '.' || file.front() == ' ')) file.erase(file.begin());
  return file.empty() ? "Untitled" : file;
}

/// Also by a link that leads nowhere.
bool isTaken(const fs::path& file) {
  std::error_code ignored;
  return fs::exists(fs::symlink_status(file, ignored));
}

}  // namespace

PresetStore::PresetStore(fs::path folder) : folder_(std::move(folder)) {
  refresh();
}

void PresetStore::refresh() {
  names_.clear();
  std::error_code error;
  for (fs::directory_iterator it(folder_, error), end; !error && it != end; it.increment(error))
    if (it->path().extension() == ".json") names_.push_back(it->path().stem().string());
  std::sort(names_.begin(), names_.end());
}

void PresetStore::makeFolder(const fs::path& folder) const {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw InputError(folder.string() + ": the folder for presets could not be made: " + error.message());
}

Fabric PresetStore::load(const std::string& name) const {
  return readFabric(fileOf(name).string());
}

std::string PresetStore::keep(const Fabric& fabric) {
  const std::string name = fileNameOf(fabric.name);
  write(fabric, name);
  return name;
}

void PresetStore::write(const Fabric& fabric, const std::string& name) {
  makeFolder(folder_);
  writeFabric(fabric, fileOf(name).string());
  refresh();
}

std::string PresetStore::keepBeside(Fabric fabric) {
  const std::string wish = fileNameOf(fabric.name);
  std::string name = wish;
  for (int i = 2; isTaken(fileOf(name)); ++i) fabric.name = name = fmt::format("{} {}", wish, i);
  write(fabric, name);
  return name;
}

std::string PresetStore::rename(const std::string& name, const std::string& to) {
  Fabric fabric = load(name);
  if (fileNameOf(to) == name) return name;
  fabric.name = to;
  std::string renamed = keepBeside(std::move(fabric));
  std::error_code error;
  fs::remove(fileOf(name), error);
  if (error) throw InputError(fileOf(name).string() + ": could not be removed: " + error.message());
  refresh();
  return renamed;
}

void PresetStore::remove(const std::string& name) {
  makeFolder(binOf(name).parent_path());
  std::error_code error;
  fs::rename(fileOf(name), binOf(name), error);
  if (error) throw InputError(fileOf(name).string() + ": could not be removed: " + error.message());
  refresh();
}

void PresetStore::putBack(const std::string& name) {
  if (isTaken(fileOf(name))) throw InputError("another preset has that name now: " + name);
  std::error_code error;
  fs::rename(binOf(name), fileOf(name), error);
  if (error) throw InputError(binOf(name).string() + ": could not be put back: " + error.message());
  refresh();
}

Fabric dressed(const Fabric& scene, const Fabric& cloth) {
  Fabric fabric = cloth;
  fabric.drape = scene.drape;
  fabric.light = scene.light;
  fabric.camera = scene.camera;
  fabric.render = scene.render;
  return fabric;
}

}  // namespace loomlight
