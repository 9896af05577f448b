#include "render/share/first_hits.h"

#include <algorithm>
#include <chrono>

#include "core/base/parallel.h"
#include "core/base/stopwatch.h"
#include "render/share/first_fibres.h"

// How it works. Of the first fibre of a path (first_fibres.h) the number of its cell of light is kept. Strips of rows
// are traced in parallel and only look cells up; cells that are new are added afterwards, strip by strip in order, so
// that their numbers do not depend on the threads. The first of all are those of every second pixel of every second
// row: a picture of half the resolution is there in a quarter of the time.

namespace loomlight {
namespace {

constexpr int kRows = 4;                             // of pixels that one thread does at a time
constexpr int kBandRows = 64;                        // between looks at the clock
constexpr uint32_t kFirstSample = Film::maxSamples;  // the film's own are below it

/// A path of a strip, and what it met.
struct StripHit {
  int x, y;
  uint32_t cell;  ///< FirstHits::kNew: the next of the strip's new paths
};

struct Strip {
  std::vector<StripHit> hits;
  std::vector<LightCellPath> fresh;  ///< of cells that are not known yet
};

/// The cells that the samples show.
void lookUp(std::span<const PixelSample> samples, FirstFibres& fibres, const CellSums& cells, Strip& strip) {
  for (size_t i = 0; i < samples.size(); ++i) {
    const PixelSample& sample = samples[i];
    const Collision* const fibre = fibres.at(i);
    if (!fibre) {
      strip.hits.push_back({sample.x, sample.y, FirstHits::missed(fibres.isThrough(i))});
      continue;
    }
    const LightCellPath path = fibres.cellsOf(sample, *fibre, cells);
    const auto cell = cells.find(path);
    strip.hits.push_back({sample.x, sample.y, cell.value_or(FirstHits::kNew)});
    if (!cell) strip.fresh.push_back(path);
  }
}

}  // namespace

FirstHits::FirstHits(int width, int height)
    : width_(width),
      height_(height),
      most_(static_cast<uint32_t>(std::clamp<size_t>(
          kLimit_bytes / sizeof(uint32_t) / pixelCount(std::max(1, width), std::max(1, height)), 1, kMost))),
      cells_(pixelCount(width, height) * most_),
      counts_(pixelCount(width, height)) {}

bool FirstHits::trace(uint32_t perPixel, const Scene& scene, const Medium& medium, CellSums& cells, const Task& task,
                      double budget_s) {
  const auto start = std::chrono::steady_clock::now();
  const bool stoodForAll = standForAll(), isHurried = budget_s < std::numeric_limits<double>::infinity();
  while (have_ < perPixel) {
    if (nextRow_ == 0) coming_ = perPixel;
    if (!traceBand(scene, medium, cells, task)) return false;
    const bool isSeenFirst = standForAll() && !stoodForAll;
    if (isHurried && (isSeenFirst || secondsSince(start) > budget_s)) break;
  }
  return true;
}

bool FirstHits::traceBand(const Scene& scene, const Medium& medium, CellSums& cells, const Task& task) {
  const int end = std::min(height_, nextRow_ + kBandRows);
  const bool ofQuarter = !standForAll();
  const int step = ofQuarter ? 2 : 1;
  const uint32_t wanted = ofQuarter ? 1 : coming_;
  const CameraRays camera(scene.fabric->camera, width_, height_);
  std::vector<Strip> strips(static_cast<size_t>((end - nextRow_ + kRows - 1) / kRows));
  parallelFor(strips.size(), task.threads, [&](size_t number) {
    if (task.stopped()) return;
    FirstFibres fibres(scene, medium, camera);
    std::vector<PixelSample> samples;
    const int top = nextRow_ + static_cast<int>(number) * kRows;
    for (int y = top; y < std::min(end, top + kRows); y += step) {
      samples.clear();
      for (int x = 0; x < width_; x += step) {
        const uint32_t has = traced(x, y);
        for (uint32_t i = has; i < std::min(wanted, has + most_ - counts_[pixelAt(x, y)]); ++i)
          samples.push_back({x, y, kFirstSample + i});
      }
      if (!fibres.trace(samples, task)) return;
      lookUp(samples, fibres, cells, strips[number]);
    }
  });
  if (task.stopped()) return false;
  for (const Strip& strip : strips) {
    auto fresh = strip.fresh.begin();
    for (const StripHit& hit : strip.hits)
      put(pixelAt(hit.x, hit.y), hit.cell == FirstHits::kNew ? cells.add(*fresh++) : hit.cell);
  }
  nextRow_ = end < height_ ? end : 0;
  if (nextRow_ > 0) return true;
  if (ofQuarter)
    hasQuarter_ = true;
  else
    have_ = coming_;
  return true;
}

}  // namespace loomlight
