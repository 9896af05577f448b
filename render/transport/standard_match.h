#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/task.h"
#include "core/fabric/yarn/cloth_part.h"
#include "render/colour/colour_difference.h"
#include "render/transport/colour_patch.h"

namespace loomlight {

/// What a cloth ought to reflect like where a part of it lies on top.
struct ClothStandard {
  ClothPart part;
  std::string partName;  ///< as people call the part
  std::string name;      ///< of what was measured
  Spectrum reflectance{};
};

/// A cloth beside a standard of it, by the CIE observer for 10 degrees, as the textile trade judges.
struct StandardMatch {
  std::string partName, standard;
  Rgb wanted{0}, shown{0};   ///< linear, in daylight
  Judgement daylight, bulb;  ///< under CIE D65 and A; metamerism is told from D65
};

/// Of the cloth of this patch, in the order of the standards; nullopt when stopped. Throws InputError for a part that
/// never lies on the face.
std::optional<std::vector<StandardMatch>> standardMatches(const ColourPatch& patch,
                                                          const std::vector<ClothStandard>& standards,
                                                          const Task& task);

}  // namespace loomlight
