#include "render/share/first_hits.h"

#include <algorithm>
#include <chrono>

#include "core/base/parallel.h"
#include "core/base/stopwatch.h"
#include "render/media/shell_walk.h"
#include "render/scene/camera_rays.h"
#include "render/scene/pixel_filter.h"
#include "render/transport/path_integrator.h"

// How it works. Paths from the eye end at their first fibre; what is kept of one is the number of the cell of light
// that it met. Strips of rows are traced in parallel and only look cells up; cells that are new are added afterwards,
// strip by strip in order, so that their numbers do not depend on the threads.

namespace loomlight {
namespace {

constexpr int kRows = 4;       // of pixels that one thread does at a time
constexpr int kBandRows = 64;  // between looks at the clock

/// Ends every path at its first fibre, and keeps that.
class FirstFibre final : public PathSink {
 public:
  bool meets(const Collision& at, uint32_t) override {
    met_ = at;
    return false;  // it ends there
  }
  void ends(PathEnd why) override { stopped_ = why == PathEnd::stopped; }
  const Collision* met() const { return stopped_ ? &met_ : nullptr; }

 private:
  Collision met_;
  bool stopped_ = false;
};

/// A path of a strip, and what it met.
struct StripHit {
  size_t pixel;
  uint32_t cell;  ///< FirstHits::kNew: the next of the strip's new paths
};

struct Strip {
  std::vector<StripHit> hits;
  std::vector<LightCellPath> fresh;  ///< of cells that are not known yet
};

/// Follows the paths of one strip, batch by batch.
class StripTracer {
 public:
  StripTracer(const Scene& scene, const Medium& medium, const CellSums& cells, const Task& task, Strip& strip)
      : scene_(scene),
        cells_(cells),
        task_(task),
        strip_(strip),
        keys_(scene),
        integrator_(scene, medium, scene.sampling, PathIntegrator::kBatch) {}

  /// False when stopped, as follow().
  bool add(size_t pixel, const Ray& ray, const Random& random) {
    pixels_.push_back(pixel);
    starts_.push_back({ray, random, &firsts_[starts_.size()]});
    return starts_.size() < PathIntegrator::kBatch || follow();
  }

  /// All that were added, to their ends.
  bool follow() {
    if (!integrator_.follow(starts_, counts_, &task_)) return false;
    for (size_t i = 0; i < starts_.size(); ++i) {
      if (const Collision* const met = firsts_[i].met())
        lookUp(pixels_[i], *met, starts_[i].random);
      else
        strip_.hits.push_back({pixels_[i], FirstHits::missed(scene_, starts_[i].ray)});
    }
    starts_.clear();
    pixels_.clear();
    return true;
  }

 private:
  void lookUp(size_t pixel, const Collision& met, Random& random) {
    const float jx = random.uniform(), jy = random.uniform();
    const LightCellPath path = keys_.of(met, glm::vec2(jx, jy) - 0.5f);
    const auto cell = cells_.find(path);
    strip_.hits.push_back({pixel, cell.value_or(FirstHits::kNew)});
    if (!cell) strip_.fresh.push_back(path);
  }

  const Scene& scene_;
  const CellSums& cells_;
  const Task& task_;
  Strip& strip_;
  LightCellKeys keys_;
  TraceCounts counts_;
  PathIntegrator integrator_;
  std::vector<FirstFibre> firsts_ = std::vector<FirstFibre>(PathIntegrator::kBatch);
  std::vector<PathStart> starts_;
  std::vector<size_t> pixels_;  ///< of the paths
};

}  // namespace

FirstHits::FirstHits(int width, int height)
    : width_(width),
      height_(height),
      most_(static_cast<uint32_t>(
          std::clamp<size_t>(kLimit_bytes / sizeof(uint32_t) /
                                 (static_cast<size_t>(std::max(1, width)) * static_cast<size_t>(std::max(1, height))),
                             1, kMost))),
      cells_(static_cast<size_t>(width) * static_cast<size_t>(height) * most_),
      counts_(static_cast<size_t>(width) * static_cast<size_t>(height)) {}

uint32_t FirstHits::missed(const Scene& scene, const Ray& ray) {
  ShellWalk walk(*scene.cloth, {ray.origin, -1}, ray.direction, std::numeric_limits<float>::max());
  return walk.next() ? kThrough : kPast;
}

bool FirstHits::trace(uint32_t perPixel, const Scene& scene, const Medium& medium, CellSums& cells, const Task& task,
                      double budget_s) {
  const auto start = std::chrono::steady_clock::now();
  while (have_ < perPixel) {
    if (nextRow_ == 0) coming_ = perPixel;
    if (!traceBand(scene, medium, cells, task)) return false;
    if (secondsSince(start) > budget_s) break;
  }
  return true;
}

bool FirstHits::traceBand(const Scene& scene, const Medium& medium, CellSums& cells, const Task& task) {
  const int end = std::min(height_, nextRow_ + kBandRows);
  const CameraRays camera(scene.fabric->camera, width_, height_);
  const uint64_t seed = hashCombine(scene.sampling.seed, uint64_t{0xF1257});
  std::vector<Strip> strips(static_cast<size_t>((end - nextRow_ + kRows - 1) / kRows));
  parallelFor(strips.size(), task.threads, [&](size_t number) {
    if (task.stopped()) return;
    StripTracer tracer(scene, medium, cells, task, strips[number]);
    const int top = nextRow_ + static_cast<int>(number) * kRows;
    for (int y = top; y < std::min(end, top + kRows); ++y)
      for (int x = 0; x < width_; ++x)
        for (uint32_t i = have_; i < coming_; ++i) {
          const size_t pixel = pixelAt(x, y);
          if (counts_[pixel] + i - have_ >= most_) break;
          Random random(hashCombine(hashCombine(seed, x), y), i);
          random.stratify(0, PathIntegrator::kFirstDimension);
          const float ux = random.uniform(), uy = random.uniform();
          const glm::vec2 place = glm::vec2(x, y) + TriangleFilter::sample({ux, uy});
          const Ray ray = camera.ray(place.x, place.y);
          if (!tracer.add(pixel, ray, random)) return;
        }
    tracer.follow();
  });
  if (task.stopped()) return false;
  for (const Strip& strip : strips) {
    auto fresh = strip.fresh.begin();
    for (const StripHit& hit : strip.hits) put(hit.pixel, hit.cell == FirstHits::kNew ? cells.add(*fresh++) : hit.cell);
  }
  nextRow_ = end < height_ ? end : 0;
  if (nextRow_ == 0) have_ = coming_;
  return true;
}

}  // namespace loomlight
