#pragma once

#include "core/base/task.h"
#include "render/trace/camera_rays.h"
#include "render/film/film.h"
#include "render/trace/scene.h"

namespace loomlight {

/// What a path or a pass cost.
struct TraceCounts {
  uint64_t paths = 0;
  uint64_t events = 0;  ///< scattering events
  uint64_t rays = 0;    ///< flights and shadow rays
  uint64_t steps = 0;   ///< voxels with content that they crossed
  TraceCounts& operator+=(const TraceCounts& other);
};

/// Sample `index` of the pixel: a pure function of (scene, camera, seed, x, y, index). Adds its cost to `counts`.
PathSample tracePath(const Scene& scene, const CameraRays& camera, int x, int y, uint32_t index, TraceCounts& counts);

struct PassResult {
  bool complete = true;  ///< false when stopped: some pixels lack some samples
  TraceCounts counts;
};

/// Brings every pixel of the film to `samples` samples, numbered from `firstSample` on: traces those that are missing, so
/// that a stopped or resumed picture goes on where each of its pixels is. Checks stop per path.
PassResult renderUpTo(uint32_t samples, const Scene& scene, const CameraRays& camera, Film& film, const Task& task,
                      uint32_t firstSample = 0);

}  // namespace loomlight
