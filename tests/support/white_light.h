#pragma once

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "core/fabric/model/fabric.h"
#include "render/film/image.h"

namespace loomlight::test {

/// Radiance 1 from everywhere, as a picture of surroundings. Paths look for its light, as they do for that of any
/// picture, and find it by themselves too: both ways, weighted against each other, have to add up to white. The light
/// that is called furnace is never looked for, and cannot tell whether what blocks a look is what blocks a path.
class WhiteLight {
 public:
  WhiteLight() {
    Image white;
    white.width = 16;
    white.height = 8;
    for (const char* name : {"R", "G", "B"}) std::fill_n(white.add(name).begin(), 16 * 8, 1.0f);
    writeExr(file_, white);
  }
  ~WhiteLight() {
    std::error_code ignored;
    std::filesystem::remove(file_, ignored);
  }
  WhiteLight(const WhiteLight&) = delete;
  WhiteLight& operator=(const WhiteLight&) = delete;

  void shineOn(Fabric& fabric) const {
    fabric.light.kind = LightKind::environment;
    fabric.light.file = file_;
  }

 private:
  std::string file_ =
      (std::filesystem::temp_directory_path() / ("loomlight-white-" + std::to_string(getpid()) + ".exr")).string();
};

}  // namespace loomlight::test
