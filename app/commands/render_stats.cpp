#include "app/commands/render_stats.h"

#include <sys/resource.h>

#include <nlohmann/json.hpp>

#include "core/base/file.h"

namespace loomlight {

size_t peakMemory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<size_t>(usage.ru_maxrss) * 1024;
}

void writeStats(const std::string& file, const RenderStats& stats) {
  nlohmann::ordered_json json;
  json["method"] = "volume";
  json["width"] = stats.width;
  json["height"] = stats.height;
  json["samples_per_pixel"] = stats.samplesPerPixel;
  json["threads"] = stats.threads;
  json["seconds"] = {{"geometry", stats.scene_s.geometry},
                     {"voxelise", stats.scene_s.voxelise},
                     {"accelerate", stats.scene_s.accelerate},
                     {"bvdf", 0.0},
                     {"render", stats.render_s},
                     {"total", stats.total_s}};
  json["counts"] = {{"segments", stats.volume.segments}, {"bricks", stats.volume.bricks},
                    {"voxels", stats.volume.voxels},     {"components", stats.volume.components},
                    {"paths", stats.trace.paths},        {"events", stats.trace.events},
                    {"rays", stats.trace.rays},          {"steps", stats.trace.steps}};
  // Strands are made brick by brick and not kept; the volume method has no acceleration structure over fibres.
  json["bytes"] = {
      {"geometry", 0}, {"accelerator", 0}, {"volume", stats.volume.bytes}, {"bvdf", 0}, {"peak_rss", peakMemory()}};
  writeFileAtomically(file, json.dump(2) + '\n');
}

}  // namespace loomlight
