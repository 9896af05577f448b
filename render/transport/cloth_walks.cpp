#include "render/transport/cloth_walks.h"

#include <memory>

#include "core/base/memory.h"
#include "render/transport/make_medium.h"

namespace loomlight {

std::optional<PathLengthTally> walkThrough(const Fabric& fabric, const ClothPart& part, size_t count,
                                           const Task& task) {
  const auto scene = makeScene(std::make_shared<const Fabric>(colourPatch(fabric)), task);
  const auto medium = scene ? makeMedium(*scene, defaultMemoryLimit_bytes(), task) : nullptr;
  return medium ? tallyPathLengths(*scene, *medium, part, count, task) : std::nullopt;
}

}  // namespace loomlight
