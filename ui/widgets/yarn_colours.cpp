#include "ui/widgets/yarn_colours.h"

#include "core/fabric/yarn/yarn_name.h"
#include "ui/widgets/fields.h"

namespace loomlight {

ShownYarns shownYarns(const Fabric& fabric, std::span<const Rgb> reached, std::span<const Rgb> forNames,
                      CountSystem counts) {
  ShownYarns shown{displayColours(reached), {}};
  shown.names.reserve(reached.size());
  for (size_t i = 0; i < reached.size(); ++i)
    shown.names.push_back(yarnName(fabric, static_cast<int>(i), forNames[i], counts));
  return shown;
}

std::vector<ImVec4> displayColours(std::span<const Rgb> linear) {
  std::vector<ImVec4> colours;
  colours.reserve(linear.size());
  for (const Rgb& colour : linear) colours.push_back(toDisplayColour(colour));
  return colours;
}

}  // namespace loomlight
