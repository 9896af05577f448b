#pragma once

#include "render/media/medium.h"

namespace loomlight::test {

/// A path that goes as another does, for tests to watch or to change in part.
class PathAround : public MediumPath {
 public:
  explicit PathAround(std::unique_ptr<MediumPath> path) : path_(std::move(path)) {}

  void begin(const ScenePoint& from) override { path_->begin(from); }
  std::optional<Collision> collide(glm::vec3 direction, Random& random, TraceCounts& counts) override {
    return path_->collide(direction, random, counts);
  }
  void leave(const Collision& met, glm::vec3 wi, int order) override { path_->leave(met, wi, order); }
  size_t offsetsAcross(const Collision& met, std::span<float> offsets, Random& random) const override {
    return path_->offsetsAcross(met, offsets, random);
  }
  float transmittance(glm::vec3 direction, float distance, Random& random, TraceCounts& counts) const override {
    return path_->transmittance(direction, distance, random, counts);
  }
  const ScenePoint& place() const override { return path_->place(); }
  std::unique_ptr<MediumPath> clone() const override { return path_->clone(); }

 private:
  std::unique_ptr<MediumPath> path_;
};

}  // namespace loomlight::test
