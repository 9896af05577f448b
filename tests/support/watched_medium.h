#pragma once

#include <atomic>
#include <functional>
#include <memory>

#include "render/media/medium.h"

namespace loomlight::test {

/// A medium that tells of each path that the camera sends into it, and can hold it up there.
class WatchedMedium : public Medium {
 public:
  /// `onPath` is called with the number of the path, from 1, by the thread that traces it.
  WatchedMedium(std::shared_ptr<const Medium> medium, std::function<void(uint64_t)> onPath)
      : medium_(std::move(medium)), onPath_(std::move(onPath)) {}

  uint64_t paths() const { return paths_; }

  std::optional<Collision> collide(const Departure& from, glm::vec3 direction, Random& random,
                                   TraceCounts& counts) const override {
    if (from.events == 0) onPath_(++paths_);
    return medium_->collide(from, direction, random, counts);
  }
  float transmittance(const Departure& from, glm::vec3 direction, float distance, Random& random,
                      TraceCounts& counts) const override {
    return medium_->transmittance(from, direction, distance, random, counts);
  }
  bool seesDirectLightApart() const override { return medium_->seesDirectLightApart(); }
  Departure leave(const Collision& collision, glm::vec3 wi, int order) const override {
    return medium_->leave(collision, wi, order);
  }

 private:
  std::shared_ptr<const Medium> medium_;
  std::function<void(uint64_t)> onPath_;
  mutable std::atomic<uint64_t> paths_{0};
};

}  // namespace loomlight::test
