#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/option_values.h"
#include "core/fabric/weave/picture_weave.h"

namespace loomlight {

/// A picture that became a weave, and what its colours were.
struct WovenPicture {
  Weave weave;
  ReducedPicture picture;
};

/// A .png in as many colours as there are structures, 1..32; from dark to light each colour is woven as one of them.
/// `repeat`: ends and picks; its pixels where not given. Throws InputError naming the file, also where the picture has
/// fewer colours.
WovenPicture readWovenPicture(const std::string& file, const std::vector<Weave>& structures,
                              const std::optional<PictureSize>& repeat);

}  // namespace loomlight
