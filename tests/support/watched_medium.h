#pragma once

#include <atomic>
#include <functional>
#include <memory>

#include "tests/support/path_around.h"

namespace loomlight::test {

/// A medium that tells of each path that sets out into it, and can hold it up there.
class WatchedMedium : public Medium {
 public:
  /// `onPath` is called with the number of the path, from 1, by the thread that traces it, and `onFlight` (may be
  /// empty) before each flight of any of them, with its number.
  WatchedMedium(std::shared_ptr<const Medium> medium, std::function<void(uint64_t)> onPath,
                std::function<void(uint64_t)> onFlight = {})
      : medium_(std::move(medium)), onPath_(std::move(onPath)), onFlight_(std::move(onFlight)) {}

  uint64_t paths() const { return paths_; }

  std::unique_ptr<MediumPath> path() const override { return std::make_unique<Path>(*this); }
  bool seesDirectLightApart() const override { return medium_->seesDirectLightApart(); }

 private:
  class Path final : public PathAround {
   public:
    explicit Path(const WatchedMedium& medium) : PathAround(medium.medium_->path()), watched_(medium) {}
    void begin(const ScenePoint& from) override {
      watched_.onPath_(++watched_.paths_);
      PathAround::begin(from);
    }
    std::optional<Collision> collide(glm::vec3 direction, Random& random, TraceCounts& counts) override {
      if (watched_.onFlight_) watched_.onFlight_(++watched_.flights_);
      return PathAround::collide(direction, random, counts);
    }

   private:
    const WatchedMedium& watched_;
  };

  std::shared_ptr<const Medium> medium_;
  std::function<void(uint64_t)> onPath_;
  std::function<void(uint64_t)> onFlight_;
  mutable std::atomic<uint64_t> paths_{0}, flights_{0};
};

}  // namespace loomlight::test
