#include "render/transport/path_integrator.h"

#include <algorithm>
#include <cassert>
#include <limits>

#include "render/optics/fibre_frame.h"
#include "render/scene/thread_shade.h"

// How it works. Many paths go on side by side, one event at a time, so that the medium can walk them in vector
// registers: all fly to their next fibre (fly), a lamp is looked for from each (sampleLights), and each fibre sends its
// path on (scatter). Light reaches a path in two ways, from a lamp that was looked for and from one that it ran into by
// itself; both count, each by the balance heuristic (Veach 1997). Colour is not known here: a path carries the lengths
// that it has gone inside the fibres of each material, and its sink makes light of them. What a path does is a function
// of its own random numbers alone, whichever others go beside it.
namespace loomlight {
namespace {

constexpr uint32_t kRouletteAfter = 4;  // events

/// Places across a fibre from which a lamp is looked for at once.
constexpr size_t kOffsets = 4;

/// Numbers of a path's first events that are stratified: so many each for the flight, the lamp and the fibre. Later
/// events differ too much from path to path to gain.
constexpr uint32_t kStratifiedEvents = 3, kDimensionsPerUse = 8, kDimensionsPerEvent = 3 * kDimensionsPerUse;

/// A mode, in proportion to what each contributes: which way a connection to a lamp leaves the fibre.
int likelyOrder(const FibreBcsdf::Value& value, Random& random) {
  float rest = random.uniform() * value.sum();
  int order = 0;
  while (order + 1 < FibreBcsdf::kLobes && (rest -= value.q[order]) >= 0) ++order;
  return order;
}

/// Factor on the absorption of the thread that was met.
float shadeOf(const Collision& at) {
  const float variation = at.optics.shadeVariation;
  return variation > 0 ? shadeFactor(variation, shadeClass(at.yarnId.system, at.yarnId.index)) : 1.0f;
}

/// Balance heuristic (Veach 1997).
float misWeight(float own, float other) {
  return own / (own + other);
}

}  // namespace

struct PathIntegrator::Event {
  const Collision& at;
  const FibreBcsdf& bcsdf;
  FibreFrame frame;
  glm::vec3 wo;    ///< in the fibre's frame
  float depth_mm;  ///< the fibre's radius, times how deeply its thread is dyed

