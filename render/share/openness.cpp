#include "render/share/openness.h"

#include <algorithm>

#include "core/base/parallel.h"

// How it works. What is around a pixel are all others within a square. Two rays of one pixel differ by the chance that
// is in each, s^2; a pixel and its surroundings by that and by how unlike they are, t^2. What is around is worth s^2 /
// t^2 rays. While hardly any pixel has two rays, both are estimated from blocks of 2 x 2 pixels, or from larger ones
// where these have one ray each as well.

namespace loomlight {
namespace {

void add(ClothRays& sum, const ClothRays& part) {
  sum.in += part.in;
  sum.through += part.through;
}

/// Sums over pixels that s^2 and t^2 are read off.
struct Spread {
  double within = 0, withinFreedom = 0;  ///< squared differences of rays from the mean of their pixel
  double apart2 = 0, chance = 0;         ///< of pixels from what is around them; how many times s^2 is in it by chance
  double pixels = 0;

  void operator+=(const Spread& other) {
    within += other.within;
    withinFreedom += other.withinFreedom;
    apart2 += other.apart2;
    chance += other.chance;
    pixels += other.pixels;
  }
};

}  // namespace

Openness::Openness(std::span<const ClothRays> pixels, int width, int height, int threads)
    : pixels_(pixels), width_(width), height_(height), rows_(pixels.size()) {
  parallelFor(static_cast<size_t>(height), threads, [&](size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < width; ++x)
      for (int u = std::max(0, x - kReach); u <= std::min(width - 1, x + kReach); ++u)
        add(rows_[indexOf(x, y)], pixels[indexOf(u, y)]);
  });
  worth_ = worthOfAround(threads);
}

/// All within reach but the pixel itself.
ClothRays Openness::around(int x, int y) const {
  ClothRays sum;
  for (int v = std::max(0, y - kReach); v <= std::min(height_ - 1, y + kReach); ++v) add(sum, rows_[indexOf(x, v)]);
  const ClothRays& own = pixels_[indexOf(x, y)];
  return {sum.in - own.in, sum.through - own.through};
}

float Openness::worthOfAround(int threads) const {
  std::vector<Spread> rows(static_cast<size_t>(height_));
  parallelFor(rows.size(), threads, [&](size_t row) {
    for (int x = 0; x < width_; ++x) {
      const ClothRays& own = pixels_[indexOf(x, static_cast<int>(row))];
      const ClothRays others = around(x, static_cast<int>(row));
      if (own.in == 0 || others.in == 0) continue;
      const double in = own.in, open = own.through / in;
      const double apart = open - others.through / static_cast<double>(others.in);
      rows[row] += {in * open * (1 - open), in - 1, apart * apart, 1 / in + 1.0 / others.in, 1};
    }
  });
  Spread all;  // row by row, so that they are the same from any number of threads
  for (const Spread& row : rows) all += row;
  constexpr double kEnough = 0.1;  // of the pixels: fewer could tell that no ray differs from another, by chance
  if (all.pixels < 1) return 0;
  if (all.withinFreedom < kEnough * all.pixels) return worthOfBlocks(threads);
  constexpr double kMost = 1000;
  const double within = all.within / all.withinFreedom;
  const double between = std::max(0.0, (all.apart2 - within * all.chance) / all.pixels);
  return static_cast<float>(within < kMost * between ? within / between : kMost);
}

/// As it is of pixels twice as wide, which have several rays where those have one. This ends in a single block at the
/// latest, as that has nothing around it.
float Openness::worthOfBlocks(int threads) const {
  const int width = coarser(width_, 2), height = coarser(height_, 2);
  std::vector<ClothRays> blocks(pixelCount(width, height));
  for (int y = 0; y < height_; ++y)
    for (int x = 0; x < width_; ++x) add(blocks[pixelIndex(x / 2, y / 2, width)], pixels_[indexOf(x, y)]);
  return Openness(blocks, width, height, threads).worthOfAround_rays();
}

float Openness::at(int x, int y) const {
  const ClothRays& own = pixels_[indexOf(x, y)];
  if (own.in == 0) return 0;
  const ClothRays others = around(x, y);
  const float prior = others.in > 0 ? worth_ : 0;
  const float expected = others.in > 0 ? static_cast<float>(others.through) / static_cast<float>(others.in) : 0;
  return (static_cast<float>(own.through) + prior * expected) / (static_cast<float>(own.in) + prior);
}

}  // namespace loomlight
