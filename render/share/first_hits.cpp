#include "render/share/first_hits.h"

#include <algorithm>
#include <atomic>

#include "core/base/parallel.h"
#include "render/scene/camera_rays.h"
#include "render/transport/path_integrator.h"

// How it works. Paths from the eye end at their first fibre; what is kept of one is the number of the cell of light
// that it met. Strips of rows are traced in parallel and only look cells up; cells that are new are added afterwards,
// strip by strip in order, so that their numbers do not depend on the threads.

namespace loomlight {
namespace {

constexpr int kRows = 4;  // of pixels that one thread does at a time

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

bool FirstHits::trace(uint32_t perPixel, const Scene& scene, const Medium& medium, CellSums& cells, const Task& task) {
  if (perPixel <= have_) return true;
  struct Hit {
    size_t pixel;
    uint32_t cell;  ///< kNew: the next of the strip's new paths
  };
  struct Strip {
    std::vector<Hit> hits;
    std::vector<LightCellPath> fresh;
  };
  constexpr uint32_t kNew = kPast - 1;
  const CameraRays camera(scene.fabric->camera, width_, height_);
  const uint64_t seed = hashCombine(scene.sampling.seed, uint64_t{0xF1257});
  std::vector<Strip> strips(static_cast<size_t>((height_ + kRows - 1) / kRows));
  parallelFor(strips.size(), task.threads, [&](size_t number) {
    if (task.stopped()) return;
    Strip& strip = strips[number];
    LightCellKeys keys(scene);
    TraceCounts counts;
    PathIntegrator integrator(scene, medium, scene.sampling, PathIntegrator::kBatch);
    std::vector<FirstFibre> firsts(PathIntegrator::kBatch);
    std::vector<PathStart> starts;
    std::vector<size_t> pixels;  // of the paths
    const auto follow = [&] {
      if (!integrator.follow(starts, counts, &task)) return false;
      for (size_t i = 0; i < starts.size(); ++i) {
        if (!firsts[i].met()) {
          strip.hits.push_back({pixels[i], kPast});
          continue;
        }
        Random& random = starts[i].random;
        const float jx = random.uniform(), jy = random.uniform();
        const LightCellPath path = keys.of(*firsts[i].met(), glm::vec2(jx, jy) - 0.5f);
        const auto cell = cells.find(path);
        strip.hits.push_back({pixels[i], cell.value_or(kNew)});
        if (!cell) strip.fresh.push_back(path);
      }
      starts.clear();
      pixels.clear();
      return true;
    };
    const int top = static_cast<int>(number) * kRows;
    for (int y = top; y < std::min(height_, top + kRows); ++y)
      for (int x = 0; x < width_; ++x)
        for (uint32_t i = have_; i < perPixel; ++i) {
          const size_t pixel = pixelAt(x, y);
          if (counts_[pixel] + i - have_ >= most_) break;
          Random random(hashCombine(hashCombine(seed, x), y), i);
          random.stratify(0, PathIntegrator::kFirstDimension);
          const float dx = random.uniform(), dy = random.uniform();
          pixels.push_back(pixel);
          starts.push_back(
              {camera.ray(static_cast<float>(x) + dx, static_cast<float>(y) + dy), random, &firsts[starts.size()]});
          if (starts.size() == PathIntegrator::kBatch && !follow()) return;
        }
    follow();
  });
  if (task.stopped()) return false;
  for (const Strip& strip : strips) {
    auto fresh = strip.fresh.begin();
    for (const Hit& hit : strip.hits) put(hit.pixel, hit.cell == kNew ? cells.add(*fresh++) : hit.cell);
  }
  have_ = perPixel;
  return true;
}

}  // namespace loomlight
