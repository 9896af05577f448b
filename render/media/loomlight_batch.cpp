#include "render/media/loomlight_batch.h"

#include <algorithm>
#include <cmath>

// How it works. Flights and shadow rays are both walks until an optical depth is used up: that of a flight is drawn
// from an exponential, that of a shadow ray is where nothing is worth following any further. LaneWalker walks them in
// vector registers and tells, in any order, which met fibres and which left; LoomlightMeetings makes collisions of the
// former, eight at a time, and what is left of shadow rays' depths becomes visibility.
namespace loomlight {
namespace {

/// Exact down to e^-4; below that 0 or e^-4, because what hardly gets through is not worth walking for.
constexpr float kExactDepth = 4.0f;

/// Turns what is left of shadow rays' depths into how visible the light is.
class Visibilities final : public DepthRayEnds {
 public:
  Visibilities(std::span<ShadowRay* const> shadows, std::span<const DepthRay> rays) : shadows_(shadows), rays_(rays) {}

  FoundFibres& found(size_t i) override {
    shadows_[i]->visible = 0;
    return anything_;
  }
  void left(size_t i, float depth, int) override {
    shadows_[i]->visible = std::exp(-std::min(rays_[i].depth - depth, kExactDepth));
  }

 private:
  std::span<ShadowRay* const> shadows_;
  std::span<const DepthRay> rays_;
  FoundFibres anything_;  ///< nobody asks what is in the way
};

}  // namespace

/// Keeps what flights find, and has those that end at the fibre before meet it.
class LoomlightBatch::Flights final : public DepthRayEnds {
 public:
  Flights(const LoomlightMedium& medium, std::span<Path> paths, std::span<const PathRay> pathRays,
          std::span<const DepthRay> rays, std::vector<FoundFibres>& found, std::span<std::optional<Collision>> met)
      : medium_(medium), paths_(paths), pathRays_(pathRays), rays_(rays), found_(found), met_(met) {}

  FoundFibres& found(size_t) override { return found_.emplace_back(); }
  void left(size_t i, float, int tet) override {
    const PathRay& pathRay = pathRays_[i];
    const float distance = rays_[i].tMax_mm;
    met_[i].reset();
    if (std::isinf(distance)) return;  // it leaves the scene
    Path& path = paths_[pathRay.path];
    const ScenePoint place{path.place.world + distance * pathRay.direction, tet};
    met_[i] = medium_.meetBefore(place, pathRay.direction, distance, path.memory);
    medium_.remember(*met_[i], path.memory);
  }

 private:
  const LoomlightMedium& medium_;
  std::span<Path> paths_;
  std::span<const PathRay> pathRays_;
  std::span<const DepthRay> rays_;
  std::vector<FoundFibres>& found_;
  std::span<std::optional<Collision>> met_;
};

LoomlightBatch::LoomlightBatch(const LoomlightMedium& medium, size_t paths)
    : PathStates(paths), medium_(medium), walker_(medium.cloth(), medium.walkRules()), meetings_(medium, walker_) {}

void LoomlightBatch::collide(std::span<const PathRay> pathRays, std::span<std::optional<Collision>> met,
                             TraceCounts& counts) {
  rays_.clear();
  for (const PathRay& pathRay : pathRays) {
    const Path& path = paths_[pathRay.path];
    const float toBefore = distanceTo(path.memory.known.before, path.place.world, pathRay.direction);
    const float depth = -std::log(1 - pathRay.random->uniform());
    rays_.push_back({path.place, pathRay.direction, toBefore, depth, &path.memory.known});
  }
  found_.clear();
  Flights flights(medium_, paths_, pathRays, rays_, found_, met);
  counts.rays += pathRays.size();
  counts.steps += walker_.walk(rays_, flights);
  meetAll(pathRays, met);
  for (const auto& collision : met) counts.events += collision ? 1 : 0;
}

/// Makes collisions of what was found.
void LoomlightBatch::meetAll(std::span<const PathRay> pathRays, std::span<std::optional<Collision>> met) {
  for (size_t first = 0; first < found_.size(); first += LoomlightMeetings::kMost) {
    std::array<LoomlightMeetings::Meeting, LoomlightMeetings::kMost> meetings;
    const size_t count = std::min(meetings.size(), found_.size() - first);
    for (size_t i = 0; i < count; ++i) {
      const FoundFibres& found = found_[first + i];
      const PathRay& pathRay = pathRays[found.ray];
      Path& path = paths_[pathRay.path];
      meetings[i] = {&found, &path.place, pathRay.direction, pathRay.random, &path.memory, &met[found.ray]};
    }
    meetings_.meet({meetings.data(), count});
    for (size_t i = 0; i < count; ++i) medium_.remember(**meetings[i].met, *meetings[i].memory);
  }
}

void LoomlightBatch::transmitBeyond(std::span<ShadowRay> rays, std::span<const float> clear_mm, TraceCounts& counts) {
  rays_.clear();
  shadows_.clear();
  for (size_t i = 0; i < rays.size(); ++i) {
    ShadowRay& ray = rays[i];
    const Path& path = paths_[ray.path];
    const KnownFibres& known = path.memory.known;
    if (distanceTo(known.before, path.place.world, ray.direction) < ray.distance) {
      ray.visible = 0;
      continue;
    }
    const float deepest = kExactDepth - std::log(1 - ray.random->uniform());
    rays_.push_back({path.place, ray.direction, ray.distance, deepest, &known, clear_mm.empty() ? 0 : clear_mm[i]});
    shadows_.push_back(&ray);
  }
  Visibilities visibilities(shadows_, rays_);
  counts.rays += rays.size();
  counts.steps += walker_.walk(rays_, visibilities);
}

std::unique_ptr<MediumBatch> LoomlightMedium::batch(size_t paths) const {
  return std::make_unique<LoomlightBatch>(*this, paths);
}

}  // namespace loomlight
