#include "app/cli/inputs.h"

#include <fmt/format.h>

#include <filesystem>

#include "app/export/file_name.h"
#include "app/export/picture.h"
#include "app/export/weave_bitmap.h"
#include "core/base/error.h"
#include "core/fabric/json/fabric_json.h"

namespace loomlight {

FabricInput readInput(const std::string& file, WifSizeChoice sizes) {
  const std::string extension = lowerExtension(file);
  if (isFabricFile(file)) return {readFabric(file), {}};
  if (extension == ".exr") return {fabricOfPicture(file), {}};
  if (isWeavingFile(file)) {
    WifImport import = readWifFabric(file, Fabric{}, sizes);
    std::vector<std::string> warnings;
    for (const WifWarning& warning : import.warnings)
      warnings.push_back(fmt::format("{}: {}", file, inOneLine(warning)));
    if (sizes == WifSizeChoice::keep)
      for (const WifWarning& warning : otherWifSizes(import.fabric))
        warnings.push_back(fmt::format("{}: {}", file, inOneLine(warning)));
    return {std::move(import.fabric), std::move(warnings)};
  }
  if (extension == ".png") {
    Fabric fabric;
    fabric.name = std::filesystem::path(file).stem().string();
    fabric.weave = readWeaveBitmap(file);
    return {std::move(fabric), {}};
  }
  throw InputError(fmt::format(
      "{}: expected a fabric (.json, .loomlight), a draft (.wif), a weave bitmap (.png) or a picture rendered by "
      "Loomlight (.exr)",
      file));
}

Fabric fabricFromFile(const std::string& file, WifSizeChoice sizes) {
  FabricInput input = readInput(file, sizes);
  for (const std::string& warning : input.warnings) fmt::print(stderr, "{}\n", warning);
  return std::move(input.fabric);
}

}  // namespace loomlight
