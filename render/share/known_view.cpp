#include "render/share/known_view.h"

#include <algorithm>
#include <utility>

#include "core/base/parallel.h"
#include "render/scene/camera_rays.h"
#include "render/share/block_gains.h"
#include "render/share/first_hits.h"
#include "render/share/seen_fibres.h"
#include "render/transport/path_tracer.h"

// How it works. A path through each pixel ends at its first fibre. Of the cells that this lies in, the finest that is
// known says what light comes from there, and how much that of single paths varies; how many paths go through between
// the fibres is known from the pixels around as well (seen_fibres.h). A film of fewer pixels, whose paths have found
// the light of this very view, is compared with the mean over so many pixels, block by block (block_gains.h).

namespace loomlight {
namespace {

class EndsAtFirstFibre final : public PathSink {
 public:
  bool meets(const Collision&, uint32_t) override { return false; }
};

}  // namespace

std::optional<KnownView> knownView(const Scene& scene, const Medium& medium, const CellSums& cells, int width,
                                   int height, const Task& task) {
  SeenFibres seen(width, height);
  std::vector<Film::Hit> hits(static_cast<size_t>(width) * static_cast<size_t>(height));
  constexpr int kStripRows = 4;  // that one thread does at a time
  const CellMeans means(cells);
  const CameraRays camera(scene.fabric->camera, width, height);
  parallelFor(static_cast<size_t>((height + kStripRows - 1) / kStripRows), task.threads, [&](size_t strip) {
    if (task.stopped()) return;
    PathTracer tracer(scene, medium, camera, PathIntegrator::kBatch);
    LightCellKeys keys(scene);
    EndsAtFirstFibre end;
    TraceCounts counts;
    std::vector<PixelSample> paths;
    const int top = static_cast<int>(strip) * kStripRows;
    for (int y = top; y < std::min(height, top + kStripRows); ++y)
      for (int x = 0; x < width; ++x) paths.push_back({x, y, 0, &end});
    if (!tracer.trace(paths, counts, &task)) return;
    for (size_t i = 0; i < paths.size(); ++i) {
      const auto& [x, y, index, listener] = paths[i];
      const size_t pixel = static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x);
      const Collision* const first = tracer.first(i);
      if (!first) {
        seen.misses(pixel, FirstHits::missed(scene, tracer.ray(i)) == FirstHits::kThrough);
        continue;
      }
      hits[pixel] = {first->yarn, first->end, first->pick, first->distance_mm};
      Random random(hashCombine(hashCombine(scene.sampling.seed, x), y), 0);
      const float jx = random.uniform(), jy = random.uniform();
      const auto cell = cells.nearest(keys.of(*first, glm::vec2(jx, jy) - 0.5f));
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
      picture.light[row * static_cast<size_t>(picture.width) + static_cast<size_t>(x)] *=
          gains.at((glm::vec2(x, row) + 0.5f) / static_cast<float>(finer));
  });
}

}  // namespace loomlight
