#include "render/transport/yarn_names.h"

#include <algorithm>

#include "core/fabric/yarn/yarn_name.h"
#include "render/scene/colouring.h"
#include "render/transport/reached_colours.h"

namespace loomlight {

std::optional<std::vector<std::string>> yarnNames(const Fabric& fabric, const Task& task, CountSystem system) {
  std::vector<Rgb> colours(fabric.yarns.size());  // nobody asks for those of yarns that have names
  if (std::any_of(fabric.yarns.begin(), fabric.yarns.end(), [](const Yarn& yarn) { return yarn.name.empty(); })) {
    const auto paths = tracePathsToYarns(fabric, kChipPaths, task);
    if (!paths) return std::nullopt;
    colours = coloursForNames(*paths, reachedColours(*paths, colouringOf(fabric)));
  }
  std::vector<std::string> names;
  names.reserve(colours.size());
  for (size_t i = 0; i < colours.size(); ++i)
    names.push_back(yarnName(fabric, static_cast<int>(i), colours[i], system));
  return names;
}

}  // namespace loomlight
