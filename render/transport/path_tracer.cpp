#include "render/transport/path_tracer.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cassert>
#include <cmath>
#include <limits>
#include <span>

#include "core/base/parallel.h"
#include "render/optics/fibre_frame.h"
#include "render/transport/path_light.h"

namespace loomlight {
namespace {

/// What a path knows of itself. Colour is not in it: only how far it has travelled inside the fibres of each material.
class PathState {
 public:
  explicit PathState(const Scene& scene) : scene_(scene) {}

  void travel(int material, float length_mm) { lengths_[material] += length_mm; }
  float weight() const { return weight_; }
  std::span<const float> lengths_mm() const { return {lengths_.data(), scene_.cloth->materials.size()}; }

  /// Ends the path at random, the likelier the more of its light has been absorbed; if it goes on, it is as bright as
  /// ever. The brightest channel decides: the mean would kill saturated hues.
  bool survives(Random& random) {
    const Rgb c = weight_ * attenuation(scene_.roulette_per_mm, lengths_mm());
    const float chance = std::max({c.r, c.g, c.b});
    if (chance >= 1) return true;
    if (random.uniform() >= chance) return false;
    weight_ /= chance;
    return true;
  }

 private:
  static constexpr int kMaxMaterials = 64;  // of a valid fabric
  const Scene& scene_;
  std::array<float, kMaxMaterials> lengths_{};
  float weight_ = 1;
};

/// A mode, in proportion to what each contributes: which way a connection to a lamp leaves the fibre.
int likelyOrder(const FibreBcsdf::Value& value, Random& random) {
  float rest = random.uniform() * value.sum();
  int order = 0;
  while (order + 1 < FibreBcsdf::kLobes && (rest -= value.q[order]) >= 0) ++order;
  return order;
}

/// Balance heuristic (Veach 1997).
float misWeight(float own, float other) {
  return own / (own + other);
}

/// How likely a collision looks for a lamp: each look costs a walk out of the cloth. The more of the lamp's light the
/// fibre would send on, the likelier, so that no look brings much more than another: narrow modes, met rarely, are what
/// makes pictures noisy. `value` is the sum of Q, 1/sr; the least chance keeps all possible.
float lampChance(const PathSampling& sampling, uint32_t events, float value) {
  constexpr float kCertain = 0.5f, kLeast = 0.05f;  // of the first event always: it is what the eye sees
  return !sampling.lampsByChance || events == 1 ? 1.0f : std::clamp(value / kCertain, kLeast, 1.0f);
}

/// One lamp, seen from a collision. Nothing when no light comes of it.
std::optional<PathLight> sampleLamp(const Scene& scene, MediumPath& path, const Collision& at, uint32_t events,
                                    const FibreFrame& frame, glm::vec3 wo, Random& random, TraceCounts& counts) {
  const auto light = scene.lighting->sample(at.place.world, random);
  if (!light || light->pdf <= 0) return std::nullopt;
  const FibreBcsdf& bcsdf = *scene.cloth->materials[at.material].bcsdf;
  const FibreBcsdf::Value value = bcsdf.evaluate(wo, frame.toLocal(light->wi), at.offset);
  const float pdf = value.sum();
  if (pdf <= 0) return std::nullopt;
  const float chance = lampChance(scene.sampling, events, pdf);
  if (random.uniform() >= chance) return std::nullopt;
  const float density = chance * light->pdf;
  const float weight = light->delta ? 1.0f : misWeight(density, pdf);
  path.leave(at, light->wi, likelyOrder(value, random));
  const float visible = path.transmittance(light->wi, light->distance, random, counts);
  if (visible == 0) return std::nullopt;
  return PathLight{light->radiance * (weight * visible / density), value.q, at.material,
                   value.chord * at.optics.fibreRadius_mm, value.inside};
}

/// Numbers of a path's first events that are stratified: so many each for the flight, the lamp and the fibre. Later
/// events differ too much from path to path to gain.
constexpr uint32_t kStratifiedEvents = 3, kDimensionsPerUse = 8, kDimensionsPerEvent = 3 * kDimensionsPerUse;

void recordFirstHit(const Collision& at, PathSample& sample) {
  sample.alpha = 1;
  sample.depth_mm = at.distance_mm;
  sample.normal = at.normal;
  sample.tangent = at.tangent;
  sample.yarn = at.yarn;
  sample.end = at.end;
  sample.pick = at.pick;
}

}  // namespace

TraceCounts& TraceCounts::operator+=(const TraceCounts& other) {
  paths += other.paths;
  events += other.events;
  rays += other.rays;
  steps += other.steps;
  return *this;
}

PathSample tracePath(const Scene& scene, const Medium& medium, const CameraRays& camera, int x, int y, uint32_t index,
                     TraceCounts& counts, PathLog* log) {
  const RenderSettings& settings = scene.fabric->render;
  Random random(hashCombine(hashCombine(hashCombine(settings.seed, x), y), 0), index);
  const auto stratify = [&](uint32_t dimension, uint32_t count) {
    if (scene.sampling.stratified) random.stratify(dimension, count);
  };
  stratify(0, 2);
  const float dx = random.uniform(), dy = random.uniform();
  const Ray ray = camera.ray(static_cast<float>(x) + dx, static_cast<float>(y) + dy);
  const bool lamps = scene.lighting->wantsSampling() && (scene.sampling.lamps || scene.lighting->isDelta());
  constexpr uint32_t kRouletteAfter = 4;

  PathSample sample;
  PathState state(scene);
  const auto path = medium.path();
  path->begin({ray.origin, -1});
  glm::vec3 direction = ray.direction;
  float scatterPdf = 0;
  bool addedAlready = false;  // what this flight may bring straight from a lamp to the first fibre
  const auto gather = [&](PathLight light) {
    light.radiance *= state.weight();
    (sample.events == 1 ? sample.direct : sample.indirect) +=
        colourOf(light, state.lengths_mm(), scene.absorption_per_mm);
    if (log) log->add(light, state.lengths_mm());
  };
  const auto gatherEscaped = [&](float visible) {
    const Rgb radiance = scene.lighting->escape(direction);
    if (visible == 0 || radiance == Rgb(0)) return;
    const float looked = lamps ? lampChance(scene.sampling, sample.events, scatterPdf) : 0.0f;
    const float weight = lamps ? misWeight(scatterPdf, looked * scene.lighting->pdf(direction)) : 1.0f;
    gather({radiance * (weight * visible)});
  };
  ++counts.paths;
  for (uint32_t dimension = 2;; dimension += kDimensionsPerEvent) {
    const uint32_t stratified = sample.events < kStratifiedEvents ? kDimensionsPerUse : 0;
    stratify(dimension, stratified);
    const auto collision = path->collide(direction, random, counts);
    if (!collision) {  // what the camera sees past the cloth is the backdrop's affair: alpha
      if (sample.events > 0 && !addedAlready) gatherEscaped(1);
      return sample;
    }
    if (sample.events == 0) recordFirstHit(*collision, sample);
    ++sample.events;

    const FibreFrame frame(collision->tangent);
    const glm::vec3 wo = frame.toLocal(-direction);
    if (lamps) {
      stratify(dimension + kDimensionsPerUse, stratified);
      const auto light = sampleLamp(scene, *path, *collision, sample.events, frame, wo, random, counts);
      if (light) gather(*light);
    }
    if (sample.events >= static_cast<uint32_t>(settings.maxDepth)) return sample;

    const Material& material = scene.cloth->materials[collision->material];
    stratify(dimension + 2 * kDimensionsPerUse, stratified);
    const FibreBcsdf::Sample scattered = lamps ? material.bcsdf->sample(wo, collision->offset, random)
                                               : material.bcsdf->sampleWithoutPdf(wo, collision->offset, random);
    state.travel(collision->material, scattered.length * collision->optics.fibreRadius_mm);
    if (scene.sampling.roulette && sample.events > kRouletteAfter && !state.survives(random)) return sample;
    scatterPdf = scattered.pdf;
    direction = frame.toWorld(scattered.wi);
    path->leave(*collision, direction, scattered.order);
    addedAlready = sample.events == 1 && medium.seesDirectLightApart();
    if (addedAlready) {
      constexpr float kFar = std::numeric_limits<float>::infinity();
      gatherEscaped(path->transmittance(direction, kFar, random, counts));
    }
  }
}

PassResult renderUpTo(uint32_t samples, const Scene& scene, const Medium& medium, const CameraRays& camera, Film& film,
                      const Task& task, uint32_t firstSample) {
  return renderUpTo(samples, scene, medium, camera, film, {0, 0, film.width(), film.height()}, task, firstSample);
}

PassResult renderUpTo(uint32_t samples, const Scene& scene, const Medium& medium, const CameraRays& camera, Film& film,
                      const PixelRect& window, const Task& task, uint32_t firstSample, PathRecords* records) {
  constexpr int kTile = PathRecords::kTile;
  assert(!records || (window.x % kTile == 0 && window.y % kTile == 0));  // no two threads in one of its tiles
  const int columns = (window.width + kTile - 1) / kTile, rows = (window.height + kTile - 1) / kTile;
  std::vector<TraceCounts> tileCounts(static_cast<size_t>(columns) * rows);
  std::atomic<size_t> tilesDone{0};
  parallelFor(tileCounts.size(), task.threads, [&](size_t tile) {
    const int left = window.x + static_cast<int>(tile % columns) * kTile;
    const int top = window.y + static_cast<int>(tile / columns) * kTile;
    const int right = std::min(left + kTile, window.x + window.width);
    const int bottom = std::min(top + kTile, window.y + window.height);
    PathLog log;
    for (int y = top; y < bottom; ++y)
      for (int x = left; x < right; ++x)
        for (uint32_t i = film.samples(x, y); i < samples; ++i) {
          if (task.stopped()) return;
          const bool recorded = records && records->takes(x, y, i);
          log.clear();
          const PathSample sample =
              tracePath(scene, medium, camera, x, y, firstSample + i, tileCounts[tile], recorded ? &log : nullptr);
          film.add(x, y, firstSample + i, sample);
          if (recorded) records->add(x, y, sample.direct + sample.indirect, log);
        }
    task.report(static_cast<double>(++tilesDone) / static_cast<double>(tileCounts.size()));
  });
  if (records) records->settle();
  PassResult result;
  for (const TraceCounts& c : tileCounts) result.counts += c;
  result.complete = !task.stopped();
  return result;
}

uint32_t fewestSamples(const Film& film, const PixelRect& window) {
  uint32_t fewest = Film::maxSamples;
  for (int y = window.y; y < window.y + window.height; ++y)
    for (int x = window.x; x < window.x + window.width; ++x) fewest = std::min(fewest, film.samples(x, y));
  return fewest;
}

}  // namespace loomlight
