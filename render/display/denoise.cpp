#include "render/display/denoise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/base/parallel.h"
#include "core/base/rgb.h"

// How it works. An edge-avoiding a-trous filter (Dammertz et al. 2010) that moves light instead of averaging it. Pixels
// exchange with partners at distances of 1, 2, 4, 2 and 1 pixels: a pair's weight falls with how far its luminances are
// apart, measured in standard deviations of its noise, and is zero across yarns and depths. As each gives what the
// other receives, the picture keeps its light exactly. Variances are carried along, so that every round knows how much
// noise is left. They come from the samples where there are several, and from the pixels around where there is one.

namespace loomlight {
namespace {

/// A pixel's partners in one direction, and the share of a binomial 3 x 3 kernel that they have. The other four
/// directions are these, seen from the partner.
struct Direction {
  int dx, dy;
  float share;
};
constexpr std::array<Direction, 4> kDirections{{{1, 0, 0.125f}, {0, 1, 0.125f}, {1, 1, 0.0625f}, {-1, 1, 0.0625f}}};
/// How far partners are. Back to neighbours in the end, or the pattern of the far ones would be seen.
constexpr int kDistances[] = {1, 2, 4, 2, 1};

/// Differences of so many standard deviations are no noise.
constexpr float kMostDeviations = 3;
/// Of the depth: more than this apart are two folds, or a yarn and what is seen past it.
constexpr float kSameDepth = 0.05f;

// What a pixel shows, where it is no yarn.
constexpr int kNoCloth = -1, kAnyYarn = -2;

class Exchange {
 public:
  Exchange(std::span<glm::vec4> rgba, const PixelTraits& traits, int width, int height, int threads)
      : rgba_(rgba),
        width_(width),
        height_(height),
        threads_(threads),
        luminance_(rgba.size()),
        depth_(rgba.size()),
        variance_(rgba.size()),
        nextVariance_(rgba.size()),
        given_(rgba.size()),
        yarn_(rgba.size()),
        next_(rgba.size()) {
    for (auto& weights : weights_) weights.resize(rgba.size());
    forRows([&](int y) { seeWhatIsShown(traits.hits, y); });
    const std::span<const float> known = traits.variances;
    forRows([&](int y) {
      for (int x = 0; x < width_; ++x) variance_[at(x, y)] = known.empty() ? spread(x, y) : pooled(known, x, y);
    });
  }

  void over(int distance) {
    forRows([&](int y) {
      for (int x = 0; x < width_; ++x) luminance_[at(x, y)] = luminance(Rgb(rgba_[at(x, y)]));
    });
    forRows([&](int y) {
      for (size_t k = 0; k < kDirections.size(); ++k) weigh(k, distance, y);
    });
    forRows([&](int y) { give(distance, y); });
    std::copy(next_.begin(), next_.end(), rgba_.begin());
    std::swap(variance_, nextVariance_);
  }

 private:
  size_t at(int x, int y) const { return pixelIndex(x, y, width_); }

  template <class Body>
  void forRows(Body&& body) const {
    parallelFor(static_cast<size_t>(height_), threads_, [&](size_t row) { body(static_cast<int>(row)); });
  }

  template <class Visit>
  void around(int x, int y, int reach, Visit&& visit) const {
    for (int v = std::max(0, y - reach); v <= std::min(height_ - 1, y + reach); ++v)
      for (int u = std::max(0, x - reach); u <= std::min(width_ - 1, x + reach); ++u) visit(at(u, v));
  }

  /// One sample tells which yarn a pixel shows only where pixels are small beside crossings: there its neighbours have
  /// met the same crossing.
  void seeWhatIsShown(std::span<const Film::Hit> hits, int y) {
    constexpr int kFewestAgree = 4;  // of nine
    for (int x = 0; x < width_; ++x) {
      const Film::Hit& own = hits[at(x, y)];
      int agree = 0;
      around(x, y, 1, [&](size_t other) {
        agree += hits[other].yarn == own.yarn && hits[other].end == own.end && hits[other].pick == own.pick;
      });
      yarn_[at(x, y)] = own.yarn < 0 ? kNoCloth : agree >= kFewestAgree ? own.yarn : kAnyYarn;
      depth_[at(x, y)] = own.depth_mm;
    }
  }

  static bool alike(int a, int b) {
    return (a == b) | ((a == kAnyYarn) & (b != kNoCloth)) | ((b == kAnyYarn) & (a != kNoCloth));
  }

  /// The variance around, which few samples tell better than one pixel's own; but what stands out alone is noise.
  float pooled(std::span<const float> variances, int x, int y) const {
    float sum = 0;
    int count = 0;
    around(x, y, kReach, [&](size_t other) {
      if (!alike(yarn_[at(x, y)], yarn_[other])) return;
      sum += variances[other];
      ++count;
    });
    return std::max(variances[at(x, y)], sum / static_cast<float>(count));
  }

