#include "render/transport/path_tracer.h"

#include <algorithm>
#include <atomic>
#include <cassert>

#include "core/base/parallel.h"

namespace loomlight {
namespace {

void recordFirstHit(const Collision& at, PathSample& sample) {
  sample.alpha = 1;
  sample.depth_mm = at.distance_mm;
  sample.normal = at.normal;
  sample.tangent = at.tangent;
  sample.yarn = at.yarn;
  sample.end = at.end;
  sample.pick = at.pick;
}

/// Makes the sample of a pixel; colours light as it comes.
class PixelSink final : public PathSink {
 public:
  PixelSink(const Scene& scene, Collision& first, PathSink* listener)
      : scene_(scene), first_(first), listener_(listener) {}

  bool meets(const Collision& at, uint32_t event) override {
    if (event == 1) {
      recordFirstHit(at, sample_);
      first_ = at;
    }
    sample_.events = event;
    return !listener_ || listener_->meets(at, event);
  }
  void gathers(const PathLight& light, std::span<const float> lengths_mm, uint32_t events) override {
    (events == 1 ? sample_.direct : sample_.indirect) += colourOf(light, lengths_mm, scene_.absorption_per_mm);
    if (listener_) listener_->gathers(light, lengths_mm, events);
  }
  void scatters(const FibreBcsdf::Sample& by, glm::vec3 direction, float weight) override {
    if (listener_) listener_->scatters(by, direction, weight);
  }
  void ends(PathEnd why) override {
    if (listener_) listener_->ends(why);
  }
  const PathSample& sample() const { return sample_; }

 private:
  const Scene& scene_;
  Collision& first_;
  PathSink* listener_;
  PathSample sample_;
};

}  // namespace

TraceCounts& TraceCounts::operator+=(const TraceCounts& other) {
  paths += other.paths;
  events += other.events;
  rays += other.rays;
  steps += other.steps;
  return *this;
}

PathTracer::PathTracer(const Scene& scene, const Medium& medium, const CameraRays& camera)
    : scene_(scene), camera_(camera), integrator_(scene, medium, PathRules::of(scene)) {}

PathSample PathTracer::trace(int x, int y, uint32_t index, TraceCounts& counts, PathSink* listener) {
  Random random(hashCombine(hashCombine(hashCombine(scene_.fabric->render.seed, x), y), 0), index);
  if (scene_.sampling.stratified) random.stratify(0, PathIntegrator::kFirstDimension);
  const float dx = random.uniform(), dy = random.uniform();
  PixelSink sink(scene_, first_, listener);
  integrator_.follow(camera_.ray(static_cast<float>(x) + dx, static_cast<float>(y) + dy), random, sink, counts);
  return sink.sample();
}

PathSample tracePath(const Scene& scene, const Medium& medium, const CameraRays& camera, int x, int y, uint32_t index,
                     TraceCounts& counts, PathSink* listener) {
  return PathTracer(scene, medium, camera).trace(x, y, index, counts, listener);
}

PassResult renderUpTo(uint32_t samples, const Scene& scene, const Medium& medium, const CameraRays& camera, Film& film,
                      const Task& task, uint32_t firstSample) {
  return renderUpTo(samples, scene, medium, camera, film, {0, 0, film.width(), film.height()}, task, firstSample);
}

PassResult renderUpTo(uint32_t samples, const Scene& scene, const Medium& medium, const CameraRays& camera, Film& film,
                      const PixelRect& window, const Task& task, uint32_t firstSample, PathRecords* records,
                      FirstFibreSink* first) {
  constexpr int kTile = PathRecords::kTile;
  assert(!records || (window.x % kTile == 0 && window.y % kTile == 0));  // no two threads in one of its tiles
  const int columns = (window.width + kTile - 1) / kTile, rows = (window.height + kTile - 1) / kTile;
  std::vector<TraceCounts> tileCounts(static_cast<size_t>(columns) * rows);
  std::atomic<size_t> tilesDone{0};
  if (first) first->begin(tileCounts.size());
  parallelFor(tileCounts.size(), task.threads, [&](size_t tile) {
    const int left = window.x + static_cast<int>(tile % columns) * kTile;
    const int top = window.y + static_cast<int>(tile / columns) * kTile;
    const int right = std::min(left + kTile, window.x + window.width);
    const int bottom = std::min(top + kTile, window.y + window.height);
    PathLog log;
    PathTracer tracer(scene, medium, camera);
    for (int y = top; y < bottom; ++y)
      for (int x = left; x < right; ++x)
        for (uint32_t i = film.samples(x, y); i < samples; ++i) {
          if (task.stopped()) return;
          const bool recorded = records && records->takes(x, y, i);
          log.clear();
          const PathSample sample = tracer.trace(x, y, firstSample + i, tileCounts[tile], recorded ? &log : nullptr);
          film.add(x, y, firstSample + i, sample);
          if (first) first->sample(tile, x, y, sample.alpha > 0 ? &tracer.first() : nullptr, sample);
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
