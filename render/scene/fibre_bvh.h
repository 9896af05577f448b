#pragma once

#include <cstddef>
#include <memory>
#include <optional>

#include "core/base/task.h"
#include "render/scene/fibre_extent.h"
#include "render/scene/fibre_hit.h"

namespace loomlight {

/// A ray into the fibres, which does not see the fibre that it leaves within a distance from its origin.
struct FibreRay {
  glm::vec3 origin, direction;  ///< direction: unit
  float length_mm = std::numeric_limits<float>::infinity();
  uint64_t ownFibre = 0;
  float clearance_mm = 0;
};

/// The strands of a cloth as Embree round curves, bent onto the drape, in world space. Where only one repeat is laid
/// its copies are instances, so that rays go on from one into the next, and fibres that reach into neighbours are met
/// there. Surfaces are met from outside only. Immutable, and safe to ask from many threads.
class FibreBvh {
 public:
  /// Null when stopped: cell by cell, and Embree asks between small parts of its tree.
  static std::unique_ptr<const FibreBvh> build(std::shared_ptr<const TraceData> cloth, const FibreSize& size,
                                               const Task& task);
  ~FibreBvh();

  std::optional<FibreHit> meet(const FibreRay& ray) const;
  bool isFree(const FibreRay& ray) const;

  size_t segments() const;
  size_t geometryBytes() const;
  size_t acceleratorBytes() const;  ///< as Embree reports its allocations

 private:
  struct Impl;
  explicit FibreBvh(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace loomlight
