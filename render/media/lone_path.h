#pragma once

#include "render/media/medium.h"

namespace loomlight {

/// A batch of one path, for those who have no more. `Batch` is made of (medium, 1), and `batch[0]` is the path's state,
/// a value that has its `place`.
template <class M, class Batch>
class LonePath final : public MediumPath {
 public:
  explicit LonePath(const M& medium) : medium_(medium), batch_(medium, 1) {}

  void begin(const ScenePoint& from) override { batch_.begin(0, from, {}); }
  std::optional<Collision> collide(glm::vec3 direction, Random& random, TraceCounts& counts) override {
    const PathRay pathRay{0, direction, &random};
    std::optional<Collision> met;
    batch_.collide({&pathRay, 1}, {&met, 1}, counts);
    return met;
  }
  void leave(const Collision& met, glm::vec3 wi, int order) override { batch_.leave(0, met, wi, order); }
  float transmittance(glm::vec3 direction, float distance, Random& random, TraceCounts& counts) const override {
    ShadowRay ray{0, direction, distance, &random};
    batch_.transmit({&ray, 1}, counts);
    return ray.visible;
  }
  size_t offsetsAcross(const Collision& met, std::span<float> offsets, Random& random) const override {
    return batch_.offsetsAcross(0, met, offsets, random);
  }
  const ScenePoint& place() const override { return batch_[0].place; }
  std::unique_ptr<MediumPath> clone() const override {
    auto copy = std::make_unique<LonePath>(medium_);
    copy->batch_[0] = batch_[0];
    return copy;
  }

 private:
  const M& medium_;
  mutable Batch batch_;  ///< what it has beside the path's state is room to work in
};

}  // namespace loomlight
