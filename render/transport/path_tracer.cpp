#include "render/transport/path_tracer.h"

#include <algorithm>
#include <atomic>
#include <cassert>

#include "core/base/parallel.h"

// How it works. A picture is traced in tiles, each by one thread. A tile sends the next sample of all its pixels
// together through the integrator, until every pixel has what is wanted. Sample i of a pixel draws from a stream that
// depends on (seed, pixel, i) alone, and sums in the film are integers, so neither tiles nor threads show in the
// picture.

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

}  // namespace

TraceCounts& TraceCounts::operator+=(const TraceCounts& other) {
  paths += other.paths;
  events += other.events;
  rays += other.rays;
  steps += other.steps;
  return *this;
}

bool PathTracer::PixelSink::meets(const Collision& at, uint32_t event) {
  if (event == 1) {
    recordFirstHit(at, sample_);
    first_ = at;
  }
  sample_.events = event;
  return !listener_ || listener_->meets(at, event);
}

void PathTracer::PixelSink::gathers(const PathLight& light, std::span<const float> lengths_mm, uint32_t events) {
  (events == 1 ? sample_.direct : sample_.indirect) += colourOf(light, lengths_mm, scene_.colouring);
  if (listener_) listener_->gathers(light, lengths_mm, events);
}

void PathTracer::PixelSink::scatters(const FibreBcsdf::Sample& by, glm::vec3 direction, float weight) {
  if (listener_) listener_->scatters(by, direction, weight);
}

void PathTracer::PixelSink::ends(PathEnd why) {
  if (listener_) listener_->ends(why);
}

PathTracer::PathTracer(const Scene& scene, const Medium& medium, const CameraRays& camera, size_t most)
    : scene_(scene), camera_(camera), integrator_(scene, medium, scene.sampling, most) {}

bool PathTracer::trace(std::span<const PixelSample> wanted, TraceCounts& counts, const Task* task) {
  sinks_.clear();
  starts_.clear();
  for (const PixelSample& of : wanted) sinks_.emplace_back(scene_, of.listener);
  for (size_t i = 0; i < wanted.size(); ++i) {
    const PixelSample& of = wanted[i];
    const uint64_t pixel = hashCombine(hashCombine(hashCombine(scene_.sampling.seed, of.x), of.y), 0);
    Random random(pixel, of.index);
    if (scene_.sampling.stratified) random.stratify(0, PathIntegrator::kFirstDimension);
    const float dx = random.uniform(), dy = random.uniform();
    const Ray ray = camera_.ray(static_cast<float>(of.x) + dx, static_cast<float>(of.y) + dy);
    starts_.push_back({ray, random, &sinks_[i]});
  }
  return integrator_.follow(starts_, counts, task);
}

PathSample tracePath(const Scene& scene, const Medium& medium, const CameraRays& camera, int x, int y, uint32_t index,
                     TraceCounts& counts, PathSink* listener) {
  PathTracer tracer(scene, medium, camera);
  tracer.trace(std::vector<PixelSample>{{x, y, index, listener}}, counts);
  return tracer.sample(0);
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
    PathTracer tracer(scene, medium, camera, static_cast<size_t>((right - left) * (bottom - top)));
    std::vector<PathLog> logs(records ? kTile * kTile : 0);
    std::vector<PixelSample> wanted;
    while (!task.stopped()) {  // the next sample of every pixel that lacks some
      wanted.clear();
      for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x)
          if (const uint32_t next = film.samples(x, y); next < samples) {
            PathLog* log = records && records->takes(x, y, next) ? &logs[wanted.size()] : nullptr;
            if (log) log->clear();
            wanted.push_back({x, y, firstSample + next, log});
          }
      if (wanted.empty()) break;
      if (!tracer.trace(wanted, tileCounts[tile], &task)) return;
      for (size_t i = 0; i < wanted.size(); ++i) {
        const auto& [x, y, index, log] = wanted[i];
        const PathSample& sample = tracer.sample(i);
        film.add(x, y, index, sample);
        if (first) first->sample(tile, x, y, tracer.first(i), sample);
        if (log) records->add(x, y, sample.direct + sample.indirect, *static_cast<const PathLog*>(log));
      }
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
