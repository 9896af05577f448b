#pragma once

#include <imgui.h>

#include <span>
#include <string>
#include <vector>

#include "core/fabric/model/fabric.h"
#include "core/fabric/model/yarn_count.h"

namespace loomlight {

/// How the yarns of a fabric are shown, one after the other: each in the colour that the cloth reaches where it lies on
/// top, and by the name that it goes by.
struct ShownYarns {
  std::vector<ImVec4> colours;  ///< for the display
  std::vector<std::string> names;
};
/// `reached`: linear, one for each yarn; `forNames`: that they are called by.
ShownYarns shownYarns(const Fabric& fabric, std::span<const Rgb> reached, std::span<const Rgb> forNames,
                      CountSystem counts);

std::vector<ImVec4> displayColours(std::span<const Rgb> linear);

}  // namespace loomlight
