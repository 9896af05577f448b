#include "render/share/shared_picture.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"

// How it works. Each pixel has looked at the cloth a few times with nothing but a first hit, and every hit fell into a
// cell whose mean light is known from all paths that began in cells like it. The pixel shows the mean over its hits;
// how far their cells differ is the variance that is left to be blurred.
namespace loomlight {

SharedPicture reduced(const SharedPicture& fine, int side) {
  const int width = (fine.width + side - 1) / side, height = (fine.height + side - 1) / side;
  SharedPicture coarse(width, height);
  for (int y = 0; y < fine.height; ++y)
    for (int x = 0; x < fine.width; ++x) {
      const int u = x / side, v = y / side;
      const size_t from = static_cast<size_t>(y) * static_cast<size_t>(fine.width) + static_cast<size_t>(x);
      const size_t to = static_cast<size_t>(v) * static_cast<size_t>(width) + static_cast<size_t>(u);
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
  SharedPicture picture(hits.width(), hits.height());
  parallelFor(static_cast<size_t>(hits.height()), threads, [&](size_t row) {
    for (int x = 0; x < hits.width(); ++x) {
      CellMeans::Mean sum;
      float alpha = 0;
      const std::span<const uint32_t> cells = hits.of(x, static_cast<int>(row));
      for (const uint32_t cell : cells) {
        if (cell == FirstHits::kPast) continue;
        alpha += 1;
        sum.colour += means[cell].colour;
        sum.square += means[cell].square;
      }
      const float share = 1.0f / static_cast<float>(std::max<size_t>(1, cells.size()));
      const size_t i = hits.pixelAt(x, static_cast<int>(row));
      const Rgb mean = share * sum.colour;
      picture.light[i] = mean;
      picture.alpha[i] = share * alpha;
      picture.variances[i] = std::max(0.0f, share * sum.square - glm::dot(mean, mean));
    }
  });
  return picture;
}

}  // namespace loomlight
