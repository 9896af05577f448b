#pragma once

#include <cstddef>
#include <string>

#include "render/scene/scene.h"
#include "render/transport/make_medium.h"

namespace loomlight {

/// What a picture took: the content of `--stats`.
struct RenderStats {
  Method method = Method::volume;
  int width = 0, height = 0;
  int samplesPerPixel = 0;
  int threads = 0;
  Scene::Seconds scene_s;
  double render_s = 0;
  double total_s = 0;
  VolumeCounts volume;
  MediumCost medium;
  TraceCounts trace;
};

/// Most memory that this process has held at any time, bytes.
size_t peakMemory();

/// Writes the figures as JSON. Throws InputError when the file cannot be written.
void writeStats(const std::string& file, const RenderStats& stats);

}  // namespace loomlight
