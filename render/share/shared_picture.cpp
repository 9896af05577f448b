#include "render/share/shared_picture.h"

#include <algorithm>

#include "core/base/parallel.h"
#include "render/share/seen_fibres.h"

namespace loomlight {

SharedPicture reduced(const SharedPicture& fine, int side) {
  const int width = coarser(fine.width, side), height = coarser(fine.height, side);
  SharedPicture coarse(width, height);
  for (int y = 0; y < fine.height; ++y)
    for (int x = 0; x < fine.width; ++x) {
      const int u = x / side, v = y / side;
      const size_t from = pixelIndex(x, y, fine.width), to = pixelIndex(u, v, width);
      const int pixels = std::min(side, fine.width - u * side) * std::min(side, fine.height - v * side);
      const float share = 1.0f / static_cast<float>(pixels);
      coarse.light[to] += share * fine.light[from];
      coarse.alpha[to] += share * fine.alpha[from];
      coarse.variances[to] += share * (fine.variances[from] + glm::dot(fine.light[from], fine.light[from]));
    }
  for (size_t i = 0; i < coarse.variances.size(); ++i)
    coarse.variances[i] = std::max(0.0f, coarse.variances[i] - glm::dot(coarse.light[i], coarse.light[i]));
  return coarse;
}

SharedPicture sharedPicture(const FirstHits& hits, const CellMeans& means, int threads) {
  SeenFibres seen(hits.width(), hits.height());
  parallelFor(static_cast<size_t>(hits.height()), threads, [&](size_t row) {
    for (int x = 0; x < hits.width(); ++x) {
      const size_t pixel = hits.pixelAt(x, static_cast<int>(row));
      hits.forEachSeen(x, static_cast<int>(row), [&](uint32_t hit) {
        if (FirstHits::isCell(hit))
          seen.meets(pixel, means[hit]);
        else
          seen.misses(pixel, hit == FirstHits::kThrough);
      });
    }
  });
  return seen.picture(threads);
}

}  // namespace loomlight
