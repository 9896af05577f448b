#pragma once

#include <cstddef>
#include <memory>

#include "core/base/task.h"
#include "render/trace/medium.h"

namespace loomlight {

/// The cloth fibre by fibre: every strand of the piece as Embree round curves, bent onto the drape. No statistics: it
/// is the ground truth that the volume is measured against. The same strands, lobes, lights and bookkeeping.
///
/// Where light sets out again is part of the claim. Of packed fibres (FibreLayout::packed), which do not overlap, it
/// leaves from the point where its mode comes out of the fibre. Of fibres laid at random, which do overlap (the
/// report's), it leaves from where it came in, because the way through would start it inside neighbours. Either way the
/// fibre it leaves is not met again within three radii, and surfaces are met from outside only.
class FibreMedium final : public Medium {
 public:
  struct Size {
    double segments = 0;
    double bytes = 0;  ///< of geometry and accelerator together, as estimated before anything is made
  };
  static Size estimate(const Scene& scene);

  /// Throws InputError, saying how much it would take, where the estimate is beyond `limit_bytes`. Null when stopped.
  /// The scene must outlive the medium.
  static std::unique_ptr<const FibreMedium> build(const Scene& scene, double limit_bytes, const Task& task);
  ~FibreMedium() override;

  size_t segments() const;
  size_t geometryBytes() const;
  size_t acceleratorBytes() const;  ///< as Embree reports its allocations

  std::optional<Collision> collide(const Departure& from, glm::vec3 direction, Random& random,
                                   TraceCounts& counts) const override;
  float transmittance(const Departure& from, glm::vec3 direction, float distance, Random& random,
                      TraceCounts& counts) const override;
  Departure leave(const Collision& collision, glm::vec3 wi, int order) const override;

 private:
  struct Parts;
  explicit FibreMedium(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace loomlight
