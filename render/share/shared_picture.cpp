#include "render/share/shared_picture.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "render/share/openness.h"

// How it works. Each pixel has looked at the cloth a few times with nothing but a first hit, and every hit fell into a
// cell whose mean light is known from all paths that began in cells like it. The pixel shows the mean over these;
// how far their cells differ is the variance that is left to be blurred. How many rays go through between the fibres is
// known from the pixels around as well.
namespace loomlight {
namespace {

/// What the rays through each pixel met.
class Seen {
 public:
  Seen(const FirstHits& hits, const CellMeans& means, int threads)
      : rays(hits.pixelAt(0, hits.height())), hits_(hits), fibres_(rays.size()) {
    parallelFor(static_cast<size_t>(hits.height()), threads, [&](size_t row) {
      for (int x = 0; x < hits.width(); ++x) {
        const size_t i = hits.pixelAt(x, static_cast<int>(row));
        for (const uint32_t hit : hits.of(x, static_cast<int>(row))) {
          rays[i].in += hit != FirstHits::kPast;
          rays[i].through += hit == FirstHits::kThrough;
          if (FirstHits::isCell(hit)) add(fibres_[i], means[hit]);
        }
      }
    });
  }

  /// The mean over the fibres that a pixel shows, or else over those that the pixels around it do.
  CellMeans::Mean fibresNear(int x, int y) const {
    CellMeans::Mean sum;
    uint32_t count = 0;
    for (int reach = 0; reach <= Openness::kReach && count == 0; ++reach)
      for (int v = std::max(0, y - reach); v <= std::min(hits_.height() - 1, y + reach); ++v)
        for (int u = std::max(0, x - reach); u <= std::min(hits_.width() - 1, x + reach); ++u) {
          const size_t i = hits_.pixelAt(u, v);
          add(sum, fibres_[i]);
          count += rays[i].in - rays[i].through;
        }
    const float share = 1.0f / static_cast<float>(std::max(1u, count));
    return {share * sum.colour, share * sum.square};
  }

  std::vector<ClothRays> rays;  ///< row by row from the top left

 private:
  static void add(CellMeans::Mean& sum, const CellMeans::Mean& part) {
    sum.colour += part.colour;
    sum.square += part.square;
  }

  const FirstHits& hits_;
  std::vector<CellMeans::Mean> fibres_;  ///< sums
};

}  // namespace

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
  const Seen seen(hits, means, threads);
  const Openness openness(seen.rays, hits.width(), hits.height(), threads);
  SharedPicture picture(hits.width(), hits.height());
  parallelFor(static_cast<size_t>(hits.height()), threads, [&](size_t row) {
    for (int x = 0; x < hits.width(); ++x) {
      const int y = static_cast<int>(row);
      const size_t i = hits.pixelAt(x, y);
      const uint32_t in = seen.rays[i].in;
      if (in == 0) continue;
      const CellMeans::Mean fibres = seen.fibresNear(x, y);
      const float onCloth = static_cast<float>(in) / static_cast<float>(hits.of(x, y).size());
      const float alpha = onCloth * (1 - openness.at(x, y));
      picture.light[i] = alpha * fibres.colour;
      picture.alpha[i] = alpha;
      picture.variances[i] = std::max(0.0f, alpha * fibres.square - glm::dot(picture.light[i], picture.light[i]));
    }
  });
  return picture;
}

}  // namespace loomlight
