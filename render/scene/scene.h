#pragma once

#include <array>
#include <functional>
#include <memory>
#include <vector>

#include "core/fabric/model/fabric.h"
#include "core/shell/shell.h"
#include "core/volume/traverse/cloth_volume.h"
#include "render/light/lighting.h"
#include "render/optics/bcsdf.h"
#include "render/scene/camera_rays.h"

namespace loomlight {

class ShellEntry;

/// What light does at the fibres of one material. Colour is apart: Scene::absorption_per_mm.
struct Material {
  std::shared_ptr<const FibreBcsdf> bcsdf;
};

/// What a yarn's components need beside their statistics, per Fabric::yarns and system.
struct YarnOptics {
  int material = 0;          ///< index into Scene::materials
  bool packed = false;       ///< FibreLayout::packed: its fibres do not overlap
  float fibreRadius_mm = 0;  ///< of the geometry; differs between warp and weft by less than a rounding of fibre counts
};

/// The second material of a blended yarn (Yarn::blendFibre), and how many of its fibres are of it.
struct YarnBlend {
  int material = 0;  ///< index into Scene::materials
  float share = 0;   ///< by number, 0..1; 0: no blend
};

/// How paths are sampled: the noise and the cost of a picture, never what it converges to. All that is on has earned
/// its place in `bench converge`.
struct PathSampling {
  bool stratified = true;     ///< camera, first events and first lamps are spread evenly over a pixel's samples
  bool roulette = true;       ///< paths of little worth end by chance
  bool lampsByChance = true;  ///< where a fibre would send on little of a lamp, it is seldom looked for
  bool lamps = true;          ///< lamps of some size are looked for, by importance; else paths find them by chance
};

/// Everything a path needs, immutable and shared: an edit makes a new Scene from what did not change. `materials` has
/// one entry per Fabric::fibres.
struct Scene {
  std::shared_ptr<const Fabric> fabric;
  std::shared_ptr<const ClothVolume> volume;
  std::shared_ptr<const Shell> shell;
  std::shared_ptr<const ShellEntry> entry;
  std::shared_ptr<const Lighting> lighting;
  std::vector<Material> materials;
  std::vector<Rgb> absorption_per_mm;  ///< inside the fibres of each material
  /// What roulette takes for it: the same, unless paths must end where those of another colouring do. Whatever it is,
  /// the picture converges to the same.
  std::vector<Rgb> roulette_per_mm;
  PathSampling sampling;
  std::array<std::vector<YarnOptics>, 2> yarns;  ///< [system][index into Fabric::yarns]
  std::vector<YarnBlend> blends;                 ///< [index into Fabric::yarns]
  struct Seconds {
    double geometry = 0, voxelise = 0, accelerate = 0;
  } seconds;  ///< what making it took; 0 for what was reused
};

/// What somebody who waits for a scene wants to see of it before it is there.
struct FirstScenes {
  double aspect = 1;  ///< width over height of the picture
  /// Asked where a draft could be shown, having so much of all bricks. Both are called from the thread that builds.
  std::function<bool(double fraction)> wanted;
  /// A scene as it will be, but for fibres that overlap, or bricks out of sight, or of sight in another phase.
  std::function<void(std::shared_ptr<const Scene> draft)> show;
};

/// Builds the scene of a fabric, reusing from `previous` (may be null) every part that the edit did not touch. Returns
/// null when stopped; throws InputError for files that cannot be used. What `first` (may be null) is shown in between
/// changes nothing; none of it may be a `previous`.
std::shared_ptr<const Scene> makeScene(std::shared_ptr<const Fabric> fabric, const Task& task,
                                       const Scene* previous = nullptr, const FirstScenes* first = nullptr);

}  // namespace loomlight
