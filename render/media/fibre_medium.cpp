#include "render/media/fibre_medium.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "render/media/fibre_collision.h"
#include "render/media/fibre_exit.h"
#include "render/media/path_through.h"
#include "render/scene/fibre_bvh.h"

namespace loomlight {
namespace {

constexpr float kOwnFibreRadii = 3;  // how far, in radii, a ray does not see the fibre that it has left

void expectWithin(const FibreSize& size, double limit_bytes) {
  constexpr double kGiB = 1024.0 * 1024 * 1024;
  if (size.bytes <= limit_bytes) return;
  throw InputError(
      fmt::format("{} has {:.3g} fibre segments, which would take {:.2f} GiB; expected at most {:.2f} GiB: make the "
                  "piece smaller, or raise the limit",
                  size.isWholePiece() ? "this piece" : "one repeat of this piece", size.segments, size.bytes / kGiB,
                  limit_bytes / kGiB));
}

FibreRay rayFrom(const ScenePoint& from, const FibreMedium::Memory& leaving, glm::vec3 direction, float length_mm) {
  return {from.world, direction, length_mm, leaving.fibre, leaving.clearance_mm};
}

}  // namespace

FibreMedium::FibreMedium(std::shared_ptr<const TraceData> cloth, const FibreSize& size,
                         std::unique_ptr<const FibreBvh> bvh)
    : cloth_(std::move(cloth)), size_(size), bvh_(std::move(bvh)) {}
FibreMedium::~FibreMedium() = default;

std::unique_ptr<const FibreMedium> FibreMedium::build(std::shared_ptr<const TraceData> cloth,
                                                      const FibreOptions& options, const Task& task) {
  const FibreSize size = planFibres(*cloth, options);
  expectWithin(size, options.limit_bytes);
  auto bvh = FibreBvh::build(cloth, size, task);
  if (!bvh) return nullptr;
  return std::unique_ptr<const FibreMedium>(new FibreMedium(std::move(cloth), size, std::move(bvh)));
}

size_t FibreMedium::segments() const {
  return bvh_->segments();
}

size_t FibreMedium::geometryBytes() const {
  return bvh_->geometryBytes();
}

size_t FibreMedium::acceleratorBytes() const {
  return bvh_->acceleratorBytes();
}

std::unique_ptr<MediumPath> FibreMedium::path() const {
  return std::make_unique<PathThrough<FibreMedium>>(*this);
}

std::optional<Collision> FibreMedium::collide(const ScenePoint& from, Memory& memory, glm::vec3 direction, Random&,
                                              TraceCounts& counts) const {
  ++counts.rays;
  const auto hit = bvh_->meet(rayFrom(from, memory, direction, std::numeric_limits<float>::infinity()));
  if (!hit) return std::nullopt;
  const Collision c = collisionAt(*cloth_, {from.world + hit->distance_mm * direction, -1}, direction, *hit);
  memory = {hit->fibre, kOwnFibreRadii * c.optics.fibreRadius_mm};
  return c;
}

glm::vec3 FibreMedium::exit(const Collision& met, glm::vec3 wi, int order) const {
  return met.optics.packed ? fibreExit(*cloth_, met, wi, order) : met.place.world;
}

float FibreMedium::transmittance(const ScenePoint& from, const Memory& memory, glm::vec3 direction, float distance,
                                 Random&, TraceCounts& counts) const {
  ++counts.rays;
  return bvh_->isFree(rayFrom(from, memory, direction, distance)) ? 1.0f : 0.0f;
}

}  // namespace loomlight
