#include "render/metrics/flip.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "core/base/parallel.h"
#include "render/colour/colour_space.h"
#include "render/metrics/flip_kernels.h"

// How it works (Andersson et al. 2020). Both pictures are blurred by the eye's contrast sensitivity in an opponent
// colour space, and compared by the HyAB distance of their Hunt-adjusted colours. Edges and points are found in the
// luminance by first and second derivatives of a Gaussian; where they differ the error of the colour is raised towards
// 1: error = colour^(1 - feature). All filters are separable. The picture is done in tiles with a margin as wide as the
// widest filter, side by side.

namespace loomlight {
namespace {

constexpr int kTile = 128;  ///< pixels a side: its planes stay in the second-level cache

using Plane = std::vector<float>;

/// A rectangle of the picture, with a margin that the filters need.
struct Tile {
  int x0, y0, width, height, margin;
  int stride() const { return width + 2 * margin; }
  int rows() const { return height + 2 * margin; }
  size_t inner() const { return static_cast<size_t>(width) * static_cast<size_t>(height); }
};

/// Luminance, red against green, blue against yellow: (Y, X - Y, Y - Z) over white. The paper's Y Cx Cz are these but
/// for factors and offsets, which no filter of unit sum minds.
struct Opponent {
  Plane luminance, redGreen, blueYellow;
};

/// With the margin; beyond the picture its border goes on.
Opponent opponentOf(const LinearPicture& picture, const Tile& tile, double exposure) {
  const size_t count = static_cast<size_t>(tile.stride()) * static_cast<size_t>(tile.rows());
  Opponent planes{Plane(count), Plane(count), Plane(count)};
  size_t i = 0;
  for (int row = 0; row < tile.rows(); ++row) {
    const int y = std::clamp(tile.y0 - tile.margin + row, 0, picture.height - 1);
    const Rgb* const pixels = &picture.pixels[static_cast<size_t>(y) * static_cast<size_t>(picture.width)];
    for (int column = 0; column < tile.stride(); ++column, ++i) {
      const int x = std::clamp(tile.x0 - tile.margin + column, 0, picture.width - 1);
      const glm::dvec3 shown = glm::clamp(glm::dvec3(pixels[x]) * exposure, 0.0, 1.0);
      const glm::dvec3 xyz = whiteXyzFromLinear(shown);
      planes.luminance[i] = static_cast<float>(xyz.y);
      planes.redGreen[i] = static_cast<float>(xyz.x - xyz.y);
      planes.blueYellow[i] = static_cast<float>(xyz.y - xyz.z);
    }
  }
  return planes;
}

/// Correlates a plane with alongX times alongY; without the margin.
Plane filtered(const Plane& in, const Tile& tile, const Kernel& alongX, const Kernel& alongY) {
  const int radiusX = radiusOf(alongX), radiusY = radiusOf(alongY);
  const auto width = static_cast<size_t>(tile.width);
  Plane across(width * static_cast<size_t>(tile.height + 2 * radiusY), 0.0f), out(tile.inner(), 0.0f);
  for (int row = 0; row < tile.height + 2 * radiusY; ++row) {
    const float* from = &in[static_cast<size_t>(row + tile.margin - radiusY) * static_cast<size_t>(tile.stride()) +
                            static_cast<size_t>(tile.margin - radiusX)];
    float* const to = &across[static_cast<size_t>(row) * width];
    for (size_t k = 0; k < alongX.size(); ++k, ++from)
      for (size_t x = 0; x < width; ++x) to[x] += alongX[k] * from[x];
  }
  for (int row = 0; row < tile.height; ++row) {
    float* const to = &out[static_cast<size_t>(row) * width];
    for (size_t k = 0; k < alongY.size(); ++k) {
      const float* const from = &across[(static_cast<size_t>(row) + k) * width];
      for (size_t x = 0; x < width; ++x) to[x] += alongY[k] * from[x];
    }
  }
  return out;
}

/// L* and the chromatic plane, shrunk in the dark, where colours look less colourful (Hunt).
Lab huntAdjusted(Lab lab) {
  lab.a *= 0.01 * lab.L;
  lab.b *= 0.01 * lab.L;
  return lab;
}

/// Distance of Abasi et al. 2020: lightness and colour are added as an eye adds them where differences are large.
double hyab(const Lab& one, const Lab& other) {
  return std::abs(one.L - other.L) + std::hypot(one.a - other.a, one.b - other.b);
}

/// As an eye sees it, blurred by its contrast sensitivity.
std::vector<Lab> perceived(const Opponent& planes, const Tile& tile, const FlipKernels& kernels) {
  const Plane luminance = filtered(planes.luminance, tile, kernels.achromatic, kernels.achromatic);
  const Plane redGreen = filtered(planes.redGreen, tile, kernels.redGreen, kernels.redGreen);
  std::array<Plane, 2> blueYellow;
  for (size_t i = 0; i < 2; ++i)
    blueYellow[i] = filtered(planes.blueYellow, tile, kernels.blueYellow[i].kernel, kernels.blueYellow[i].kernel);
  std::vector<Lab> colours(tile.inner());
  for (size_t i = 0; i < colours.size(); ++i) {
    const double y = luminance[i];
    const double by = kernels.blueYellow[0].weight * blueYellow[0][i] + kernels.blueYellow[1].weight * blueYellow[1][i];
    const glm::dvec3 linear = glm::clamp(linearFromWhiteXyz({y + redGreen[i], y, y - by}), 0.0, 1.0);
    colours[i] = huntAdjusted(labFromLinear(linear));
  }
  return colours;
}

/// Strength of the edges, or points, that a detector along x and one along y find.
Plane strength(const Plane& luminance, const Tile& tile, const Kernel& detector, const Kernel& smooth) {
  Plane x = filtered(luminance, tile, detector, smooth);
  const Plane y = filtered(luminance, tile, smooth, detector);
  for (size_t i = 0; i < x.size(); ++i) x[i] = std::hypot(x[i], y[i]);
  return x;
}

/// To [0, 1]: small differences, which tell more, take 0.95 of it.
class ColourScale {
 public:
  ColourScale()
      : largest_(power(hyab(huntAdjusted(labFromLinear({0, 1, 0})), huntAdjusted(labFromLinear({0, 0, 1}))))),
        bend_(0.4 * largest_) {}

