#pragma once

#include <memory>
#include <optional>

#include "core/base/task.h"
#include "core/fabric/model/fabric.h"
#include "render/media/medium.h"
#include "render/scene/scene.h"
#include "render/transport/path_length_tally.h"

namespace loomlight {

/// A colourPatch() with its medium, ready for tallyPathLengths().
struct ColourPatch {
  std::shared_ptr<const Scene> scene;
  std::unique_ptr<const Medium> medium;
};
/// The patch of a fabric; nullopt when stopped. `shared` (may be null): a scene, or none, whose parts it may share, and
/// that its own takes the place of. Throws InputError for files that cannot be used.
std::optional<ColourPatch> makeColourPatch(const Fabric& fabric, const Task& task,
                                           std::shared_ptr<const Scene>* shared = nullptr);

}  // namespace loomlight
