#include "app/cli/commands/render_stats.h"

#include <sys/resource.h>

#include <nlohmann/json.hpp>

#include "core/base/file.h"
#include "core/fabric/json/json_text.h"
#include "core/fabric/model/choice_names.h"

namespace loomlight {

size_t peakMemory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<size_t>(usage.ru_maxrss) * 1024;
}

void writeStats(const std::string& file, const RenderStats& stats) {
  nlohmann::ordered_json json;
  json["method"] = choiceName(stats.method);
  json["width"] = stats.width;
  json["height"] = stats.height;
  json["samples_per_pixel"] = stats.samplesPerPixel;
  json["threads"] = stats.threads;
  json["seconds"] = {{"geometry", stats.scene_s.geometry},
                     {"voxelise", stats.scene_s.voxelise},
                     {"accelerate", stats.scene_s.accelerate + stats.medium.fibreSeconds},
                     {"bvdf", stats.medium.bvdfSeconds},
                     {"render", stats.render_s},
                     {"total", stats.total_s}};
  json["counts"] = {{"segments", stats.medium.segments > 0 ? stats.medium.segments : stats.volume.segments},
                    {"bricks", stats.volume.bricks},
                    {"voxels", stats.volume.voxels},
                    {"components", stats.volume.components},
                    {"paths", stats.trace.paths},
                    {"events", stats.trace.events},
                    {"rays", stats.trace.rays},
                    {"steps", stats.trace.steps}};
  // For a volume strands are made brick by brick and not kept, and no accelerator goes over them.
  json["bytes"] = {{"geometry", stats.medium.geometryBytes},
                   {"accelerator", stats.medium.acceleratorBytes},
                   {"volume", stats.volume.bytes},
                   {"bvdf", stats.medium.bvdfBytes},
                   {"peak_rss", peakMemory()}};
  writeFileAtomically(file, jsonText(json, 2) + '\n');
}

}  // namespace loomlight
