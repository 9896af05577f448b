#pragma once

#include <memory>
#include <string>

#include "core/base/task.h"
#include "render/media/fibre_medium.h"
#include "render/scene/scene.h"

namespace loomlight {

/// The small flat piece of a fabric on which its BVDF is baked: all its fibres explicit, a few repeats of the weave, or
/// of a large figure its corner. Nothing in it depends on colour, optics, light, camera or drape.
class BvdfPatch {
 public:
  /// The fabric without what the BVDF does not depend on: of the yarns one of each geometry class, in that order, and
  /// the piece that is baked as a flat drape. Equal ones have equal tables.
  static Fabric reduced(const Fabric& fabric);

  /// Null when stopped; throws InputError where the piece has more fibres than memory holds.
  static std::unique_ptr<const BvdfPatch> build(const Fabric& fabric, const Task& task);

  const Scene& scene() const { return *scene_; }
  const FibreMedium& fibres() const { return *fibres_; }
  /// Whether a crossing has neighbours all around it.
  bool isInside(int end, int pick) const;

 private:
  BvdfPatch() = default;
  std::shared_ptr<const Scene> scene_;
  std::unique_ptr<const FibreMedium> fibres_;
};

}  // namespace loomlight
