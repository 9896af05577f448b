#include "app/commands/inputs.h"

#include <fmt/format.h>

#include <filesystem>

#include "app/commands/weave_bitmap.h"
#include "app/workers/file_name.h"
#include "app/workers/picture.h"
#include "core/base/error.h"
#include "core/fabric/fabric_json.h"

namespace loomlight {

Fabric fabricFromFile(const std::string& file) {
  const std::string extension = lowerExtension(file);
  if (extension == ".json") return readFabric(file);
  if (extension == ".exr") return fabricOfPicture(file);
  if (extension == ".png") {
    Fabric fabric;
    fabric.name = std::filesystem::path(file).stem().string();
    fabric.weave = readWeaveBitmap(file);
    return fabric;
  }
  throw InputError(fmt::format(
      "{}: expected a fabric (.json), a weave bitmap (.png) or a picture rendered by Loomlight (.exr)", file));
}

}  // namespace loomlight