  /// What can be said of the variance of single samples: how far they are from each other, and this one from them.
  float spread(int x, int y) const {
    float sum = 0, squares = 0;
    int count = 0;
    around(x, y, kReach, [&](size_t other) {
      if (!alike(yarn_[at(x, y)], yarn_[other])) return;
      const float l = luminance(Rgb(rgba_[other]));
      sum += l;
      squares += l * l;
      ++count;
    });
    const float mean = sum / static_cast<float>(count), apart = luminance(Rgb(rgba_[at(x, y)])) - mean;
    return std::max(squares / static_cast<float>(count) - mean * mean, apart * apart);
  }

  /// The columns whose partner in a direction is within the picture.
  struct Columns {
    int begin, end;
  };
  Columns columns(int dx) const { return {std::min(width_, std::max(0, -dx)), std::max(0, width_ - std::max(0, dx))}; }

  void weigh(size_t k, int distance, int y) {
    const int dx = kDirections[k].dx * distance, dy = kDirections[k].dy * distance;
    float* const weight = &weights_[k][at(0, y)];
    std::fill_n(weight, width_, 0.0f);
    if (y + dy >= height_) return;
    const size_t own = at(0, y);
    const auto other = static_cast<ptrdiff_t>(at(0, y + dy)) + dx;
    const float *l = &luminance_[own], *v = &variance_[own], *z = &depth_[own];
    const float *ol = luminance_.data(), *ov = variance_.data(), *oz = depth_.data();
    const int *yarn = &yarn_[own], *otherYarn = yarn_.data();
    constexpr float kTiny = 1e-30f;  // without noise nothing is alike, not even equal luminances of other hues
    const Columns range = columns(dx);
    for (int x = range.begin; x < range.end; ++x) {
      const float apart = l[x] - ol[other + x];
      const float most = kMostDeviations * kMostDeviations * (v[x] + ov[other + x]);
      const float rest = std::max(0.0f, 1 - (apart * apart + kTiny) / (most + kTiny));
      const bool near = std::abs(z[x] - oz[other + x]) <= 0.5f * kSameDepth * (z[x] + oz[other + x]);
      weight[x] = (near & alike(yarn[x], otherYarn[other + x])) ? kDirections[k].share * rest * rest : 0.0f;
    }
  }

  /// What the row receives from all its partners, less what it gives them.
  void give(int distance, int y) {
    const size_t own = at(0, y);
    std::copy_n(&rgba_[own], width_, &next_[own]);
    std::fill_n(&nextVariance_[own], width_, 0.0f);
    std::fill_n(&given_[own], width_, 0.0f);
    for (size_t k = 0; k < kDirections.size(); ++k) {
      const int dx = kDirections[k].dx * distance, dy = kDirections[k].dy * distance;
      if (y + dy < height_) receive(y, dx, dy, weights_[k], static_cast<ptrdiff_t>(own), columns(dx));
      if (y - dy >= 0) receive(y, -dx, -dy, weights_[k], static_cast<ptrdiff_t>(at(0, y - dy)) - dx, columns(-dx));
    }
    for (size_t i = own; i < own + static_cast<size_t>(width_); ++i)
      nextVariance_[i] += (1 - given_[i]) * (1 - given_[i]) * variance_[i];
  }

  /// The weight of column x stands at `first` + x.
  void receive(int y, int dx, int dy, const std::vector<float>& weights, ptrdiff_t first, Columns range) {
    const size_t own = at(0, y);
    const auto other = static_cast<ptrdiff_t>(at(0, y + dy)) + dx;
    const glm::vec4 *from = rgba_.data(), *mine = &rgba_[own];
    const float *variance = variance_.data(), *weight = weights.data();
    for (int x = range.begin; x < range.end; ++x) {
      next_[own + static_cast<size_t>(x)] += weight[first + x] * (from[other + x] - mine[x]);
      nextVariance_[own + static_cast<size_t>(x)] += weight[first + x] * weight[first + x] * variance[other + x];
      given_[own + static_cast<size_t>(x)] += weight[first + x];
    }
  }

  static constexpr int kReach = 2;  ///< of the neighbourhood that variances are learnt from

  std::span<glm::vec4> rgba_;
  int width_, height_, threads_;
  std::vector<float> luminance_, depth_, variance_, nextVariance_, given_;
  std::vector<int> yarn_;
  std::vector<glm::vec4> next_;
  std::array<std::vector<float>, kDirections.size()> weights_;  ///< of each pixel with its partner
};

}  // namespace

void denoise(std::span<glm::vec4> rgba, const PixelTraits& traits, int width, int height, int threads) {
  Exchange exchange(rgba, traits, width, height, threads);
  for (const int distance : kDistances) exchange.over(distance);
}

}  // namespace loomlight
