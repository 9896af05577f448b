#include "ui/widgets/yarn_colours.h"

#include "core/fabric/yarn/yarn_reflectance.h"
#include "ui/widgets/fields.h"

namespace loomlight {

ImVec4 fibreColour(const Fibre& fibre) {
  return toDisplayColour(fibreReflectance(fibre));
}

std::vector<ImVec4> yarnColours(const Fabric& fabric) {
  std::vector<ImVec4> colours;
  colours.reserve(fabric.yarns.size());
  for (const Rgb& reflectance : yarnReflectances(fabric)) colours.push_back(toDisplayColour(reflectance));
  return colours;
}

}  // namespace loomlight
