#include "render/share/known_view.h"

#include <algorithm>
#include <utility>

#include "core/base/parallel.h"
#include "render/share/block_gains.h"
#include "render/share/first_fibres.h"
#include "render/share/seen_fibres.h"

// How it works. Each pixel has one path to its first fibre (first_fibres.h). Of the cells that this lies in, the finest
// that is known says what light comes from there, and how much that of single paths varies; how many paths go through
// between the fibres is known from the pixels around as well (seen_fibres.h). A film of fewer pixels, whose paths have
// found the light of this very view, is compared with the mean over so many pixels, block by block (block_gains.h).

namespace loomlight {

std::optional<KnownView> knownView(const Scene& scene, const Medium& medium, const CellSums& cells,
                                   const CameraRays& camera, int width, int height, const Task& task) {
  SeenFibres seen(width, height);
  std::vector<Film::Hit> hits(pixelCount(width, height));
  constexpr int kStripRows = 4;  // that one thread does at a time
  const CellMeans means(cells);
  parallelFor(static_cast<size_t>((height + kStripRows - 1) / kStripRows), task.threads, [&](size_t strip) {
    if (task.stopped()) return;
    FirstFibres fibres(scene, medium, camera);
    std::vector<PixelSample> samples;
    const int top = static_cast<int>(strip) * kStripRows;
    for (int y = top; y < std::min(height, top + kStripRows); ++y)
      for (int x = 0; x < width; ++x) samples.push_back({x, y, 0});
    if (!fibres.trace(samples, task)) return;
    for (size_t i = 0; i < samples.size(); ++i) {
      const PixelSample& sample = samples[i];
      const size_t pixel = pixelIndex(sample.x, sample.y, width);
      const Collision* const fibre = fibres.at(i);
      if (!fibre) {
        seen.misses(pixel, fibres.isThrough(i));
        continue;
      }
      hits[pixel] = {fibre->yarn, fibre->end, fibre->pick, fibre->distance_mm};
      const auto cell = cells.nearest(fibres.cellsOf(sample, *fibre, cells));
      seen.meets(pixel, cell ? means[*cell] : CellMeans::Mean{});
    }
  });
  if (task.stopped()) return std::nullopt;
  return KnownView{seen.picture(task.threads), std::move(hits)};
}

void brightenTo(SharedPicture& picture, const Film& coarse, int finer, int threads) {
  const BlockGains gains(reduced(picture, finer), coarse, {}, threads);
  parallelFor(static_cast<size_t>(picture.height), threads, [&](size_t row) {
    for (int x = 0; x < picture.width; ++x)
      picture.light[pixelIndex(x, static_cast<int>(row), picture.width)] *=
          gains.at((glm::vec2(x, row) + 0.5f) / static_cast<float>(finer));
  });
}

}  // namespace loomlight
