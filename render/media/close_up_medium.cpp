#include "render/media/close_up_medium.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "render/media/fibre_collision.h"
#include "render/media/loomlight_batch.h"

namespace loomlight {
namespace {

/// Paths whose first flight may be an eye's that is near.
class CloseUpBatch final : public MediumBatch {
 public:
  CloseUpBatch(const CloseUpMedium& medium, const LoomlightMedium& volume, size_t paths)
      : medium_(medium),
        cloth_(volume.cloth()),
        paths_(volume, paths),
        reader_(*cloth_.fibres, *cloth_.volume),
        cones_(paths) {}

  void begin(uint32_t path, const ScenePoint& from, const RayCone& cone) override {
    cones_[path] = cone;
    fromEyes_ = fromEyes_ || !cone.isLine();
    paths_.begin(path, from, cone);
  }
  void collide(std::span<const Flight> flights, std::span<std::optional<Collision>> met, TraceCounts& counts) override {
    if (!fromEyes_) return paths_.collide(flights, met, counts);
    fromEyes_ = false;
    others_.clear();
    places_.clear();
    for (size_t i = 0; i < flights.size(); ++i) {
      if (look(flights[i], met[i], counts)) continue;
      others_.push_back(flights[i]);
      places_.push_back(i);
    }
    metByOthers_.resize(others_.size());
    paths_.collide(others_, metByOthers_, counts);
    for (size_t i = 0; i < places_.size(); ++i) met[places_[i]] = metByOthers_[i];
  }
  void leave(uint32_t path, const Collision& met, glm::vec3 wi, int order) override {
    paths_.leave(path, met, wi, order);
  }
  void transmit(std::span<ShadowRay> rays, TraceCounts& counts) override { paths_.transmit(rays, counts); }
  size_t offsetsAcross(uint32_t path, const Collision& met, std::span<float> offsets, Random& random) const override {
    return paths_.offsetsAcross(path, met, offsets, random);
  }

 private:
  /// Whether a flight is that of an eye which meets fibres themselves; then `met` is what it meets.
  bool look(const Flight& flight, std::optional<Collision>& met, TraceCounts& counts) {
    const RayCone cone = std::exchange(cones_[flight.path], {});
    if (cone.isLine()) return false;
    const ScenePoint& from = paths_[flight.path].place;
    ShellWalk walk(cloth_, from, flight.direction, std::numeric_limits<float>::infinity());
    if (!walk.next() || !isNear(cone.widthAt(walk.segment().passed + walk.segment().tEnter), *flight.random))
      return false;
    ++counts.rays;
    met.reset();
    do {
      const ShellSegment& s = walk.segment();
      const auto hit = reader_.meet(s.clothOrigin, s.clothDirection, s.tEnter, s.tLeave);
      if (!hit) continue;
      const FibreHit inWorld = bent(*hit, s);
      met =
          collisionAt(cloth_, {from.world + inWorld.distance_mm * flight.direction, s.tet}, flight.direction, inWorld);
      paths_.meet(flight.path, *met);
      ++counts.events;
      return true;
    } while (walk.next());
    return true;
  }

  bool isNear(float width_mm, const Random& random) const {
    const float chance = medium_.chanceAt(width_mm);
    if (chance <= 0 || chance >= 1) return chance > 0;
    constexpr uint64_t kPurpose = 0xC105E;
    Random copy = random;  // the path's own numbers are drawn as if nobody had asked
    return Random(hashCombine(copy.next(), kPurpose)).uniform() < chance;
  }

  /// A hit in cloth space, in the world.
  FibreHit bent(FibreHit hit, const ShellSegment& s) const {
    hit.distance_mm += s.passed;
    if (cloth_.shell->isFlat()) return hit;
    hit.tangent = glm::normalize(s.drape.frame * hit.tangent);
    const glm::vec3 normal = glm::transpose(cloth_.shell->tets()[static_cast<size_t>(s.tet)].toCloth) * hit.normal;
    hit.normal = glm::normalize(normal - glm::dot(normal, hit.tangent) * hit.tangent);
    return hit;
  }

  const CloseUpMedium& medium_;
  const TraceData& cloth_;
  LoomlightBatch paths_;
  FibreBricks::Reader reader_;
  std::vector<RayCone> cones_;  ///< of paths that have not flown yet; a line of the others
  bool fromEyes_ = false;       ///< any of them
  // Of one call:
  std::vector<Flight> others_;
  std::vector<size_t> places_;
  std::vector<std::optional<Collision>> metByOthers_;
};

}  // namespace

CloseUpMedium::CloseUpMedium(std::shared_ptr<const TraceData> cloth)
    : volume_(std::move(cloth)),
      diameter_mm_(2 * static_cast<float>(volume_.cloth().volume->geometry().yarns().minFibreRadius_mm())) {}

float CloseUpMedium::chanceAt(float width_mm) const {
  constexpr float kNone = 0.5f, kAll = 0.75f;  // of a pixel, a fibre's diameter
  return std::clamp((diameter_mm_ / width_mm - kNone) / (kAll - kNone), 0.0f, 1.0f);
}

std::unique_ptr<MediumBatch> CloseUpMedium::batch(size_t paths) const {
  if (!volume_.cloth().fibres) return volume_.batch(paths);
  return std::make_unique<CloseUpBatch>(*this, volume_, paths);
}

}  // namespace loomlight
