#include "app/editor/presets/preset_folder.h"

#include <fmt/core.h>

#include <algorithm>

#include "app/export/file_name.h"
#include "core/base/error.h"
#include "core/fabric/json/fabric_json.h"
#include "ui/words/error_words.h"

namespace loomlight {
namespace fs = std::filesystem;
PresetFolder::PresetFolder(fs::path folder) : folder_(std::move(folder)) {
  refresh();
}

void PresetFolder::refresh() {
  names_.clear();
  std::error_code error;
  for (fs::directory_iterator it(folder_, error), end; !error && it != end; it.increment(error))
    if (it->path().extension() == ".json") names_.push_back(it->path().stem().string());
  std::sort(names_.begin(), names_.end());
}

PresetFolder::Stamp PresetFolder::stampOf(const std::string& name) const {
  std::error_code error;
  Stamp stamp;
  const auto time = fs::last_write_time(fileOf(name), error);
  if (!error) stamp.time = time;
  const uintmax_t bytes = fs::file_size(fileOf(name), error);
  if (!error) stamp.bytes = bytes;
  return stamp;
}

void PresetFolder::makeFolder(const fs::path& folder) const {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw InputError(fmt::format(words::errors::presetFolderNotMade, folder.string(), error.message()));
}

Fabric PresetFolder::load(const std::string& name) const {
  return readFabric(fileOf(name).string());
}

void PresetFolder::write(const Fabric& fabric, const std::string& name) {
  makeFolder(folder_);
  writeFabric(fabric, fileOf(name).string());
  refresh();
}

std::string PresetFolder::keep(Fabric fabric) {
  const std::string wish = fileNameOf(fabric.name);
  std::string name = wish;
  for (int i = 2; isTaken(fileOf(name)); ++i) fabric.name = name = fmt::format("{} {}", wish, i);
  write(fabric, name);
  return name;
}

std::string PresetFolder::rename(const std::string& name, const std::string& to) {
  Fabric fabric = load(name);
  if (to == name || fileNameOf(to) == name) return name;
  fabric.name = to;
  std::string renamed = keep(std::move(fabric));
  std::error_code error;
  fs::remove(fileOf(name), error);
  if (error) throw InputError(fmt::format(words::errors::notRemoved, fileOf(name).string(), error.message()));
  refresh();
  return renamed;
}

PresetFolder::Removed PresetFolder::remove(const std::string& name) {
  const fs::path bin = folder_ / "removed";
  makeFolder(bin);
  const fs::path kept = freeFile(bin / (name + ".json"));
  std::error_code error;
  fs::rename(fileOf(name), kept, error);
  if (error) throw InputError(fmt::format(words::errors::notRemoved, fileOf(name).string(), error.message()));
  refresh();
  return {name, kept};
}

void PresetFolder::putBack(const Removed& removed) {
  if (isTaken(fileOf(removed.name))) throw InputError(fmt::format(words::errors::nameIsTaken, removed.name));
  std::error_code error;
  fs::rename(removed.file, fileOf(removed.name), error);
  if (error) throw InputError(fmt::format(words::errors::notPutBack, removed.file.string(), error.message()));
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
