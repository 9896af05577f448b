#include "render/transport/colour_patch.h"

#include "core/base/memory.h"
#include "render/transport/make_medium.h"

namespace loomlight {

std::optional<ColourPatch> makeColourPatch(const Fabric& fabric, const Task& task,
                                           std::shared_ptr<const Scene>* shared) {
  ColourPatch patch;
  patch.scene = makeScene(std::make_shared<const Fabric>(colourPatch(fabric)), task, shared ? shared->get() : nullptr);
  if (!patch.scene) return std::nullopt;
  if (shared) *shared = patch.scene;
  patch.medium = makeMedium(*patch.scene, defaultMemoryLimit_bytes(), task);
  return patch.medium ? std::optional(std::move(patch)) : std::nullopt;
}

}  // namespace loomlight
