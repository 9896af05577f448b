#pragma once

#include "core/base/task.h"
#include "render/trace/camera_rays.h"
#include "render/film/film.h"
#include "render/trace/scene.h"

namespace loomlight {

/// Sample `index` of the pixel: a pure function of (scene, camera, seed, x, y, index).
PathSample tracePath(const Scene& scene, const CameraRays& camera, int x, int y, uint32_t index);

/// Adds samples [first, first + count) of every pixel in the film. Checks stop per path; a stopped pass leaves some
/// pixels without some samples and returns false. `stride` > 1 traces only every stride-th pixel in x and y.
bool renderPass(const Scene& scene, const CameraRays& camera, uint32_t first, uint32_t count, Film& film,
                const Task& task);

}  // namespace loomlight
