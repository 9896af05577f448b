#pragma once

#include <cstddef>
#include <string>

#include "core/volume/cloth_volume.h"
#include "render/trace/medium.h"

namespace loomlight {

/// What a picture took: the content of `--stats`.
struct RenderStats {
  int width = 0, height = 0;
  int samplesPerPixel = 0;
  int threads = 0;
  struct Seconds {
    double geometry = 0, voxelise = 0, accelerate = 0, bvdf = 0, render = 0, total = 0;
  } seconds;
  VolumeCounts volume;
  TraceCounts trace;
};

/// Most memory that this process has held at any time, bytes.
size_t peakMemory();

/// Writes the figures as JSON. Throws InputError when the file cannot be written.
void writeStats(const std::string& file, const RenderStats& stats);

}  // namespace loomlight
