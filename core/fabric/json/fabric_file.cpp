#include <filesystem>
#include <system_error>

#include "core/base/file.h"
#include "core/fabric/json/fabric_json.h"
#include "core/fabric/model/validate.h"

namespace loomlight {
namespace {

namespace fs = std::filesystem;

/// A name in a fabric file, as seen from the working directory.
std::string resolved(const std::string& name, const fs::path& folder) {
  if (name.empty() || fs::path(name).is_absolute()) return name;
  return (folder / name).lexically_normal().string();
}

/// The reverse, for what lies in the folder of the fabric file or below; names of other files stay as they are, made
/// absolute, so that they still mean the same file.
std::string relativeTo(const std::string& name, const fs::path& folder) {
  if (name.empty()) return name;
  std::error_code error;
  const fs::path whole = fs::absolute(name, error).lexically_normal();
  const fs::path base = fs::absolute(folder.empty() ? "." : folder, error).lexically_normal();
  const fs::path relative = whole.lexically_relative(base);
  return relative.empty() || *relative.begin() == ".." ? whole.string() : relative.string();
}

}  // namespace

Fabric workingNames(Fabric fabric, const std::string& file) {
  const fs::path folder = fs::path(file).parent_path();
  fabric.drape.file = resolved(fabric.drape.file, folder);
  fabric.light.file = resolved(fabric.light.file, folder);
  fabric.light.illuminantFile = resolved(fabric.light.illuminantFile, folder);
  return fabric;
}

Fabric localNames(Fabric fabric, const std::string& file) {
  const fs::path folder = fs::path(file).parent_path();
  fabric.drape.file = relativeTo(fabric.drape.file, folder);
  fabric.light.file = relativeTo(fabric.light.file, folder);
  fabric.light.illuminantFile = relativeTo(fabric.light.illuminantFile, folder);
  return fabric;
}

FabricReading openFabric(const std::string& file) {
  FabricReading reading = fabricReadingOf(readFile(file, kMaxFabricBytes), file);
  reading.fabric = workingNames(std::move(reading.fabric), file);
  return reading;
}

Fabric readFabric(const std::string& file) {
  return openFabric(file).fabric;
}

bool writeFabric(const Fabric& fabric, const std::string& file, const std::stop_token& stop) {
  validate(fabric, file);
  return writeFileAtomically(file, fabricToJson(localNames(fabric, file)), stop);
}

}  // namespace loomlight
