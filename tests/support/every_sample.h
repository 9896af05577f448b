#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "render/film/pixel_rect.h"
#include "render/scene/camera_rays.h"
#include "render/transport/path_tracer.h"

namespace loomlight::test {

/// Traces the first `samples` samples of every pixel of a window, many at a time as pictures are traced, and calls
/// visit(x, y, sample) with each: row by row, those of a pixel one after the other. The cost is added to `counts`.
template <class Visit>
void forEachSample(const Scene& scene, const Medium& medium, const CameraRays& camera, const PixelRect& window,
                   uint32_t samples, TraceCounts& counts, const Visit& visit) {
  PathTracer tracer(scene, medium, camera, PathIntegrator::kBatch);
  std::vector<PixelSample> batch;
  const auto traceBatch = [&] {
    ASSERT_TRUE(tracer.trace(batch, counts));
    for (size_t i = 0; i < batch.size(); ++i) visit(batch[i].x, batch[i].y, tracer.sample(i));
    batch.clear();
  };
  for (int y = window.y; y < window.y + window.height; ++y)
    for (int x = window.x; x < window.x + window.width; ++x)
      for (uint32_t i = 0; i < samples; ++i) {
        batch.push_back({x, y, i, nullptr});
        if (batch.size() == PathIntegrator::kBatch) traceBatch();
      }
  traceBatch();
}

/// The same of a picture of that width and height.
template <class Visit>
void forEachSample(const Scene& scene, const Medium& medium, int side, uint32_t samples, const Visit& visit) {
  TraceCounts counts;
  forEachSample(scene, medium, CameraRays(scene.fabric->camera, side, side), {0, 0, side, side}, samples, counts,
                visit);
}

}  // namespace loomlight::test
