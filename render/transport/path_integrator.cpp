#include "render/transport/path_integrator.h"

#include <algorithm>
#include <cassert>
#include <limits>

#include "render/optics/fibre_frame.h"

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

/// Balance heuristic (Veach 1997).
float misWeight(float own, float other) {
  return own / (own + other);
}

}  // namespace

struct PathIntegrator::Event {
  const Collision& at;
  const FibreBcsdf& bcsdf;
  FibreFrame frame;
  glm::vec3 wo;  ///< in the fibre's frame

  Event(const Collision& collision, const Scene& scene)
      : at(collision),
        bcsdf(*scene.cloth->materials[static_cast<size_t>(collision.material)].bcsdf),
        frame(collision.tangent),
        wo(frame.toLocal(-collision.incoming)) {}
};

PathIntegrator::PathIntegrator(const Scene& scene, const Medium& medium, const PathRules& rules)
    : scene_(scene),
      rules_(rules),
      seesDirectLightApart_(medium.seesDirectLightApart()),
      lamps_(scene.lighting->wantsSampling() && (rules.sampling.lamps || scene.lighting->isDelta())),
      materials_(scene.cloth->materials.size()),
      path_(medium.path()) {
  assert(materials_ <= kMaxMaterials);
}

/// How likely a collision looks for a lamp: each look costs a walk out of the cloth. The more of the lamp's light the
/// fibre would send on, the likelier, so that no look brings much more than another: narrow modes, met rarely, are what
/// makes pictures noisy. `value` is the sum of Q, 1/sr; the least chance keeps all possible.
float PathIntegrator::lampChance(float value) const {
  constexpr float kCertain = 0.5f, kLeast = 0.05f;  // of the first event always: it is what the eye sees
  return !rules_.sampling.lampsByChance || events_ == 1 ? 1.0f : std::clamp(value / kCertain, kLeast, 1.0f);
}

/// Ends the path at random, the likelier the more of its light has been absorbed; if it goes on, it is as bright as
/// ever. The brightest channel decides: the mean would kill saturated hues.
bool PathIntegrator::survives(Random& random) {
  const Rgb c = weight_ * attenuation(scene_.roulette_per_mm, lengths_mm());
  const float chance = std::max({c.r, c.g, c.b});
  if (chance >= 1) return true;
  if (random.uniform() >= chance) return false;
  weight_ /= chance;
  return true;
}

void PathIntegrator::gather(PathLight light, PathSink& sink) const {
  light.radiance *= weight_;
  sink.gathers(light, lengths_mm(), events_);
}

/// What the path finds where it leaves the scene, or would leave it where it is `visible`.
void PathIntegrator::gatherEscaped(glm::vec3 direction, float scatterPdf, float visible, PathSink& sink) const {
  const Rgb radiance = scene_.lighting->escape(direction);
  if (visible == 0 || radiance == Rgb(0)) return;
  const float looked = lamps_ ? lampChance(scatterPdf) : 0.0f;
  const float weight = lamps_ ? misWeight(scatterPdf, looked * scene_.lighting->pdf(direction)) : 1.0f;
  gather({radiance * (weight * visible)}, sink);
}

