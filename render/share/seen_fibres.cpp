#include "render/share/seen_fibres.h"

#include <algorithm>

#include "core/base/parallel.h"

// How it works. Each pixel has looked at the cloth once or a few times with nothing but a first hit, and every hit fell
// into a cell whose mean light is known from all paths that began in cells like it. The pixel shows the mean over
// these, as far as it shows cloth; how far their cells differ is told as its variance.

namespace loomlight {

SeenFibres::SeenFibres(int width, int height)
    : width_(width), height_(height), rays_(pixelCount(width, height)), past_(rays_.size()), fibres_(rays_.size()) {}

void SeenFibres::meets(size_t pixel, const CellMeans::Mean& light) {
  ++rays_[pixel].in;
  fibres_[pixel] += light;
}

void SeenFibres::misses(size_t pixel, bool through) {
  rays_[pixel].in += through;
  rays_[pixel].through += through;
  past_[pixel] += !through;
}

/// The mean over the fibres that a pixel shows, or else over those that the pixels around it do.
CellMeans::Mean SeenFibres::fibresNear(int x, int y) const {
  CellMeans::Mean sum;
  uint32_t count = 0;
  for (int reach = 0; reach <= Openness::kReach && count == 0; ++reach)
    for (int v = std::max(0, y - reach); v <= std::min(height_ - 1, y + reach); ++v)
      for (int u = std::max(0, x - reach); u <= std::min(width_ - 1, x + reach); ++u) {
        const size_t i = indexOf(u, v);
        sum += fibres_[i];
        count += rays_[i].in - rays_[i].through;
      }
  const float share = 1.0f / static_cast<float>(std::max(1u, count));
  return {share * sum.colour, share * sum.square};
}

SharedPicture SeenFibres::picture(int threads) const {
  const Openness openness(rays_, width_, height_, threads);
  SharedPicture picture(width_, height_);
  parallelFor(static_cast<size_t>(height_), threads, [&](size_t row) {
    for (int x = 0; x < width_; ++x) {
      const int y = static_cast<int>(row);
      const size_t i = indexOf(x, y);
      const uint32_t in = rays_[i].in;
      if (in == 0) continue;
      const CellMeans::Mean fibres = fibresNear(x, y);
      const float onCloth = static_cast<float>(in) / static_cast<float>(in + past_[i]);
      const float alpha = onCloth * (1 - openness.at(x, y));
      picture.light[i] = alpha * fibres.colour;
      picture.alpha[i] = alpha;
      picture.variances[i] = std::max(0.0f, alpha * fibres.square - glm::dot(picture.light[i], picture.light[i]));
    }
  });
  return picture;
}

}  // namespace loomlight
