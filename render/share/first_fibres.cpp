#include "render/share/first_fibres.h"

#include <limits>

#include "render/media/shell_walk.h"

namespace loomlight {

FirstFibres::FirstFibres(const Scene& scene, const Medium& medium, const CameraRays& camera)
    : scene_(scene), tracer_(scene, medium, camera, PathIntegrator::kBatch), keys_(scene) {}

bool FirstFibres::trace(std::span<PixelSample> wanted, const Task& task) {
  for (PixelSample& sample : wanted) sample.listener = &end_;
  TraceCounts counts;
  return tracer_.trace(wanted, counts, &task);
}

bool FirstFibres::isThrough(size_t i) const {
  return goesThrough(scene_, tracer_.ray(i));
}

LightCellPath FirstFibres::cellsOf(const PixelSample& sample, const Collision& at, const CellSums& known) {
  Random random(hashCombine(hashCombine(scene_.sampling.seed, sample.x), sample.y), sample.index);
  const float jx = random.uniform(), jy = random.uniform();
  const LightCellPath near = keys_.of(at, glm::vec2(jx, jy) - 0.5f);
  return known.knows(near.keys[kLieLevel]) ? near : keys_.of(at);
}

bool goesThrough(const Scene& scene, const Ray& ray) {
  ShellWalk walk(*scene.cloth, {ray.origin, -1}, ray.direction, std::numeric_limits<float>::max());
  return walk.next();
}

}  // namespace loomlight
