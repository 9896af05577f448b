#include "render/transport/path_integrator.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <numeric>

#include "core/base/columns.h"
#include "render/scene/thread_shade.h"
#include "render/transport/event_lanes.h"

// How it works. Many paths go on side by side, one event at a time, so that the medium can walk them in vector
// registers: all fly to their next fibre (fly), a lamp is looked for from each (sampleLights), and each fibre sends its
// path on (scatter). For the last two, paths are sorted by the material of their fibres, and go through the fibre's
// optics eight at a time. Light reaches a path in two ways, from a lamp that was looked for and from one that it ran
// into by itself; both count, each by the balance heuristic (Veach 1997). Colour is not known here: a path carries the
// lengths that it has gone inside the fibres of each material, and its sink makes light of them. What a path does is a
// function of its own random numbers alone, whichever others go beside it.
namespace loomlight {
namespace {

constexpr uint32_t kRouletteAfter = 4;  // events

/// Numbers of a path's first events that are stratified: so many each for the flight, the lamp and the fibre. Later
/// events differ too much from path to path to gain.
constexpr uint32_t kStratifiedEvents = 3, kDimensionsPerUse = 8, kDimensionsPerEvent = 3 * kDimensionsPerUse;

/// A mode, in proportion to what each contributes: which way a connection to a lamp leaves the fibre.
int likelyOrder(const FibreBcsdf::Value& value, Random& random) {
  float rest = random.uniform() * value.sum();
  int order = 0;
  while (order + 1 < FibreBcsdf::kModes && (rest -= value.q[order]) >= 0) ++order;
  return order;
}

/// Factor on the absorption of the thread that was met.
float shadeOf(const Collision& at) {
  const float variation = at.optics.shadeVariation;
  return variation > 0 ? shadeFactor(variation, shadeClass(at.yarnId.system, at.yarnId.index)) : 1.0f;
}

/// Balance heuristic (Veach 1997); of one path, or of several side by side.
template <class T>
T misWeight(T own, T other) {
  return own / (own + other);
}

/// How likely a collision looks for a lamp, which costs a walk out of the cloth. The more of the lamp's light the fibre
/// would send on, the likelier, so that no lamp found brings much more than another: narrow modes, met rarely, are what
/// makes pictures noisy. `value`: the sum of Q, 1/sr; the least chance keeps all possible.
template <class T>
T lightSamplingChance(T value) {
  constexpr float kCertain = 0.2f, kLeast = 0.05f;
  return most(broadcast<T>(kLeast), least(value / kCertain, broadcast<T>(1)));
}

/// Calls visit(some items of one material, at most EventLanes::kMost) until all have been; they are sorted by it.
template <class Item, class Material, class Visit>
void forEachEight(std::span<const Item> items, Material&& material, Visit&& visit) {
  for (size_t first = 0; first < items.size();) {
    size_t last = first + 1;
    while (last < items.size() && last - first < EventLanes::kMost && material(items[last]) == material(items[first]))
      ++last;
    visit(items.subspan(first, last - first));
    first = last;
  }
}

}  // namespace

/// Side by side: the values at each offset, and the sums over them.
struct PathIntegrator::LightResponses {
  using Lanes = EventLanes::Lanes;
  std::array<FibreBcsdf::ValueOf<Lanes>, kOffsets> values;
  std::array<Lanes, kOffsets> weighted;  ///< by the balance heuristic; 0 beyond a query's offsets
  Lanes sum{};                           ///< of `weighted`
  Lanes chance{};                        ///< that a lamp is looked for
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
void PathIntegrator::stratify(uint32_t path, uint32_t events, uint32_t use) {
  if (!sampling_.stratified) return;
  const uint32_t dimension = kFirstDimension + events * kDimensionsPerEvent + use * kDimensionsPerUse;
  randomOf(path).stratify(dimension, events < kStratifiedEvents ? kDimensionsPerUse : 0);
}

/// Whether a collision looks for a lamp for sure, and not by chance (lightSamplingChance): the first event is what the
/// eye sees.
bool PathIntegrator::isLampCertain(uint32_t events) const {
  return !sampling_.lampsByChance || events == 1;
}

/// The fibre's radius, times how deeply its thread is dyed.
float PathIntegrator::absorbingRadius_mm(uint32_t path) const {
  const Collision& at = *states_[path].at;
  return at.optics.fibreRadius_mm * shadeOf(at);
}

/// The active paths, so that those whose fibres are of one material stand together.
void PathIntegrator::sortByMaterial() {
  if (materials_ < 2) return;
  std::array<uint32_t, kMaxMaterials + 1> begin{};
  for (const uint32_t path : active_) ++begin[static_cast<size_t>(materialOf(path)) + 1];
  for (size_t k = 1; k <= materials_; ++k) begin[k] += begin[k - 1];
  sorted_.resize(active_.size());
  for (const uint32_t path : active_) sorted_[begin[static_cast<size_t>(materialOf(path))]++] = path;
  active_.swap(sorted_);
}

/// Ends the path at random, the likelier the more of its light has been absorbed; if it goes on, it is as bright as
/// ever. The brightest channel decides: the mean would kill saturated hues.
bool PathIntegrator::survives(uint32_t path, Random& random) {
  float& weight = states_[path].weight;
  const Rgb c = weight * transmittance(scene_.roulette_per_mm, lengths_mm(path));
  const float chance = std::max({c.r, c.g, c.b});
  if (chance >= 1) return true;
  if (random.uniform() >= chance) return false;
  weight /= chance;
  return true;
}

void PathIntegrator::gather(uint32_t path, PathLight light) {
  light.radiance *= states_[path].weight;
  sinkOf(path).gathers(light, lengths_mm(path), states_[path].events);
}

/// What the path finds where it leaves the scene, or would leave it where it is `visible`.
void PathIntegrator::gatherEscaped(uint32_t path, float visible) {
  const State& state = states_[path];
  const Rgb radiance = scene_.lighting->escape(state.direction);
  if (visible == 0 || radiance == Rgb(0)) return;
  const float chance = isLampCertain(state.events) ? 1.0f : lightSamplingChance(state.scatterPdf);
  const float weight = lamps_ ? misWeight(state.scatterPdf, chance * scene_.lighting->pdf(state.direction)) : 1.0f;
  gather(path, {radiance * (weight * visible)});
}

/// What the fibres send on of the light that was looked for.
///
/// Nobody sees where across the fibre a path met it, and narrow modes send the lamp's light on from few of these
/// places: so the light is the mean over several of them (MediumBatch::offsetsAcross), and one of them, chosen in
/// proportion, says how the light goes on, through the fibre and out of it. Each place counts with the weight that it
/// would have alone, since a path that finds the lamp by itself leaves from one place.
PathIntegrator::LightResponses PathIntegrator::evaluate(std::span<const LightQuery> queries) const {
  using Lanes = EventLanes::Lanes;
  const size_t count = queries.size();
  const EventLanes event(count, [&](size_t i) -> const Collision& { return *states_[queries[i].path].at; });
  const Vec3Of<Lanes> wi = columnsOf<Lanes>(count, [&](size_t i) { return queries[i].light.wi; });
  std::array<Lanes, kOffsets> offsets, isOne;
  for (size_t k = 0; k < kOffsets; ++k) {
    offsets[k] = columnOf<Lanes>(count, [&](size_t i) { return queries[i].offsets[k]; });
    isOne[k] = columnOf<Lanes>(count, [&](size_t i) { return k < queries[i].count ? 1.0f : 0.0f; });
  }
  LightResponses responses;
  const auto material = static_cast<size_t>(materialOf(queries[0].path));
  scene_.cloth->materials[material].bcsdf->evaluate(event.wo, event.frame.toLocal(wi), offsets, responses.values);

  const Lanes lightPdf = columnOf<Lanes>(count, [&](size_t i) { return queries[i].light.pdf; });
  const Lanes isDelta = columnOf<Lanes>(count, [&](size_t i) { return queries[i].light.isDelta() ? 1.0f : 0.0f; });
  const Lanes isCertain =
      columnOf<Lanes>(count, [&](size_t i) { return isLampCertain(states_[queries[i].path].events) ? 1.0f : 0.0f; });
  const auto chanceOf = [&](Lanes value) { return isCertain > 0 ? isCertain : lightSamplingChance(value); };
  Lanes pdfs{}, number{};
  for (size_t k = 0; k < kOffsets; ++k) {
    const Lanes pdf = isOne[k] > 0 ? responses.values[k].sum() : Lanes{};
    const Lanes byBoth = pdf * misWeight<Lanes>(chanceOf(pdf) * lightPdf, pdf);
    responses.weighted[k] = ((pdf > 0) & (isDelta == 0)) ? byBoth : pdf;
    pdfs += pdf;
    responses.sum += responses.weighted[k];
    number += isOne[k];
  }
  responses.chance = chanceOf(pdfs / number);
  return responses;
}

/// Of one query: where chance does not leave it, and light may come of it, the shadow ray and what it brings where
/// nothing is in the way.
void PathIntegrator::chooseOffset(const LightQuery& query, const LightResponses& responses, size_t lane,
                                  Random& random) {
  const Collision& at = *states_[query.path].at;
  const float chance = responses.chance[lane], sum = responses.sum[lane];
  if (!(sum > 0) || random.uniform() >= chance) return;
  size_t chosen = 0;
  if (query.count > 1)
    for (float rest = random.uniform() * sum;
         chosen + 1 < query.count && (rest -= responses.weighted[chosen][lane]) >= 0;)
      ++chosen;
  FibreBcsdf::Value value;
  for (size_t mode = 0; mode < value.q.size(); ++mode) value.q[mode] = responses.values[chosen].q[mode][lane];
  if (!(value.sum() > 0)) return;  // rounding chose it
  const Rgb radiance = scene_.lighting->radiance(query.light);
  if (radiance == Rgb(0)) return;
  const float chord = responses.values[chosen].chord_radii[lane];
  const float length_radii = static_cast<float>(likelyOrder(value, random)) * chord;
  if (chosen == 0) {
    medium_->leave(query.path, at, query.light.wi, length_radii);
  } else {
    Collision across = at;
    across.offset = query.offsets[chosen];
    across.axis = axisOf(across);
    medium_->leave(query.path, across, query.light.wi, length_radii);
  }
  shadowRays_.push_back({query.path, query.light.wi, query.light.distance, &random});
  pendingLights_.push_back({radiance, sum / static_cast<float>(query.count), chance * query.light.pdf * value.sum(),
                            PathLight{Rgb(0), value.q, at.material, chord * absorbingRadius_mm(query.path),
                                      responses.values[chosen].internalReflectance[lane]}});
}

/// All active paths fly to their next fibre; those that leave the scene, or have been heard enough of, end.
void PathIntegrator::fly(TraceCounts& counts) {
  pathRays_.clear();
  for (const uint32_t path : active_) {
    stratify(path, states_[path].events, 0);
    pathRays_.push_back({path, states_[path].direction, &randomOf(path)});
  }
  met_.resize(pathRays_.size());
  medium_->collide(pathRays_, met_, counts);
  size_t kept = 0;
  for (size_t i = 0; i < pathRays_.size(); ++i) {
    const uint32_t path = pathRays_[i].path;
    State& state = states_[path];
    if (!met_[i]) {  // what the camera sees past the cloth is the backdrop's affair: alpha
      if (state.events > 0 && !state.addedAlready) gatherEscaped(path, 1);
      end(path, PathEnd::left);
      continue;
    }
    // Only now: what is found in directions that are sampled is a part of the last fibre's light as well.
    if (state.events == sampling_.maxEvents) {
      end(path, PathEnd::deepest);
      continue;
    }
    state.at = &*met_[i];
    ++state.events;
    if (sinkOf(path).meets(*state.at, state.events))
      active_[kept++] = path;
    else
      end(path, PathEnd::stopped);
  }
  active_.resize(kept);
}

void PathIntegrator::sampleLights(TraceCounts& counts) {
  lightQueries_.clear();
  for (const uint32_t path : active_) {
    stratify(path, states_[path].events - 1, 1);
    Random& random = randomOf(path);
    const Collision& at = *states_[path].at;
    const auto light = scene_.lighting->sample(at.place.world, random);
    if (!light || light->pdf <= 0) continue;
    LightQuery& query = lightQueries_.emplace_back(LightQuery{path, *light, {}, 0});
    query.count = static_cast<uint32_t>(medium_->offsetsAcross(path, at, query.offsets, random));
  }
  shadowRays_.clear();
  pendingLights_.clear();
  forEachEight(
      std::span<const LightQuery>(lightQueries_), [&](const LightQuery& query) { return materialOf(query.path); },
      [&](std::span<const LightQuery> eight) {
        const LightResponses responses = evaluate(eight);
        for (size_t lane = 0; lane < eight.size(); ++lane)
          chooseOffset(eight[lane], responses, lane, randomOf(eight[lane].path));
      });
  medium_->transmit(shadowRays_, counts);
  for (size_t i = 0; i < shadowRays_.size(); ++i) {
    const ShadowRay& seen = shadowRays_[i];
    if (seen.visible == 0) continue;
    const PendingLight& found = pendingLights_[i];
    PathLight light = found.light;
    light.radiance = found.radiance * (seen.visible * found.mean / found.divisor);
    gather(seen.path, light);
  }
}

/// The fibres send all active paths on, but for those that end there.
void PathIntegrator::scatter() {
  size_t kept = 0;
  forEachEight(
      std::span<const uint32_t>(active_), [&](uint32_t path) { return materialOf(path); },
      [&](std::span<const uint32_t> eight) {
        const size_t first = kept;
        std::copy(eight.begin(), eight.end(), active_.begin() + static_cast<std::ptrdiff_t>(first));
        kept += scatterEight({&active_[first], eight.size()});
      });
  active_.resize(kept);
}

/// Of one material; those that go on come first, and are counted.
size_t PathIntegrator::scatterEight(std::span<uint32_t> eight) {
  const EventLanes event(eight.size(), [&](size_t i) -> const Collision& { return *states_[eight[i]].at; });
  std::array<Random*, EventLanes::kMost> randoms{};
  for (size_t i = 0; i < eight.size(); ++i) {
    stratify(eight[i], states_[eight[i]].events - 1, 2);
    randoms[i] = &randomOf(eight[i]);
  }
  const auto material = static_cast<size_t>(materialOf(eight[0]));
  RandomLanes<EventLanes::Lanes> random(randoms);
  const auto scattered = scene_.cloth->materials[material].bcsdf->sample(event.wo, event.offset, random, lamps_);
  const auto directions = event.frame.toWorld(scattered.wi);
  size_t kept = 0;
  for (size_t i = 0; i < eight.size(); ++i) {
    const uint32_t path = eight[i];
    State& state = states_[path];
    lengths_mm(path)[material] += scattered.length_radii[i] * absorbingRadius_mm(path);
    if (sampling_.roulette && state.events > kRouletteAfter && !survives(path, *randoms[i])) {
      end(path, PathEnd::roulette);
      continue;
    }
    state.scatterPdf = scattered.pdf[i];
    state.direction = {directions.x[i], directions.y[i], directions.z[i]};
    sinkOf(path).scatters({{scattered.wi.x[i], scattered.wi.y[i], scattered.wi.z[i]},
                           scattered.order[i],
                           scattered.length_radii[i],
                           scattered.pdf[i]},
                          state.direction, state.weight);
    medium_->leave(path, *state.at, state.direction, scattered.length_radii[i]);
    eight[kept++] = path;
  }
  return kept;
}

/// Where the medium sees light apart that comes straight from a lamp to the first fibre: that light.
void PathIntegrator::seeDirectLightApart(TraceCounts& counts) {
  constexpr float kFar = std::numeric_limits<float>::infinity();
  shadowRays_.clear();
  for (const uint32_t path : active_) {
    states_[path].addedAlready = states_[path].events == 1;
    if (states_[path].addedAlready) shadowRays_.push_back({path, states_[path].direction, kFar, &randomOf(path)});
  }
  medium_->transmit(shadowRays_, counts);
  for (const ShadowRay& ray : shadowRays_) gatherEscaped(ray.path, ray.visible);
}

/// The path's place is free for another.
void PathIntegrator::end(uint32_t path, PathEnd why) {
  sinkOf(path).ends(why);
  free_.push_back(path);
}

/// Sends `start` out at a place that is free.
void PathIntegrator::begin(PathStart& start) {
  const uint32_t path = free_.back();
  free_.pop_back();
  states_[path] = {.start = &start, .direction = start.ray.direction};
  std::ranges::fill(lengths_mm(path), 0.0f);
  medium_->begin(path, {start.ray.origin, -1}, start.ray.cone);
  active_.push_back(path);
}

bool PathIntegrator::follow(std::span<PathStart> paths, TraceCounts& counts, const Task* task) {
  active_.clear();
  free_.resize(states_.size());
  std::iota(free_.rbegin(), free_.rend(), 0u);
  counts.paths += paths.size();
  for (size_t next = 0; next < paths.size() || !active_.empty();) {
    if (task && task->stopped()) return false;
    for (; next < paths.size() && !free_.empty(); ++next) begin(paths[next]);
    fly(counts);
    sortByMaterial();
    if (lamps_) sampleLights(counts);
    scatter();
    if (seesDirectLightApart_) seeDirectLightApart(counts);
  }
  return true;
}

void PathIntegrator::follow(const Ray& ray, Random& random, PathSink& sink, TraceCounts& counts) {
  PathStart alone[] = {{ray, random, &sink}};
  follow(alone, counts);
  random = alone[0].random;
}

}  // namespace loomlight
