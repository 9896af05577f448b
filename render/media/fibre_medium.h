#pragma once

#include <cstddef>
#include <memory>

#include "core/base/task.h"
#include "render/media/medium.h"
#include "render/scene/fibre_extent.h"

namespace loomlight {

class FibreBvh;

/// The cloth fibre by fibre: every strand of the piece as Embree round curves, bent onto the drape; or of a flat piece
/// one repeat and copies of it. No statistics: it is the ground truth that the volume is measured against. The same
/// strands, lobes, lights and bookkeeping.
///
/// Where light sets out again is part of the claim. Of packed fibres (FibreLayout::packed), which do not overlap, it
/// leaves from the point where its mode comes out of the fibre. Of fibres laid at random, which do overlap (the
/// report's), it leaves from where it came in, because the way through would start it inside neighbours; that costs
/// dense yarns up to 4 % of their events. Either way the fibre it leaves is not met again within three radii, and
/// surfaces are met from outside only.
class FibreMedium final : public Medium {
 public:
  /// Throws InputError, saying how much it would take, where what planFibres() estimates is beyond the limit, and where
  /// that does. Null when stopped.
  static std::unique_ptr<const FibreMedium> build(std::shared_ptr<const TraceData> cloth, const FibreOptions& options,
                                                  const Task& task);
  ~FibreMedium() override;

  const FibreSize& size() const { return size_; }  ///< as it was estimated
  size_t segments() const;                         ///< that are laid
  size_t geometryBytes() const;
  size_t acceleratorBytes() const;  ///< as Embree reports its allocations

  /// The fibre that a path leaves.
  struct Memory {
    uint64_t fibre = 0;      ///< 0: none
    float clearance_mm = 0;  ///< within this distance it is not met again
  };

  std::unique_ptr<MediumPath> path() const override;
  std::optional<Collision> collide(const ScenePoint& from, Memory& memory, glm::vec3 direction, Random&,
                                   TraceCounts& counts) const;
  glm::vec3 exit(const Collision& met, glm::vec3 wi, int order) const;
  float transmittance(const ScenePoint& from, const Memory& memory, glm::vec3 direction, float distance, Random&,
                      TraceCounts& counts) const;

 private:
  FibreMedium(std::shared_ptr<const TraceData> cloth, const FibreSize& size, std::unique_ptr<const FibreBvh> bvh);

  std::shared_ptr<const TraceData> cloth_;
  FibreSize size_;
  std::unique_ptr<const FibreBvh> bvh_;
};

}  // namespace loomlight
