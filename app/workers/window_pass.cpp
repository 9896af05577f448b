#include "app/workers/window_pass.h"

#include <algorithm>

#include "core/base/parallel.h"

namespace loomlight {

PassResult traceWindow(uint32_t samples, const Scene& scene, const Medium& medium, const CameraRays& camera, Film& film,
                       const PixelRect& window, const Task& task) {
  constexpr int kTile = 16;
  const int columns = (window.width + kTile - 1) / kTile, rows = (window.height + kTile - 1) / kTile;
  std::vector<TraceCounts> tileCounts(static_cast<size_t>(columns) * rows);
  parallelFor(tileCounts.size(), task.threads, [&](size_t tile) {
    const int left = window.x + static_cast<int>(tile % columns) * kTile;
    const int top = window.y + static_cast<int>(tile / columns) * kTile;
    const int right = std::min(left + kTile, window.x + window.width);
    const int bottom = std::min(top + kTile, window.y + window.height);
    for (int y = top; y < bottom; ++y)
      for (int x = left; x < right; ++x)
        for (uint32_t i = film.samples(x, y); i < samples; ++i) {
          if (task.stopped()) return;
          film.add(x, y, i, tracePath(scene, medium, camera, x, y, i, tileCounts[tile]));
        }
  });
  PassResult result;
  for (const TraceCounts& counts : tileCounts) result.counts += counts;
  result.complete = !task.stopped();
  return result;
}

uint32_t fewestSamples(const Film& film, const PixelRect& window) {
  uint32_t fewest = Film::maxSamples;
  for (int y = window.y; y < window.y + window.height; ++y)
    for (int x = window.x; x < window.x + window.width; ++x) fewest = std::min(fewest, film.samples(x, y));
  return fewest;
}

}  // namespace loomlight
