#pragma once

#include <memory>

#include "render/bvdf/bvdf_set.h"
#include "render/media/volume_medium.h"

namespace loomlight {

/// The volume as the report has it, to the letter, for comparison: components are chosen by density alone (Eq. 12),
/// their tangents are not weighted, and direct light at the first fibre of a path is seen with the probability
/// (1 - p(wi, wo)) of the BVDF within the cell around it, times the volume's transmittance from the cell's far side on
/// (section 8.2). All else is the plain volume. It does not keep the furnace: light that comes straight is counted by
/// one law, light that goes on by another.
class ReportMedium final : public Medium {
 public:
  ReportMedium(std::shared_ptr<const TraceData> cloth, std::shared_ptr<const BvdfSet> bvdf);

  /// The last fibre of a path, and how the path came to it.
  struct Memory {
    int events = 0;  ///< fibres met so far
    int yarn = 0;    ///< index into Fabric::yarns
    glm::vec3 tangent{1, 0, 0}, incoming{0, 0, -1};
  };

  std::unique_ptr<MediumBatch> batch(size_t paths) const override;
  bool seesDirectLightApart() const override { return true; }
  std::optional<Collision> collide(const ScenePoint& from, Memory& memory, glm::vec3 direction, Random& random,
                                   TraceCounts& counts) const;
  glm::vec3 exit(const Collision& met, glm::vec3, float) const { return met.place.world; }
  /// From the first event: direct light. As exact as that of VolumeMedium.
  size_t offsetsAcross(const Collision& met, const Memory&, std::span<float> offsets, Random&) const {
    return evenOffsets(met.offset, offsets);
  }
  float transmittance(const ScenePoint& from, const Memory& memory, glm::vec3 direction, float distance, Random& random,
                      TraceCounts& counts) const;

 private:
  std::shared_ptr<const TraceData> cloth_;
  VolumeMedium volume_;
  std::shared_ptr<const BvdfSet> bvdf_;
};

}  // namespace loomlight
