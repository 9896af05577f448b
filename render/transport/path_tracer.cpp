#include "render/transport/path_tracer.h"

#include <algorithm>
#include <atomic>
#include <cassert>

#include "core/base/parallel.h"
#include "render/scene/pixel_filter.h"

// How it works. A picture is traced in blocks, each by one thread. It sends samples of all pixels of its block through
// the integrator, some thousand at a time, so that as many paths are under way as it takes, until every pixel has what
// is wanted. Sample i of a pixel draws from a stream that depends on (seed, pixel, i) alone, and sums in the film are
// integers, so neither blocks nor threads show in the picture.

namespace loomlight {
namespace {

/// Paths that a thread follows before it looks at the film again: many more than are under way at once.
constexpr size_t kAtATime = 4 * PathIntegrator::kBatch;

/// The parts of a window that threads take: squares of two tiles a side, or of one where there are few. They do not
/// depend on how many threads there are.
class Blocks {
 public:
  explicit Blocks(const PixelRect& window) : window_(window) {
    constexpr int kMany = 256;  // tiles
    constexpr int kTile = PathRecords::kTile;
    const bool many = window.width * window.height >= kMany * kTile * kTile;
    side_ = many ? 2 * kTile : kTile;
    columns_ = (window.width + side_ - 1) / side_;
    rows_ = (window.height + side_ - 1) / side_;
  }
  size_t count() const { return static_cast<size_t>(columns_) * static_cast<size_t>(rows_); }
  PixelRect block(size_t number) const {
    const int left = static_cast<int>(number) % columns_ * side_, top = static_cast<int>(number) / columns_ * side_;
    return {window_.x + left, window_.y + top, std::min(side_, window_.width - left),
            std::min(side_, window_.height - top)};
  }

 private:
  PixelRect window_;
  int side_, columns_, rows_;
};

/// The samples that pixels lack, the next ones first, at most `most` of a pixel.
void listMissing(const PixelRect& block, const Film& film, uint32_t samples, uint32_t most,
                 std::vector<PixelSample>& missing) {
  missing.clear();
  size_t before = 0;
  for (uint32_t beyond = 0; beyond < most && missing.size() < kAtATime; ++beyond) {
    for (int y = block.y; y < block.y + block.height; ++y)
      for (int x = block.x; x < block.x + block.width; ++x)
        if (const uint32_t next = film.samples(x, y) + beyond; next < samples) missing.push_back({x, y, next, nullptr});
    if (missing.size() == before) return;
    before = missing.size();
  }
}

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
    const float ux = random.uniform(), uy = random.uniform();
    const glm::vec2 place = glm::vec2(of.x, of.y) + TriangleFilter::sample({ux, uy});
    const Ray ray = camera_.ray(place.x, place.y);
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
                      const Task& task, const PassOptions& options) {
  const PixelRect window = options.window.value_or(PixelRect{0, 0, film.width(), film.height()});
  PathRecords* const records = options.records;
  FirstFibreSink* const first = options.first;
  // No two threads in one tile of the records.
  assert(!records || (window.x % PathRecords::kTile == 0 && window.y % PathRecords::kTile == 0));
  const Blocks blocks(window);
  std::vector<TraceCounts> counts(blocks.count());
  std::atomic<size_t> done{0};
  if (first) first->begin(blocks.count());
  parallelFor(blocks.count(), task.threads, [&](size_t number) {
    const PixelRect block = blocks.block(number);
    PathTracer tracer(scene, medium, camera, PathIntegrator::kBatch);
    std::vector<PathLog> logs;
    std::vector<PixelSample> wanted;
    const uint32_t most = records ? 1 : samples;  // of a pixel: records are kept one after the other
    while (!task.stopped()) {
      listMissing(block, film, samples, most, wanted);
      if (wanted.empty()) break;
      if (records) logs.resize(wanted.size());
      for (size_t i = 0; i < wanted.size(); ++i) {
        PixelSample& next = wanted[i];
        if (records && records->takes(next.x, next.y, next.index)) {
          logs[i].clear();
          next.listener = &logs[i];
        }
        next.index += options.firstSample;
      }
      if (!tracer.trace(wanted, counts[number], &task)) return;
      for (size_t i = 0; i < wanted.size(); ++i) {
        const auto& [x, y, index, listener] = wanted[i];
        const PathSample& sample = tracer.sample(i);
        film.add(x, y, index, sample);
        if (first) first->sample(number, x, y, tracer.ray(i), tracer.first(i), sample);
        if (listener) records->add(x, y, sample.direct + sample.indirect, logs[i]);
      }
    }
    task.report(static_cast<double>(++done) / static_cast<double>(blocks.count()));
  });
  if (records) records->settle();
  PassResult result;
  for (const TraceCounts& c : counts) result.counts += c;
  result.complete = !task.stopped();
  return result;
}

}  // namespace loomlight
