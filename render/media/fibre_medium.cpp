#include "render/media/fibre_medium.h"

#include <fmt/format.h>

#include <cassert>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "render/media/fibre_collision.h"
#include "render/media/fibre_exit.h"
#include "render/media/path_states.h"
#include "render/scene/fibre_bvh.h"

// How it works. The cloth is all of its fibres, without statistics. planFibres() chooses how they are laid: the
// whole piece or one of its repeats as curves in a tree of Embree's (FibreBvh), or each kind of cell once, met cell
// by cell (FibreBricks). A path's next event is the first surface that its ray comes to from outside; a shadow ray
// sees all or nothing. A ray does not see the fibre that it leaves within three radii, as the BCSDF has dealt with
// the whole of that fibre's section; where fibres lie packed it goes on from where light really comes out
// (fibreExit). Lengths are in mm. Cost: one query of a tree for each ray and, with bricks, each cell on its way.

namespace loomlight {
namespace {

constexpr float kOwnFibreRadii = 3;  // how far, in radii, a ray does not see the fibre that it has left

const char* partOf(const FibreSize& size) {
  if (size.bricks) return "one of each kind of cell";
  return size.isWholePiece() ? "this piece" : "one repeat of this piece";
}

void expectWithin(const FibreSize& size, double limit_bytes) {
  constexpr double kGiB = 1024.0 * 1024 * 1024;
  if (size.bytes <= limit_bytes) return;
  throw InputError(
      fmt::format("{} has {:.3g} fibre segments, which would take {:.2f} GiB; expected at most {:.2f} GiB: make the "
                  "piece smaller, or raise the limit",
                  partOf(size), size.segments, size.bytes / kGiB, limit_bytes / kGiB));
}

/// Paths among fibres.
class FibreBatch final : public PathStates<OwnFibre> {
 public:
  FibreBatch(const FibreMedium& medium, size_t paths) : PathStates(paths), medium_(medium), rays_(medium.rays()) {}

  void collide(std::span<const PathRay> pathRays, std::span<std::optional<Collision>> met,
               TraceCounts& counts) override {
    for (size_t i = 0; i < pathRays.size(); ++i)
      met[i] = collide(paths_[pathRays[i].path], pathRays[i].direction, counts);
  }
  void leave(uint32_t path, const Collision& met, glm::vec3 wi, float length_radii) override {
    paths_[path].place = {met.optics.packed ? fibreExit(medium_.cloth(), met, wi, length_radii) : met.place.world,
                          met.place.tet};
  }
  void transmit(std::span<ShadowRay> rays, TraceCounts& counts) override {
    counts.rays += rays.size();
    for (ShadowRay& ray : rays) {
      const Path& path = paths_[ray.path];
      ray.visible = rays_->isFree(path.place, ray.direction, ray.distance, path.memory) ? 1.0f : 0.0f;
    }
  }
  size_t offsetsAcross(uint32_t, const Collision& met, std::span<float> offsets, Random&) const override {
    offsets[0] = met.offset;
    return 1;
  }

 private:
  std::optional<Collision> collide(Path& path, glm::vec3 direction, TraceCounts& counts) {
    ++counts.rays;
    const auto met = rays_->meet(path.place, direction, path.memory);
    if (!met) return std::nullopt;
    ++counts.events;
    const Collision c = collisionAt(medium_.cloth(), met->place, direction, met->hit);
    path.memory = {c.fibre, kOwnFibreRadii * c.radius_mm};
    return c;
  }

  const FibreMedium& medium_;
  std::unique_ptr<FibreRays> rays_;
};

}  // namespace

FibreMedium::FibreMedium(std::shared_ptr<const TraceData> cloth, const FibreSize& size,
                         std::unique_ptr<const FibreBvh> bvh)
    : cloth_(std::move(cloth)), size_(size), bvh_(std::move(bvh)) {}
FibreMedium::~FibreMedium() = default;

std::unique_ptr<const FibreMedium> FibreMedium::build(std::shared_ptr<const TraceData> cloth,
                                                      const FibreOptions& options, const Task& task) {
  const FibreSize size = planFibres(*cloth, options);
  expectWithin(size, options.limit_bytes);
  if (size.bricks) return std::make_unique<const FibreMedium>(std::move(cloth));
  auto bvh = FibreBvh::build(cloth, size, task);
  if (!bvh) return nullptr;
  return std::unique_ptr<const FibreMedium>(new FibreMedium(std::move(cloth), size, std::move(bvh)));
}

FibreMedium::FibreMedium(std::shared_ptr<const TraceData> cloth) : cloth_(std::move(cloth)) {
  assert(cloth_->fibres);
}

size_t FibreMedium::segments() const {
  return bvh_ ? bvh_->segments() : 0;
}

size_t FibreMedium::geometryBytes() const {
  return bvh_ ? bvh_->geometryBytes() : 0;
}

size_t FibreMedium::acceleratorBytes() const {
  return bvh_ ? bvh_->acceleratorBytes() : 0;
}

std::unique_ptr<FibreRays> FibreMedium::rays() const {
  return bvh_ ? raysInto(*bvh_) : raysIntoBricks(*cloth_);
}

std::unique_ptr<MediumBatch> FibreMedium::batch(size_t paths) const {
  return std::make_unique<FibreBatch>(*this, paths);
}

}  // namespace loomlight