/// One lamp, seen from a collision. Nothing when no light comes of it.
///
/// Nobody sees where across the fibre the path met it, and narrow modes send the lamp's light on from few of these
/// places: so the light is the mean over several of them (MediumPath::offsetsAcross), and one of them, chosen in
/// proportion, says how the light goes on, through the fibre and out of it. Each place counts with the weight that it
/// would have alone, since a path that finds the lamp by itself leaves from one place.
std::optional<PathLight> PathIntegrator::sampleLight(const Event& event, Random& random, TraceCounts& counts) {
  const Collision& at = event.at;
  const auto light = scene_.lighting->sample(at.place.world, random);
  if (!light || light->pdf <= 0) return std::nullopt;
  std::array<float, kOffsets> offsets;
  std::array<FibreBcsdf::Value, kOffsets> values;
  const size_t count = path_->offsetsAcross(at, offsets, random);
  event.bcsdf.evaluate(event.wo, event.frame.toLocal(light->wi), {offsets.data(), count}, {values.data(), count});

  std::array<float, kOffsets> weighted;
  float pdfs = 0, sum = 0;
  for (size_t k = 0; k < count; ++k) {
    const float pdf = values[k].sum();
    weighted[k] = pdf > 0 && !light->delta ? pdf * misWeight(lampChance(pdf) * light->pdf, pdf) : pdf;
    pdfs += pdf;
    sum += weighted[k];
  }
  if (!(sum > 0)) return std::nullopt;
  const float chance = lampChance(pdfs / static_cast<float>(count));
  if (random.uniform() >= chance) return std::nullopt;
  size_t chosen = 0;
  if (count > 1)
    for (float rest = random.uniform() * sum; chosen + 1 < count && (rest -= weighted[chosen]) >= 0;) ++chosen;
  const FibreBcsdf::Value& value = values[chosen];
  if (!(value.sum() > 0)) return std::nullopt;  // rounding chose it
  if (chosen == 0) {
    path_->leave(at, light->wi, likelyOrder(value, random));
  } else {
    Collision across = at;
    across.offset = offsets[chosen];
    across.axis = axisOf(across);
    path_->leave(across, light->wi, likelyOrder(value, random));
  }
  const float visible = path_->transmittance(light->wi, light->distance, random, counts);
  if (visible == 0) return std::nullopt;
  const float mean = sum / static_cast<float>(count);
  const Rgb radiance = light->radiance * (visible * mean / (chance * light->pdf * value.sum()));
  return PathLight{radiance, value.q, at.material, value.chord * at.optics.fibreRadius_mm, value.inside};
}

void PathIntegrator::follow(const Ray& ray, Random& random, PathSink& sink, TraceCounts& counts) {
  std::fill_n(lengths_mm_.begin(), materials_, 0.0f);
  weight_ = 1;
  events_ = 0;
  path_->begin({ray.origin, -1});
  glm::vec3 direction = ray.direction;
  float scatterPdf = 0;
  bool addedAlready = false;  // what this flight may bring straight from a lamp to the first fibre
  ++counts.paths;
  for (uint32_t dimension = kFirstDimension;; dimension += kDimensionsPerEvent) {
    const uint32_t stratified = events_ < kStratifiedEvents ? kDimensionsPerUse : 0;
    const auto stratify = [&](uint32_t use) {
      if (rules_.sampling.stratified) random.stratify(dimension + use * kDimensionsPerUse, stratified);
    };
    stratify(0);
    const auto collision = path_->collide(direction, random, counts);
    if (!collision) {  // what the camera sees past the cloth is the backdrop's affair: alpha
      if (events_ > 0 && !addedAlready) gatherEscaped(direction, scatterPdf, 1, sink);
      return sink.ends(PathEnd::left);
    }
    ++events_;
    if (!sink.meets(*collision, events_)) return sink.ends(PathEnd::stopped);

    const Event event(*collision, scene_);
    if (lamps_) {
      stratify(1);
      if (const auto light = sampleLight(event, random, counts)) gather(*light, sink);
    }
    if (events_ >= rules_.maxEvents) return sink.ends(PathEnd::deepest);

    stratify(2);
    const FibreBcsdf::Sample scattered = lamps_ ? event.bcsdf.sample(event.wo, collision->offset, random)
                                                : event.bcsdf.sampleWithoutPdf(event.wo, collision->offset, random);
    lengths_mm_[static_cast<size_t>(collision->material)] += scattered.length * collision->optics.fibreRadius_mm;
    if (rules_.sampling.roulette && events_ > kRouletteAfter && !survives(random)) return sink.ends(PathEnd::roulette);
    scatterPdf = scattered.pdf;
    direction = event.frame.toWorld(scattered.wi);
    sink.scatters(scattered, direction, weight_);
    path_->leave(*collision, direction, scattered.order);
    addedAlready = events_ == 1 && seesDirectLightApart_;
    if (addedAlready) {
      constexpr float kFar = std::numeric_limits<float>::infinity();
      gatherEscaped(direction, scatterPdf, path_->transmittance(direction, kFar, random, counts), sink);
    }
  }
}

}  // namespace loomlight
