#include "render/display/reframe.h"

#include <algorithm>

#include "core/base/parallel.h"
#include "render/display/resample.h"

namespace loomlight {
namespace {

/// Where the old picture has each column of the new one, and how much of it is seen there.
struct Column {
  Between old, fresh;
  int nearest, freshNearest;  ///< pixels of both
  float share;                ///< of the old
};

std::vector<Column> columnsOf(const Frame& fresh, const Frame& old, int width, float ratio) {
  constexpr float kSoftPixels = 8;
  const float offset = 0.5f * (static_cast<float>(old.width) - ratio * static_cast<float>(width));
  std::vector<Column> columns;
  columns.reserve(static_cast<size_t>(width));
  for (int x = 0; x < width; ++x) {
    const float place = ratio * (static_cast<float>(x) + 0.5f) + offset;  // 0 at the left of the old one
    const float inside = std::min(place, static_cast<float>(old.width) - place);
    const float share = offset >= 0 ? 1.0f : std::clamp(inside / kSoftPixels, 0.0f, 1.0f);
    columns.push_back({Between(x, ratio, offset, old.width),
                       Between(x, 1.0f / static_cast<float>(fresh.divider), 0, fresh.width),
                       std::clamp(static_cast<int>(place), 0, old.width - 1), x / fresh.divider, share});
  }
  return columns;
}

glm::vec4 mixed(std::span<const glm::vec4> fresh, int freshWidth, std::span<const glm::vec4> old, int oldWidth,
                const Column& u, const Between& freshRow, const Between& oldRow) {
  if (u.share == 0) return resampled(fresh, freshWidth, u.fresh, freshRow);
  const glm::vec4 before = resampled(old, oldWidth, u.old, oldRow);
  return u.share == 1 ? before : glm::mix(resampled(fresh, freshWidth, u.fresh, freshRow), before, u.share);
}

const Film::Hit& hitAt(const Frame& frame, int x, int y) {
  return frame.hits[pixelIndex(x, y, frame.width)];
}

}  // namespace

Frame reframed(const Frame& fresh, const Frame& old, int width, int height, int threads) {
  const float ratio = static_cast<float>(old.height) / static_cast<float>(height);
  const std::vector<Column> columns = columnsOf(fresh, old, width, ratio);
  Frame whole;
  whole.width = width;
  whole.height = height;
  whole.window = {0, 0, width, height};
  whole.generation = fresh.generation;
  whole.samples = fresh.samples;
  whole.seconds = fresh.seconds;
  whole.quality = std::min(fresh.quality, old.quality);
  const size_t pixels = pixelCount(width, height);
  whole.rgba.resize(pixels);
  whole.hits.resize(pixels);
  if (!fresh.helped.empty() || !old.helped.empty()) whole.helped.resize(pixels);
  if (!fresh.denoised.empty() && !old.denoised.empty()) whole.denoised.resize(pixels);
  parallelFor(static_cast<size_t>(height), threads, [&](size_t row) {
    const int y = static_cast<int>(row);
    const Between v(y, ratio, 0, old.height), w(y, 1.0f / static_cast<float>(fresh.divider), 0, fresh.height);
    const int nearest = std::min(static_cast<int>(ratio * (static_cast<float>(y) + 0.5f)), old.height - 1);
    size_t i = row * static_cast<size_t>(width);
    for (const Column& u : columns) {
      const auto both = [&](std::span<const glm::vec4> now, std::span<const glm::vec4> then) {
        return mixed(now, fresh.width, then, old.width, u, w, v);
      };
      whole.rgba[i] = both(fresh.rgba, old.rgba);
      if (!whole.helped.empty()) whole.helped[i] = both(fresh.plain(), old.plain());
      if (!whole.denoised.empty()) whole.denoised[i] = both(fresh.denoised, old.denoised);
      whole.hits[i] = u.share > 0.5f ? hitAt(old, u.nearest, nearest) : hitAt(fresh, u.freshNearest, y / fresh.divider);
      ++i;
    }
  });
  return whole;
}

}  // namespace loomlight
