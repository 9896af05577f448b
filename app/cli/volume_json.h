#pragma once

#include <nlohmann/json.hpp>

#include "core/volume/traverse/cloth_volume.h"

namespace loomlight {

/// The counts of a volume under the names that every command gives them.
inline void addVolume(nlohmann::ordered_json& json, const VolumeCounts& volume) {
  json["bricks"] = volume.bricks;
  json["voxels"] = volume.voxels;
  json["components"] = volume.components;
  json["volume_bytes"] = volume.bytes;
  json["segments"] = volume.segments;
}

}  // namespace loomlight
