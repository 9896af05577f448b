#include "render/media/medium.h"

#include <vector>

namespace loomlight {
namespace {

/// Asks one path after the other.
class OneByOne final : public MediumBatch {
 public:
  OneByOne(const Medium& medium, size_t count) {
    for (size_t i = 0; i < count; ++i) paths_.push_back(medium.path());
  }

  void begin(uint32_t path, const ScenePoint& from, const RayCone&) override { paths_[path]->begin(from); }
  void collide(std::span<const PathRay> pathRays, std::span<std::optional<Collision>> met,
               TraceCounts& counts) override {
    for (size_t i = 0; i < pathRays.size(); ++i)
      met[i] = paths_[pathRays[i].path]->collide(pathRays[i].direction, *pathRays[i].random, counts);
  }
  void leave(uint32_t path, const Collision& met, glm::vec3 wi, int order) override {
    paths_[path]->leave(met, wi, order);
  }
  void transmit(std::span<ShadowRay> rays, TraceCounts& counts) override {
    for (ShadowRay& ray : rays)
      ray.visible = paths_[ray.path]->transmittance(ray.direction, ray.distance, *ray.random, counts);
  }
  size_t offsetsAcross(uint32_t path, const Collision& met, std::span<float> offsets, Random& random) const override {
    return paths_[path]->offsetsAcross(met, offsets, random);
  }

 private:
  std::vector<std::unique_ptr<MediumPath>> paths_;
};

}  // namespace

std::unique_ptr<MediumBatch> Medium::batch(size_t paths) const {
  return std::make_unique<OneByOne>(*this, paths);
}

}  // namespace loomlight