  double operator()(double distance) const {
    const double d = power(distance);
    const double scaled = d < bend_ ? kAtBend * d / bend_ : kAtBend + (1 - kAtBend) * (d - bend_) / (largest_ - bend_);
    return std::min(scaled, 1.0);
  }

 private:
  static constexpr double kAtBend = 0.95;
  static double power(double distance) { return std::pow(distance, 0.7); }

  double largest_;  ///< between green and blue, the two colours of the display farthest apart
  double bend_;
};

}  // namespace

std::vector<float> flip(const LinearPicture& one, const LinearPicture& other, const Viewing& viewing, int threads) {
  assert(one.width == other.width && one.height == other.height);
  const FlipKernels kernels(viewing.pixelsPerDegree);
  const ColourScale scale;
  const double exposure = std::exp2(viewing.exposure_stops);
  const int tilesX = (one.width + kTile - 1) / kTile, tilesY = (one.height + kTile - 1) / kTile;
  std::vector<float> map(one.pixels.size());

  parallelFor(static_cast<size_t>(tilesX) * static_cast<size_t>(tilesY), threads, [&](size_t index) {
    const int x0 = static_cast<int>(index) % tilesX * kTile, y0 = static_cast<int>(index) / tilesX * kTile;
    const Tile tile{x0, y0, std::min(kTile, one.width - x0), std::min(kTile, one.height - y0), kernels.radius};
    const Opponent a = opponentOf(one, tile, exposure), b = opponentOf(other, tile, exposure);
    const std::vector<Lab> colourA = perceived(a, tile, kernels), colourB = perceived(b, tile, kernels);
    const Plane edgeA = strength(a.luminance, tile, kernels.edge, kernels.smooth),
                edgeB = strength(b.luminance, tile, kernels.edge, kernels.smooth),
                pointA = strength(a.luminance, tile, kernels.point, kernels.smooth),
                pointB = strength(b.luminance, tile, kernels.point, kernels.smooth);
    for (size_t i = 0; i < tile.inner(); ++i) {
      const double colour = scale(hyab(colourA[i], colourB[i]));
      const double difference = std::max(std::abs(edgeA[i] - edgeB[i]), std::abs(pointA[i] - pointB[i]));
      const double feature = std::min(std::sqrt(difference / std::sqrt(2.0)), 1.0);
      const size_t x = static_cast<size_t>(x0) + i % static_cast<size_t>(tile.width),
                   y = static_cast<size_t>(y0) + i / static_cast<size_t>(tile.width);
      // Without any difference of colour there is none at all, whatever the features: 0^0 would be 1.
      const double error = colour > 0 ? std::pow(colour, 1 - feature) : 0;
      map[y * static_cast<size_t>(one.width) + x] = static_cast<float>(error);
    }
  });
  return map;
}

}  // namespace loomlight
