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

Fabric PresetStore::load(const std::string& name) const {
  return readFabric((folder_ / (name + ".json")).string());
}

std::string PresetStore::keep(const Fabric& fabric) {
  std::error_code error;
  fs::create_directories(folder_, error);
  if (error) throw InputError(folder_.string() + ": the folder for presets could not be made: " + error.message());
  const std::string name = fileNameOf(fabric.name);
  writeFabric(fabric, (folder_ / (name + ".json")).string());
  refresh();
  return name;
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