  Event(const Collision& collision, const Scene& scene)
      : at(collision),
        bcsdf(*scene.cloth->materials[static_cast<size_t>(collision.material)].bcsdf),
        frame(collision.tangent),
        wo(frame.toLocal(-collision.incoming)),
        depth_mm(collision.optics.fibreRadius_mm * shadeOf(collision)) {}
};

PathIntegrator::PathIntegrator(const Scene& scene, const Medium& medium, const PathSampling& sampling, size_t most)
    : scene_(scene),
      sampling_(sampling),
      seesDirectLightApart_(medium.seesDirectLightApart()),
      lamps_(scene.lighting->wantsSampling() && (sampling.lamps || scene.lighting->isDelta())),
      materials_(scene.cloth->materials.size()),
      medium_(medium.batch(most)),
      states_(most),
      lengths_mm_(most * materials_) {
  assert(materials_ <= kMaxMaterials && most <= kBatch);
}

/// Of the next `use` (flight, lamp, fibre) of a path that has met so many fibres.
void PathIntegrator::stratify(PathStart& path, uint32_t events, uint32_t use) const {
  if (!sampling_.stratified) return;
  const uint32_t dimension = kFirstDimension + events * kDimensionsPerEvent + use * kDimensionsPerUse;
  path.random.stratify(dimension, events < kStratifiedEvents ? kDimensionsPerUse : 0);
}

/// How likely a collision looks for a lamp: each look costs a walk out of the cloth. The more of the lamp's light the
/// fibre would send on, the likelier, so that no look brings much more than another: narrow modes, met rarely, are what
/// makes pictures noisy. `value` is the sum of Q, 1/sr; the least chance keeps all possible.
float PathIntegrator::lightSamplingProbability(float value, uint32_t events) const {
  constexpr float kCertain = 0.5f, kLeast = 0.05f;  // of the first event always: it is what the eye sees
  return !sampling_.lampsByChance || events == 1 ? 1.0f : std::clamp(value / kCertain, kLeast, 1.0f);
}

/// Ends the path at random, the likelier the more of its light has been absorbed; if it goes on, it is as bright as
/// ever. The brightest channel decides: the mean would kill saturated hues.
bool PathIntegrator::survives(uint32_t path, Random& random) {
  float& weight = states_[path].weight;
  const Rgb c = weight * attenuation(scene_.roulette_per_mm, lengths_mm(path));
  const float chance = std::max({c.r, c.g, c.b});
  if (chance >= 1) return true;
  if (random.uniform() >= chance) return false;
  weight /= chance;
  return true;
}

void PathIntegrator::gather(uint32_t path, PathLight light, PathSink& sink) {
  light.radiance *= states_[path].weight;
  sink.gathers(light, lengths_mm(path), states_[path].events);
}

/// What the path finds where it leaves the scene, or would leave it where it is `visible`.
void PathIntegrator::gatherEscaped(uint32_t path, float visible, PathSink& sink) {
  const State& state = states_[path];
  const Rgb radiance = scene_.lighting->escape(state.direction);
  if (visible == 0 || radiance == Rgb(0)) return;
  const float looked = lamps_ ? lightSamplingProbability(state.scatterPdf, state.events) : 0.0f;
  const float weight = lamps_ ? misWeight(state.scatterPdf, looked * scene_.lighting->pdf(state.direction)) : 1.0f;
  gather(path, {radiance * (weight * visible)}, sink);
}

/// One lamp, looked for from a collision: the shadow ray to it, and what it brings where nothing is in the way. False
/// when no light comes of it.
///
/// Nobody sees where across the fibre the path met it, and narrow modes send the lamp's light on from few of these
/// places: so the light is the mean over several of them (MediumBatch::offsetsAcross), and one of them, chosen in
/// proportion, says how the light goes on, through the fibre and out of it. Each place counts with the weight that it
/// would have alone, since a path that finds the lamp by itself leaves from one place.
bool PathIntegrator::sampleLight(uint32_t path, Random& random, ShadowRay& ray, Lamp& lamp) {
  const State& state = states_[path];
  const Event event(*state.at, scene_);
  const Collision& at = event.at;
  const auto light = scene_.lighting->sample(at.place.world, random);
  if (!light || light->pdf <= 0) return false;
  std::array<float, kOffsets> offsets;
  std::array<FibreBcsdf::Value, kOffsets> values;
  const size_t count = medium_->offsetsAcross(path, at, offsets, random);
  event.bcsdf.evaluate(event.wo, event.frame.toLocal(light->wi), {offsets.data(), count}, {values.data(), count});

  std::array<float, kOffsets> weighted;
  float pdfs = 0, sum = 0;
  for (size_t k = 0; k < count; ++k) {
    const float pdf = values[k].sum();
    weighted[k] = pdf > 0 && !light->isDelta()
                      ? pdf * misWeight(lightSamplingProbability(pdf, state.events) * light->pdf, pdf)
                      : pdf;
    pdfs += pdf;
    sum += weighted[k];
  }
  if (!(sum > 0)) return false;
  const float chance = lightSamplingProbability(pdfs / static_cast<float>(count), state.events);
  if (random.uniform() >= chance) return false;
  size_t chosen = 0;
  if (count > 1)
    for (float rest = random.uniform() * sum; chosen + 1 < count && (rest -= weighted[chosen]) >= 0;) ++chosen;
  const FibreBcsdf::Value& value = values[chosen];
  if (!(value.sum() > 0)) return false;  // rounding chose it
  const Rgb radiance = scene_.lighting->radiance(*light);
  if (radiance == Rgb(0)) return false;
  if (chosen == 0) {
    medium_->leave(path, at, light->wi, likelyOrder(value, random));
  } else {
    Collision across = at;
    across.offset = offsets[chosen];
    across.axis = axisOf(across);
    medium_->leave(path, across, light->wi, likelyOrder(value, random));
  }
  ray = {path, light->wi, light->distance, &random};
  lamp = {radiance, sum / static_cast<float>(count), chance * light->pdf * value.sum(),
          PathLight{Rgb(0), value.q, at.material, value.chord * event.depth_mm, value.inside}};
  return true;
}

/// All active paths fly to their next fibre; those that leave the scene, or have been heard enough of, end.
void PathIntegrator::fly(std::span<PathStart> paths, TraceCounts& counts) {
  pathRays_.clear();
  for (const uint32_t path : active_) {
    stratify(paths[path], states_[path].events, 0);
    pathRays_.push_back({path, states_[path].direction, &paths[path].random});
  }
  met_.resize(pathRays_.size());
  medium_->collide(pathRays_, met_, counts);
  size_t kept = 0;
  for (size_t i = 0; i < pathRays_.size(); ++i) {
    const uint32_t path = pathRays_[i].path;
    State& state = states_[path];
    PathSink& sink = *paths[path].sink;
    if (!met_[i]) {  // what the camera sees past the cloth is the backdrop's affair: alpha
      if (state.events > 0 && !state.addedAlready) gatherEscaped(path, 1, sink);
      sink.ends(PathEnd::left);
      continue;
    }
    state.at = met_[i];
    ++state.events;
    if (sink.meets(*state.at, state.events))
      active_[kept++] = path;
    else
      sink.ends(PathEnd::stopped);
  }
  active_.resize(kept);
}

void PathIntegrator::sampleLights(std::span<PathStart> paths, TraceCounts& counts) {
  shadowRays_.clear();
  lampsFound_.clear();
  ShadowRay ray;
  Lamp lamp;
  for (const uint32_t path : active_) {
    stratify(paths[path], states_[path].events - 1, 1);
    if (!sampleLight(path, paths[path].random, ray, lamp)) continue;
    shadowRays_.push_back(ray);
    lampsFound_.push_back(lamp);
  }
  medium_->transmit(shadowRays_, counts);
  for (size_t i = 0; i < shadowRays_.size(); ++i) {
    const ShadowRay& seen = shadowRays_[i];
    if (seen.visible == 0) continue;
    const Lamp& found = lampsFound_[i];
    PathLight light = found.light;
    light.radiance = found.radiance * (seen.visible * found.mean / found.divisor);
    gather(seen.path, light, *paths[seen.path].sink);
  }
}

/// The fibres send all active paths on, but for those that end there.
void PathIntegrator::scatter(std::span<PathStart> paths) {
  size_t kept = 0;
  for (const uint32_t path : active_) {
    State& state = states_[path];
    PathSink& sink = *paths[path].sink;
    Random& random = paths[path].random;
    if (state.events >= sampling_.maxEvents) {
      sink.ends(PathEnd::deepest);
      continue;
    }
    stratify(paths[path], state.events - 1, 2);
    const Event event(*state.at, scene_);
    const FibreBcsdf::Sample scattered = lamps_ ? event.bcsdf.sample(event.wo, event.at.offset, random)
                                                : event.bcsdf.sampleWithoutPdf(event.wo, event.at.offset, random);
    lengths_mm(path)[static_cast<size_t>(event.at.material)] += scattered.length * event.depth_mm;
    if (sampling_.roulette && state.events > kRouletteAfter && !survives(path, random)) {
      sink.ends(PathEnd::roulette);
      continue;
    }
    state.scatterPdf = scattered.pdf;
    state.direction = event.frame.toWorld(scattered.wi);
    sink.scatters(scattered, state.direction, state.weight);
    medium_->leave(path, event.at, state.direction, scattered.order);
    active_[kept++] = path;
  }
  active_.resize(kept);
}

/// Where the medium sees light apart that comes straight from a lamp to the first fibre: that light.
void PathIntegrator::seeDirectLightApart(std::span<PathStart> paths, TraceCounts& counts) {
  constexpr float kFar = std::numeric_limits<float>::infinity();
  shadowRays_.clear();
  for (const uint32_t path : active_) {
    states_[path].addedAlready = states_[path].events == 1;
    if (states_[path].addedAlready) shadowRays_.push_back({path, states_[path].direction, kFar, &paths[path].random});
  }
  medium_->transmit(shadowRays_, counts);
  for (const ShadowRay& ray : shadowRays_) gatherEscaped(ray.path, ray.visible, *paths[ray.path].sink);
}

bool PathIntegrator::follow(std::span<PathStart> paths, TraceCounts& counts, const Task* task) {
  assert(paths.size() <= states_.size());
  std::fill(lengths_mm_.begin(), lengths_mm_.end(), 0.0f);
  active_.clear();
  for (uint32_t path = 0; path < paths.size(); ++path) {
    states_[path] = {.at = {}, .direction = paths[path].ray.direction};
    medium_->begin(path, {paths[path].ray.origin, -1}, paths[path].ray.cone);
    active_.push_back(path);
  }
  counts.paths += paths.size();
  while (!active_.empty()) {
    if (task && task->stopped()) return false;
    fly(paths, counts);
    if (lamps_) sampleLights(paths, counts);
    scatter(paths);
    if (seesDirectLightApart_) seeDirectLightApart(paths, counts);
  }
  return true;
}

void PathIntegrator::follow(const Ray& ray, Random& random, PathSink& sink, TraceCounts& counts) {
  PathStart alone[] = {{ray, random, &sink}};
  follow(alone, counts);
  random = alone[0].random;
}

}  // namespace loomlight
