#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "core/fabric/model/changes.h"
#include "core/fabric/model/fabric.h"
#include "render/light/lighting.h"
#include "render/scene/camera_rays.h"
#include "render/scene/colouring.h"
#include "render/scene/trace_data.h"

namespace loomlight {

/// How paths are sampled: the noise and the cost of a picture, never what it converges to but for where paths end. All
/// that is on has earned its place in `bench converge`.
struct PathSampling {
  uint64_t seed = 0;          ///< of bits that are mixed; another gives another pattern of noise
  uint32_t maxEvents = 1;     ///< fibres that send light on along a path, at most: one that meets another ends there
  bool stratified = true;     ///< camera, first events and first lamps are spread evenly over a pixel's samples
  bool roulette = true;       ///< paths of little worth end by chance
  bool lampsByChance = true;  ///< where a fibre would send on little of a lamp, it is seldom looked for
  bool lamps = true;          ///< lamps of some size are looked for, by importance; else paths find them by chance

  /// Paths that find all their light by themselves, and end for no other reason than their length.
  static PathSampling plain(uint32_t maxEvents) {
    return {.maxEvents = maxEvents, .stratified = false, .roulette = false, .lampsByChance = false, .lamps = false};
  }
};

/// Everything a path needs, immutable and shared: an edit makes a new Scene from what did not change.
struct Scene {
  std::shared_ptr<const Fabric> fabric;
  std::shared_ptr<const TraceData> cloth;
  std::shared_ptr<const Lighting> lighting;
  Colouring colouring;
  /// The absorptions by which Russian roulette ends paths: the least that its colouring has, unless paths must end
  /// where those of another colouring end. The mean of the picture does not depend on them.
  std::vector<Rgb> roulette_per_mm;
  PathSampling sampling;
  struct Seconds {
    double geometry = 0, voxelise = 0, accelerate = 0;
  } seconds;  ///< what making it took; 0 for what was reused
};

/// What somebody who waits for a scene wants to see of it before it is there.
struct ScenePreviews {
  double aspect = 1;  ///< width over height of the picture
  /// Whether a preview is wanted now that this fraction of all bricks is made. Both are called by the building thread.
  std::function<bool(double fraction)> wanted;
  /// Brings a scene in which fibres may overlap, bricks out of sight are missing, and others show another phase.
  std::function<void(std::shared_ptr<const Scene> preview)> show;
};

/// A scene that is there already, null if there is none, and what the edit since then has put out of date in it.
struct SceneBase {
  const Scene* scene = nullptr;
  Changes edit;
  Tiling tiling = {};  ///< of a cloth that is made anew

  /// Whether what these stages make serves again.
  bool keeps(Stages stages) const { return scene && !edit.stages.any(stages); }
};

/// Builds the scene of the fabric that is asked for, reusing from `base` every part that the edit did not touch.
/// Returns null when stopped; throws InputError for files that cannot be used. What `first` (may be null) is shown in
/// between changes nothing; none of it may be a base.
std::shared_ptr<const Scene> makeScene(std::shared_ptr<const Fabric> asked, const Task& task, const SceneBase& base,
                                       const ScenePreviews* first = nullptr);
/// Based on `previous` (may be null), which it is compared with.
std::shared_ptr<const Scene> makeScene(std::shared_ptr<const Fabric> fabric, const Task& task,
                                       const Scene* previous = nullptr, const ScenePreviews* first = nullptr);

}  // namespace loomlight
