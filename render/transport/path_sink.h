#pragma once

#include <cstdint>
#include <span>

#include "render/media/medium.h"
#include "render/transport/path_light.h"

namespace loomlight {

/// Why a path goes no farther.
enum class PathEnd {
  left,      ///< it met nothing more
  deepest,   ///< it has as many events as it may
  roulette,  ///< chance ended it, having little light left to bring
  stopped,   ///< its sink has heard enough
};

/// Hears what befalls a path, in order: pictures, records, tallies of lengths and transcripts are made of it.
class PathSink {
 public:
  virtual ~PathSink() = default;

  /// The path has met its `event`th fibre, counted from 1. Returning false ends it there.
  virtual bool meets(const Collision& /*at*/, uint32_t /*event*/) { return true; }
  /// Light comes onto the path, `events` fibres from the eye, after these lengths inside the fibres of each material.
  virtual void gathers(const PathLight& /*light*/, std::span<const float> /*lengths_mm*/, uint32_t /*events*/) {}
  /// The path goes on from the fibre into a direction of the world. weight: 1, or more where Russian roulette let it
  /// live.
  virtual void scatters(const FibreBcsdf::Sample& /*by*/, glm::vec3 /*direction*/, float /*weight*/) {}
  virtual void ends(PathEnd /*why*/) {}
};

}  // namespace loomlight
