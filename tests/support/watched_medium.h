#pragma once

#include <atomic>
#include <functional>
#include <memory>

#include "tests/support/batch_around.h"

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

  std::unique_ptr<MediumBatch> batch(size_t paths) const override { return std::make_unique<Batch>(*this, paths); }
  bool seesDirectLightApart() const override { return medium_->seesDirectLightApart(); }

 private:
  class Batch final : public BatchAround {
   public:
    Batch(const WatchedMedium& medium, size_t paths) : BatchAround(medium.medium_->batch(paths)), watched_(medium) {}
    void begin(uint32_t path, const ScenePoint& from, const RayCone& cone) override {
      watched_.onPath_(++watched_.paths_);
      BatchAround::begin(path, from, cone);
    }

   private:
    std::optional<Collision> fly(const PathRay& pathRay, TraceCounts& counts) override {
      if (watched_.onFlight_) watched_.onFlight_(++watched_.flights_);
      return BatchAround::fly(pathRay, counts);
    }

    const WatchedMedium& watched_;
  };

  std::shared_ptr<const Medium> medium_;
  std::function<void(uint64_t)> onPath_;
  std::function<void(uint64_t)> onFlight_;
  mutable std::atomic<uint64_t> paths_{0}, flights_{0};
};

}  // namespace loomlight::test
