#include "app/editor/preset_store.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/fabric/fabric_json.h"

namespace loomlight {
namespace fs = std::filesystem;
namespace {

/// A name for people as a name for a file.
std::string fileNameOf(const std::string& name) {
  constexpr size_t kLongest = 100;
  std::string file;
  for (const char c : name.substr(0, kLongest)) file += c == '/' || static_cast<unsigned char>(c) < 32 ? '-' : c;
  while (!file.empty() && (file.front() == '.' || file.front() == ' ')) file.erase(file.begin());
  return file.empty() ? "Untitled" : file;
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
  makeFolder(folder_);
  const std::string name = fileNameOf(fabric.name);
  writeFabric(fabric, fileOf(name).string());
  refresh();
  return name;
}

std::string PresetStore::keepBeside(Fabric fabric) {
  const std::string wish = fabric.name;
  for (int i = 2; fs::exists(fileOf(fileNameOf(fabric.name))); ++i) fabric.name = wish + " " + std::to_string(i);
  return keep(fabric);
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
  if (fs::exists(fileOf(name))) throw InputError("another preset has that name now: " + name);
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
