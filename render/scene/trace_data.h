#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/fabric/model/fabric.h"
#include "core/shell/shell.h"
#include "core/volume/traverse/cloth_volume.h"
#include "render/optics/bcsdf.h"

namespace loomlight {

class FibreBricks;
class ShellEntry;
struct DrapeSurface;

/// What light does at the fibres of one material. Colour is apart: Scene::colouring.
struct Material {
  std::shared_ptr<const FibreBcsdf> bcsdf;
  float refractiveIndex = 1;
};

/// What light meets in a yarn beside the statistics of its components, per Fabric::yarns and system.
struct YarnOptics {
  int material = 0;          ///< index into TraceData::materials
  bool packed = false;       ///< FibreLayout::packed: light goes on where it leaves a fibre, not where it met it
  float fibreRadius_mm = 0;  ///< of an even yarn: uneven ones have more of them where they are thick
  int blendMaterial = 0;     ///< the second material of a blended yarn (Yarn::blendFibre)
  float shadeVariation = 0;  ///< of its threads (thread_shade.h), 0..1
  float blendShare = 0;      ///< how many of its fibres are of that one, by number, 0..1; 0: no blend
  float separation = 0;      ///< YarnModel::separation; of fibres that are not packed, 0
};

/// All of a scene that decides where light goes inside of the cloth, and nothing of what colour it has or where it
/// comes from. Flat and immutable; media share it, so that they outlive the scene that they were made for. Scenes that
/// differ in light, camera or colour alone share one (no Changes::medium()), so a medium serves every scene that has
/// the very TraceData it was made of.
struct TraceData {
  std::shared_ptr<const ClothVolume> volume;
  /// What the shell is laid on; null where it is flat. It stays until the drape itself is edited: a mesh file is not
  /// read again before.
  std::shared_ptr<const DrapeSurface> drape;
  std::shared_ptr<const Shell> shell;
  std::shared_ptr<const ShellEntry> entry;
  /// The fibres themselves, for eyes that come near. Null in a preview, which nobody looks at for long enough, and
  /// where they would take too much.
  std::shared_ptr<const FibreBricks> fibres;
  std::vector<Material> materials;               ///< [index into Fabric::fibres]
  std::array<std::vector<YarnOptics>, 2> yarns;  ///< [system][index into Fabric::yarns]
  /// Which medium RenderSettings ask for, and how it chooses the fibre of an event.
  Method method = Method::volume;
  Estimator estimator = Estimator::loomlight;
  EventLaw eventLaw = EventLaw::projected;
};

}  // namespace loomlight
