#include "render/media/close_up_medium.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "render/media/shell_walk.h"
#include "render/scene/fibre_bricks.h"

// How it works. Every path is in one of two groups, each with a batch of its own: through the volume, or among explicit
// fibres. Its first flight decides, by how wide a pixel is where the ray comes to the cloth, and between two widths by
// a number drawn from a copy of the path's own, so that the volume's paths are the same as if nobody had asked. The
// last meeting among fibres hands it over to the volume: light and shadow from there on are both the volume's, of one
// law. The volume is told nothing of the fibres that were met before, which after so many changes colours by .1 % at
// most. From afar all paths are of the volume, and its batch is handed on as it is; else calls are divided by group and
// the answers put together.

namespace loomlight {
namespace {

/// Paths of which some go among fibres, and the others through the volume.
class CloseUpBatch final : public MediumBatch {
 public:
  CloseUpBatch(const LoomlightMedium& volume, const FibreMedium& fibres, size_t paths)
      : cloth_(volume.cloth()), paths_(paths) {
    groups_[kInVolume].batch = volume.batch(paths);
    groups_[kAmongFibres].batch = fibres.batch(paths);
  }

  void begin(uint32_t path, const ScenePoint& from, const RayCone& cone) override {
    paths_[path] = {from, cone};
    groups_[kInVolume].batch->begin(path, from, cone);
  }
  void collide(std::span<const PathRay> pathRays, std::span<std::optional<Collision>> met,
               TraceCounts& counts) override {
    for (const PathRay& pathRay : pathRays) decide(pathRay);
    if (!anyAmongFibres_) return groups_[kInVolume].batch->collide(pathRays, met, counts);
    divide(pathRays);
    for (Group& group : groups_) {
      group.pathRays.clear();
      for (const size_t i : group.members) group.pathRays.push_back(pathRays[i]);
      group.met.resize(group.pathRays.size());
      group.batch->collide(group.pathRays, group.met, counts);
      for (size_t k = 0; k < group.members.size(); ++k) met[group.members[k]] = group.met[k];
    }
    const Group& amongFibres = groups_[kAmongFibres];
    for (size_t k = 0; k < amongFibres.met.size(); ++k)
      if (const auto& fibre = amongFibres.met[k]) meets(amongFibres.pathRays[k].path, *fibre);
  }
  void leave(uint32_t path, const Collision& met, glm::vec3 wi, float length_radii) override {
    batchOf(path).leave(path, met, wi, length_radii);
  }
  void transmit(std::span<ShadowRay> rays, TraceCounts& counts) override {
    if (!anyAmongFibres_) return groups_[kInVolume].batch->transmit(rays, counts);
    divide(std::span<const ShadowRay>(rays));
    for (Group& group : groups_) {
      group.shadows.clear();
      for (const size_t i : group.members) group.shadows.push_back(rays[i]);
      group.batch->transmit(group.shadows, counts);
      for (size_t k = 0; k < group.members.size(); ++k) rays[group.members[k]].visible = group.shadows[k].visible;
    }
  }
  size_t offsetsAcross(uint32_t path, const Collision& met, std::span<float> offsets, Random& random) const override {
    return batchOf(path).offsetsAcross(path, met, offsets, random);
  }
  const ScenePoint& place(uint32_t path) const override { return batchOf(path).place(path); }
  void copy(uint32_t path, uint32_t to) override {
    paths_[to] = paths_[path];
    batchOf(path).copy(path, to);
  }

 private:
  struct Path {
    ScenePoint from;
    RayCone cone;    ///< of its first flight, until that begins; then a line
    int toMeet = 0;  ///< so many fibres, before it is in the volume
  };
  /// Through the volume, or among fibres.
  struct Group {
    std::unique_ptr<MediumBatch> batch;
    // Of one call:
    std::vector<size_t> members;  ///< of what was asked
    std::vector<PathRay> pathRays;
    std::vector<std::optional<Collision>> met;
    std::vector<ShadowRay> shadows;
  };

  static constexpr size_t kInVolume = 0, kAmongFibres = 1;
  size_t groupOf(uint32_t path) const { return paths_[path].toMeet > 0 ? kAmongFibres : kInVolume; }
  MediumBatch& batchOf(uint32_t path) const { return *groups_[groupOf(path)].batch; }

  template <class Asked>
  void divide(std::span<const Asked> asked) {
    for (Group& group : groups_) group.members.clear();
    for (size_t i = 0; i < asked.size(); ++i) groups_[groupOf(asked[i].path)].members.push_back(i);
  }

  /// Where its first flight sends a path.
  void decide(const PathRay& pathRay) {
    Path& path = paths_[pathRay.path];
    if (path.cone.isLine()) return;
    const bool near = isNear(path, pathRay);
    path.cone = {};
    if (!near) return;
    path.toMeet = CloseUpMedium::kMeetings;
    anyAmongFibres_ = true;
    groups_[kAmongFibres].batch->begin(pathRay.path, path.from, {});
  }

  /// A fibre that a path among fibres has met.
  void meets(uint32_t path, const Collision& fibre) {
    if (--paths_[path].toMeet == 0) groups_[kInVolume].batch->begin(path, fibre.place, {});
  }

  bool isNear(const Path& path, const PathRay& pathRay) const {
    const float nearest = distanceToBounds(*cloth_.shell, path.from.world, pathRay.direction);
    if (closeUpChance(cloth_, path.cone.widthAt(nearest)) <= 0) return false;
    ShellWalk walk(cloth_, path.from, pathRay.direction, std::numeric_limits<float>::infinity());
    if (!walk.next()) return false;
    const float chance = closeUpChance(cloth_, path.cone.widthAt(walk.segment().passed + walk.segment().tEnter));
    if (chance <= 0 || chance >= 1) return chance > 0;
    constexpr uint64_t kPurpose = 0xC105E;
    Random copy = *pathRay.random;  // the path's own numbers are drawn as if nobody had asked
    return Random(hashCombine(copy.next(), kPurpose)).uniform() < chance;
  }

  const TraceData& cloth_;
  std::vector<Path> paths_;
  bool anyAmongFibres_ = false;  ///< has any path gone there; from afar none does, and nothing is divided
  std::array<Group, 2> groups_;
};

}  // namespace

float closeUpChance(const TraceData& cloth, float width_mm) {
  constexpr float kNone = 0.5f, kAll = 0.75f;  // of a pixel, a fibre's diameter
  if (!cloth.fibres || cloth.estimator != Estimator::loomlight) return 0;
  return std::clamp((cloth.fibres->thinnest_mm() / width_mm - kNone) / (kAll - kNone), 0.0f, 1.0f);
}

CloseUpMedium::CloseUpMedium(std::shared_ptr<const TraceData> cloth) : volume_(cloth) {
  if (cloth->fibres) fibres_ = std::make_unique<const FibreMedium>(std::move(cloth));
}

std::unique_ptr<MediumBatch> CloseUpMedium::batch(size_t paths) const {
  if (!fibres_) return volume_.batch(paths);
  return std::make_unique<CloseUpBatch>(volume_, *fibres_, paths);
}

}  // namespace loomlight
