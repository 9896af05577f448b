#pragma once

#include <cstddef>
#include <memory>

#include "core/base/task.h"
#include "render/media/medium.h"
#include "render/scene/fibre_extent.h"

namespace loomlight {

/// What a medium took to make, beyond the scene; all 0 where it only looks at the scene's volume.
struct MediumCost {
  size_t segments = 0;  ///< of fibres, as they are traced
  size_t geometryBytes = 0;
  size_t acceleratorBytes = 0;
  double fibreSeconds = 0;
  size_t bvdfBytes = 0;  ///< of local visibility, baked or out of the user's cache
  double bvdfSeconds = 0;
};

/// What explicit fibres may take where nobody says otherwise: three quarters of the machine's memory.
double defaultMemoryLimit_bytes();

/// The medium that the scene's RenderSettings ask for (method, estimator). Fibres throw InputError where they would
/// take more than their limit. Null when stopped. The scene must outlive the medium.
std::unique_ptr<const Medium> makeMedium(const Scene& scene, const FibreOptions& options, const Task& task,
                                         MediumCost* cost = nullptr);

/// Whether a medium made for one scene is right for the other too: all that differs is light, camera, colour, or
/// settings that no medium reads. Making fibres takes seconds, so moving the camera must not.
bool sameMedium(const Scene& a, const Scene& b);

}  // namespace loomlight
