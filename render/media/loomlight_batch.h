#pragma once

#include <vector>

#include "render/media/loomlight_meetings.h"
#include "render/media/path_states.h"

namespace loomlight {

/// Paths through LoomlightMedium, side by side in lanes. The medium must outlive it.
class LoomlightBatch final : public PathStates<LoomlightMedium::Memory> {
 public:
  LoomlightBatch(const LoomlightMedium& medium, size_t paths);

  void collide(std::span<const PathRay> pathRays, std::span<std::optional<Collision>> met,
               TraceCounts& counts) override;
  void leave(uint32_t path, const Collision& met, glm::vec3 wi, float length_radii) override {
    paths_[path].place = {medium_.exit(met, wi, length_radii), met.place.tet};
  }
  void transmit(std::span<ShadowRay> rays, TraceCounts& counts) override { transmitBeyond(rays, {}, counts); }
  /// The same, were so much of each ray's way empty at its beginning. An empty `clear_mm` means that none is.
  void transmitBeyond(std::span<ShadowRay> rays, std::span<const float> clear_mm, TraceCounts& counts);
  size_t offsetsAcross(uint32_t path, const Collision& met, std::span<float> offsets, Random& random) const override {
    return medium_.offsetsAcross(met, paths_[path].memory, offsets, random);
  }
  const KnownFibres& known(uint32_t path) const { return paths_[path].memory.known; }

 private:
  class Flights;
  void meetAll(std::span<const PathRay> pathRays, std::span<std::optional<Collision>> met);

  const LoomlightMedium& medium_;
  LaneWalker walker_;
  LoomlightMeetings meetings_;
  // Of one call:
  std::vector<DepthRay> rays_;
  std::vector<FoundFibres> found_;
  std::vector<ShadowRay*> shadows_;  ///< those of `rays_`
};

}  // namespace loomlight
