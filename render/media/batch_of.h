#pragma once

#include <vector>

#include "render/media/medium.h"

namespace loomlight {

/// Where the paths of a batch stand, and what the medium remembers of each: a plain value of its own.
template <class Memory>
class PathStates : public MediumBatch {
 public:
  explicit PathStates(size_t paths) : paths_(paths) {}

  void begin(uint32_t path, const ScenePoint& from, const RayCone&) override { paths_[path] = {from, {}}; }
  const ScenePoint& place(uint32_t path) const override { return paths_[path].place; }
  void copy(uint32_t path, uint32_t to) override { paths_[to] = paths_[path]; }

 protected:
  struct Path {
    ScenePoint place;
    Memory memory;
  };
  std::vector<Path> paths_;
};

/// Paths through a medium M that takes one after the other. M does the work, and keeps its M::Memory of a path up to
/// date when a fibre is met:
///
///   std::optional<Collision> collide(from, Memory&, direction, random, counts) const;
///   glm::vec3 exit(collision, wi, inside) const;  where in the world light comes out of the fibre
///   float transmittance(from, const Memory&, direction, distance, random, counts) const;
///   size_t offsetsAcross(met, const Memory&, offsets, random) const;
template <class M>
class BatchOf final : public PathStates<typename M::Memory> {
 public:
  BatchOf(const M& medium, size_t paths) : PathStates<typename M::Memory>(paths), medium_(medium) {}

  void collide(std::span<const PathRay> pathRays, std::span<std::optional<Collision>> met,
               TraceCounts& counts) override {
    for (size_t i = 0; i < pathRays.size(); ++i) {
      auto& path = this->paths_[pathRays[i].path];
      met[i] = medium_.collide(path.place, path.memory, pathRays[i].direction, *pathRays[i].random, counts);
      counts.events += met[i] ? 1 : 0;
    }
  }
  void leave(uint32_t path, const Collision& met, glm::vec3 wi, float inside) override {
    this->paths_[path].place = {medium_.exit(met, wi, inside), met.place.tet};
  }
  void transmit(std::span<ShadowRay> rays, TraceCounts& counts) override {
    for (ShadowRay& ray : rays) {
      const auto& path = this->paths_[ray.path];
      ray.visible = medium_.transmittance(path.place, path.memory, ray.direction, ray.distance, *ray.random, counts);
    }
  }
  size_t offsetsAcross(uint32_t path, const Collision& met, std::span<float> offsets, Random& random) const override {
    return medium_.offsetsAcross(met, this->paths_[path].memory, offsets, random);
  }

 private:
  const M& medium_;
};

}  // namespace loomlight
