#pragma once

#include "render/media/medium.h"

namespace loomlight {

/// A path through one kind of medium, whose memory of it, M::Memory, is a plain value of that medium's own. M does the
/// work, and keeps the memory up to date when a fibre is met:
///
///   std::optional<Collision> collide(from, Memory&, direction, random, counts) const;
///   glm::vec3 exit(collision, wi, order) const;  where in the world light comes out of the fibre
///   float transmittance(from, const Memory&, direction, distance, random, counts) const;
///   size_t offsetsAcross(met, const Memory&, offsets, random) const;  if it can tell more than one
template <class M>
class PathThrough final : public MediumPath {
 public:
  explicit PathThrough(const M& medium) : medium_(medium) {}

  void begin(const ScenePoint& from) override {
    place_ = from;
    memory_ = {};
  }
  std::optional<Collision> collide(glm::vec3 direction, Random& random, TraceCounts& counts) override {
    auto met = medium_.collide(place_, memory_, direction, random, counts);
    if (met) ++counts.events;
    return met;
  }
  void leave(const Collision& met, glm::vec3 wi, int order) override {
    place_ = {medium_.exit(met, wi, order), met.place.tet};
  }
  float transmittance(glm::vec3 direction, float distance, Random& random, TraceCounts& counts) const override {
    return medium_.transmittance(place_, memory_, direction, distance, random, counts);
  }
  size_t offsetsAcross(const Collision& met, std::span<float> offsets, Random& random) const override {
    if constexpr (requires { medium_.offsetsAcross(met, memory_, offsets, random); })
      return medium_.offsetsAcross(met, memory_, offsets, random);
    else
      return MediumPath::offsetsAcross(met, offsets, random);
  }
  const ScenePoint& place() const override { return place_; }
  std::unique_ptr<MediumPath> clone() const override { return std::make_unique<PathThrough>(*this); }

 private:
  const M& medium_;
  ScenePoint place_;
  typename M::Memory memory_;
};

}  // namespace loomlight
