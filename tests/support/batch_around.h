#pragma once

#include "render/media/medium.h"

namespace loomlight::test {

/// Paths that go as those of another batch do, one after the other, for tests to watch or to change in part.
class BatchAround : public MediumBatch {
 public:
  explicit BatchAround(std::unique_ptr<MediumBatch> batch) : batch_(std::move(batch)) {}

  void begin(uint32_t path, const ScenePoint& from, const RayCone& cone) override { batch_->begin(path, from, cone); }
  void collide(std::span<const PathRay> pathRays, std::span<std::optional<Collision>> met,
               TraceCounts& counts) override {
    for (size_t i = 0; i < pathRays.size(); ++i) met[i] = fly(pathRays[i], counts);
  }
  void leave(uint32_t path, const Collision& met, glm::vec3 wi, float length_radii) override {
    batch_->leave(path, met, wi, length_radii);
  }
  void transmit(std::span<ShadowRay> rays, TraceCounts& counts) override { batch_->transmit(rays, counts); }
  size_t offsetsAcross(uint32_t path, const Collision& met, std::span<float> offsets, Random& random) const override {
    return batch_->offsetsAcross(path, met, offsets, random);
  }
  const ScenePoint& place(uint32_t path) const override { return batch_->place(path); }
  void copy(uint32_t path, uint32_t to) override { batch_->copy(path, to); }

 protected:
  virtual std::optional<Collision> fly(const PathRay& pathRay, TraceCounts& counts) {
    std::optional<Collision> met;
    batch_->collide({&pathRay, 1}, {&met, 1}, counts);
    return met;
  }

 private:
  std::unique_ptr<MediumBatch> batch_;
};

}  // namespace loomlight::test
