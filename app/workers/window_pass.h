#pragma once

#include "app/workers/frame.h"
#include "render/trace/path_tracer.h"

namespace loomlight {

/// renderUpTo() for a part of the film: brings its pixels to `samples` samples, the same ones that they would have in
/// the whole picture. Checks stop per path; what has been traced stays.
PassResult traceWindow(uint32_t samples, const Scene& scene, const Medium& medium, const CameraRays& camera, Film& film,
                       const PixelRect& window, const Task& task);

/// Samples that every pixel of the window has at least.
uint32_t fewestSamples(const Film& film, const PixelRect& window);

}  // namespace loomlight
