#pragma once

#include <memory>

#include "render/media/medium.h"

namespace loomlight {

/// The cloth as a statistical volume: virtual scattering events (section 8.1 of the report). Free flights are exact
/// exponentials through the summed extinction of every voxel; the component is chosen in proportion to its own
/// extinction, the tangent weighted by the sine, which is the law of the fibre that a random ray hits
/// (EventLaw::projected), or by density alone (EventLaw::report). h is uniform. Light leaves where it came in: a fibre
/// is a point here.
class VolumeMedium final : public Medium {
 public:
  VolumeMedium(std::shared_ptr<const TraceData> cloth, EventLaw law) : cloth_(std::move(cloth)), law_(law) {}
  /// With the event law that the scene asks for.
  explicit VolumeMedium(const std::shared_ptr<const TraceData>& cloth) : VolumeMedium(cloth, cloth->eventLaw) {}

  struct Memory {};  ///< of a path: none

  std::unique_ptr<MediumBatch> batch(size_t paths) const override;
  std::optional<Collision> collide(const ScenePoint& from, Memory&, glm::vec3 direction, Random& random,
                                   TraceCounts& counts) const;
  glm::vec3 exit(const Collision& met, glm::vec3, float) const { return met.place.world; }
  /// Nobody sees where across: evenly spread, from that of `met` on.
  size_t offsetsAcross(const Collision& met, const Memory&, std::span<float> offsets, Random&) const {
    return evenOffsets(met.offset, offsets);
  }
  /// Exact down to e^-4; below that 0 or e^-4, because what hardly gets through is not worth walking for.
  float transmittance(const ScenePoint& from, const Memory&, glm::vec3 direction, float distance, Random& random,
                      TraceCounts& counts) const {
    return transmittanceBeyond(0, from, direction, distance, random, counts);
  }
  /// The same, were the first `clear_mm` of the way empty.
  float transmittanceBeyond(float clear_mm, const ScenePoint& from, glm::vec3 direction, float distance, Random& random,
                            TraceCounts& counts) const;

 private:
  std::shared_ptr<const TraceData> cloth_;
  EventLaw law_;
};

}  // namespace loomlight
