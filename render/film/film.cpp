#include "render/film/film.h"

#include <fmt/core.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/base/memory.h"
#include "core/base/parallel.h"
#include "render/film/fixed_point.h"

// How it works. A sample is rounded to quanta (fixed_point.h) and added to the 128 bytes of integer sums of its
// pixel. Sums of integers do not depend on their order, so the same samples give the same film for any threads,
// tiles and parts, and two films merge by adding. What a pixel shows of yarn and crossing is of its sample with the
// lowest number, which no order changes either. Of n samples with luminances L the mean is sum(L) / n, and its
// variance (mean(L^2) - mean(L)^2) / (n - 1). Cost: a sample touches one pixel, which is two lines of cache; there
// are no locks.

namespace loomlight {
namespace {

constexpr int kMaxId = 1 << 24;  ///< beyond it a float channel no longer holds every integer

int clampId(int id) {
  return std::clamp(id, -1, kMaxId);
}

}  // namespace

Film::Film(int width, int height) : width_(width), height_(height) {
  if (width < 1 || height < 1 || width > kMaxSide || height > kMaxSide)
    throw InputError(fmt::format("a picture of {} x {} pixels: expected 1 to {} a side", width, height, kMaxSide));
  const size_t count = pixelCount(width, height);
  const auto tooLarge = [&] {
    return InputError(fmt::format("a picture of {} x {} pixels needs {:.1f} GB for its sums, more than there is", width,
                                  height, static_cast<double>(count * bytesPerPixel) * 1e-9));
  };
  if (count * bytesPerPixel > physicalMemory_bytes()) throw tooLarge();
  try {
    pixels_.resize(count);
  } catch (const std::bad_alloc&) {
    throw tooLarge();
  }
}

void Film::add(int x, int y, uint32_t sampleIndex, const PathSample& sample) {
  assert(x >= 0 && x < width_ && y >= 0 && y < height_ && sampleIndex < maxSamples);
  Pixel& p = at(x, y);
  glm::dvec3 total;
  for (int c = 0; c < 3; ++c) {
    const int64_t direct = fixedRadiance(sample.direct[c]), indirect = fixedRadiance(sample.indirect[c]);
    p.direct[c] += direct;
    p.indirect[c] += indirect;
    total[c] = static_cast<double>(direct + indirect);
  }
  // From the rounded values, so that mean and second moment speak of the same samples.
  p.luminance2 = saturatingAdd(p.luminance2, fixedSquare(luminanceOf(total)));
  p.events += sample.events;
  ++p.samples;
  if (!(sample.alpha >= 0.5f)) return;

  p.depth += fixedDepth(sample.depth_mm);
  for (int c = 0; c < 3; ++c) {
    p.normal[c] += fixedDirection(sample.normal[c]);
    p.tangent[c] += fixedDirection(sample.tangent[c]);
  }
  if (p.hits == 0 || sampleIndex < p.firstIndex) {
    p.firstIndex = sampleIndex;
    p.yarn = clampId(sample.yarn);
    p.end = clampId(sample.end);
    p.pick = clampId(sample.pick);
    p.hitDepth = sample.depth_mm;
  }
  ++p.hits;
}

void Film::merge(const Film& other, int x, int y) {
  assert(x >= 0 && y >= 0 && other.width_ <= width_ - x && other.height_ <= height_ - y);
  const auto ours = [&](size_t i) -> Pixel& {
    const auto width = static_cast<size_t>(other.width_);
    return at(x + static_cast<int>(i % width), y + static_cast<int>(i / width));
  };
  for (size_t i = 0; i < other.pixels_.size(); ++i) {
    if (ours(i).samples > maxSamples - std::min(maxSamples, other.pixels_[i].samples))
      throw InputError(fmt::format("pictures with together more than {} samples a pixel cannot be merged", maxSamples));
  }
  for (size_t i = 0; i < other.pixels_.size(); ++i) {
    Pixel& p = ours(i);
    const Pixel& q = other.pixels_[i];
    if (q.hits > 0 && (p.hits == 0 || q.firstIndex < p.firstIndex)) {
      p.firstIndex = q.firstIndex;
      p.yarn = q.yarn;
      p.end = q.end;
      p.pick = q.pick;
      p.hitDepth = q.hitDepth;
    }
    for (int c = 0; c < 3; ++c) {
      p.direct[c] += q.direct[c];
      p.indirect[c] += q.indirect[c];
      p.normal[c] += q.normal[c];
      p.tangent[c] += q.tangent[c];
    }
    p.luminance2 = saturatingAdd(p.luminance2, q.luminance2);
    p.depth += q.depth;
    p.events += q.events;
    p.samples += q.samples;
    p.hits += q.hits;
  }
}

Film Film::cropped(const PixelRect& window) const {
  assert(window.x >= 0 && window.y >= 0 && window.width <= width_ - window.x && window.height <= height_ - window.y);
  Film part(window.width, window.height);
  for (int y = 0; y < window.height; ++y) std::copy_n(&at(window.x, window.y + y), window.width, &part.at(0, y));
  return part;
}

uint32_t Film::fewestSamples(const PixelRect& window) const {
  uint32_t fewest = maxSamples;
  for (int y = window.y; y < window.y + window.height; ++y)
    for (int x = window.x; x < window.x + window.width; ++x) fewest = std::min(fewest, samples(x, y));
  return fewest;
}

/// The sum of all samples, in quanta.
glm::dvec3 Film::radiance(const Pixel& p) {
  return glm::dvec3(p.direct[0], p.direct[1], p.direct[2]) + glm::dvec3(p.indirect[0], p.indirect[1], p.indirect[2]);
}

Rgb Film::mean(const Pixel& p) {
  if (p.samples == 0) return Rgb(0);
  return Rgb(radiance(p) * (kRadianceQuantum / p.samples));
}

float Film::variance(const Pixel& p) {
  if (p.samples < 2) return 0;
  if (p.luminance2 == std::numeric_limits<uint64_t>::max()) return std::numeric_limits<float>::infinity();
  const double n = p.samples, mean = luminanceOf(radiance(p)) / n;
  const double meanOfSquares = static_cast<double>(p.luminance2) * kSquareQuantum / n;
  return static_cast<float>(std::max(0.0, meanOfSquares - mean * mean) / (n - 1));
}

Film::Hit Film::hit(const Pixel& p) {
  if (p.hits == 0) return {};
  return {p.yarn, p.end, p.pick, p.hitDepth};
}

float Film::meanDepth_mm(const Pixel& p) {
  return p.hits == 0 ? 0.0f : static_cast<float>(static_cast<double>(p.depth) * kDepthQuantum_mm / p.hits);
}

Rgb Film::mean(int x, int y) const {
  return mean(at(x, y));
}
float Film::variance(int x, int y) const {
  return variance(at(x, y));
}
Film::Hit Film::hit(int x, int y) const {
  return hit(at(x, y));
}
float Film::meanDepth_mm(int x, int y) const {
  return meanDepth_mm(at(x, y));
}

float Film::alpha(int x, int y) const {
  const Pixel& p = at(x, y);
  return p.samples == 0 ? 0.0f : static_cast<float>(static_cast<double>(p.hits) / p.samples);
}

void Film::toDisplayBuffer(std::vector<glm::vec4>& rgba, int threads) const {
  rgba.resize(pixels_.size());
  parallelFor(static_cast<size_t>(height_), threads, [&](size_t row) {
    const int y = static_cast<int>(row);
    glm::vec4* out = &rgba[row * static_cast<size_t>(width_)];
    for (int x = 0; x < width_; ++x) out[x] = glm::vec4(mean(x, y), alpha(x, y));
  });
}

}  // namespace loomlight
