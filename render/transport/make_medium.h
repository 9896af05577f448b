#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "core/base/task.h"
#include "render/media/medium.h"
#include "render/scene/fibre_extent.h"
#include "render/scene/scene.h"

namespace loomlight {

/// What a medium took to make, beyond the scene; all 0 where it only looks at the scene's volume.
struct MediumCost {
  size_t segments = 0;  ///< in a tree of fibres; 0 of bricks, which are laid as rays come to them
  size_t geometryBytes = 0;
  size_t acceleratorBytes = 0;
  double fibreSeconds = 0;
  size_t bvdfBytes = 0;       ///< of local visibility, baked or out of the user's cache
  uint64_t bvdfChecksum = 0;  ///< of what is in it: processors of another kind bake another one
  double bvdfSeconds = 0;
};

/// What explicit fibres may take where nobody says otherwise: three quarters of the machine's memory.
double defaultMemoryLimit_bytes();

/// The medium that the scene's RenderSettings ask for (method, estimator). Fibres throw InputError where they would
/// take more than their limit. Null when stopped. It serves every scene that shares this one's TraceData: making fibres
/// takes seconds, so moving the camera must not.
std::unique_ptr<const Medium> makeMedium(const Scene& scene, const FibreOptions& options, const Task& task,
                                         MediumCost* cost = nullptr);
}  // namespace loomlight
