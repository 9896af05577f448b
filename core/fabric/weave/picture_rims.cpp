#include "core/fabric/weave/picture_rims.h"

#include <algorithm>
#include <optional>
#include <utility>

// How it works. Where a smooth edge was drawn, a pixel has a share of the colour on either side. Such a pixel lies
// between two opposite neighbours that are clearly apart: near the line from one colour to the other, at neither end of
// it. Edges a few pixels wide are rims all through, since each of their pixels lies between the next ones. Rims then
// take the number of a neighbour that is none, pass by pass, until all have one.

namespace loomlight {
namespace {

/// Neighbours on opposite sides.
constexpr int kOpposite[4][2] = {{1, 0}, {0, 1}, {1, 1}, {1, -1}};

bool isMixture(const Rgb8& pixel, const Rgb8& one, const Rgb8& other) {
  constexpr double kApart2 = 76.5 * 76.5;  // a tenth of what black and white are
  const ExactColour from = exactly(one), edge = difference(exactly(other), from);
  const double length2 = seenProduct(edge, edge);
  if (length2 < kApart2) return false;
  const ExactColour here = difference(exactly(pixel), from);
  const double share = seenProduct(here, edge) / length2;
  if (share <= 0 || share >= 1) return false;
  // Mixed in linear light, colours leave the straight line between their displayed values by up to this share of it.
  constexpr double kAside = 0.25;
  return seenProduct(here, here) - share * share * length2 < kAside * kAside * length2;
}

class Neighbourhood {
 public:
  explicit Neighbourhood(const Raster& raster) : raster_(raster) {}

  /// Null beyond the edge of the picture.
  const Rgb8* at(int x, int y) const {
    const bool isInside = x >= 0 && x < raster_.width && y >= 0 && y < raster_.height;
    return isInside ? &raster_.pixels[static_cast<size_t>(y) * static_cast<size_t>(raster_.width) + x] : nullptr;
  }

  PixelKind kindOf(int x, int y) const {
    constexpr double kAlike2 = 38.0 * 38.0;
    const Rgb8& pixel = *at(x, y);
    bool isAlone = true, isRim = false;
    for (const auto& [dx, dy] : kOpposite) {
      const Rgb8* const one = at(x - dx, y - dy);
      const Rgb8* const other = at(x + dx, y + dy);
      for (const Rgb8* const neighbour : {one, other})
        isAlone = isAlone && !(neighbour && distance2(exactly(pixel), exactly(*neighbour)) < kAlike2);
      isRim = isRim || (one && other && *one != pixel && *other != pixel && isMixture(pixel, *one, *other));
    }
    return isRim ? PixelKind::rim : isAlone ? PixelKind::alone : PixelKind::area;
  }

  /// Most pixels of a drawing are like all about them.
  bool isInArea(int x, int y) const {
    const Rgb8& pixel = *at(x, y);
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx)
        if (const Rgb8* const neighbour = at(x + dx, y + dy); neighbour && *neighbour != pixel) return false;
    return true;
  }

 private:
  const Raster& raster_;
};

}  // namespace

std::vector<PixelKind> pixelKinds(const Raster& raster) {
  const Neighbourhood about(raster);
  std::vector<PixelKind> kinds(raster.pixels.size(), PixelKind::area);
  size_t i = 0;
  for (int y = 0; y < raster.height; ++y)
    for (int x = 0; x < raster.width; ++x, ++i)
      if (!about.isInArea(x, y)) kinds[i] = about.kindOf(x, y);
  return kinds;
}

void takeRimsIntoNeighbours(const Raster& raster, const std::vector<Rgb8>& palette, std::vector<uint8_t>& numbers) {
  std::vector<PixelKind> kinds = pixelKinds(raster);
  std::vector<size_t> rims;
  for (size_t i = 0; i < kinds.size(); ++i)
    if (kinds[i] == PixelKind::rim) rims.push_back(i);
  const auto forNeighbours = [&raster](size_t i, auto&& visit) {  // and for the pixel itself
    const int x = static_cast<int>(i % static_cast<size_t>(raster.width));
    const int y = static_cast<int>(i / static_cast<size_t>(raster.width));
    for (int ny = std::max(0, y - 1); ny <= std::min(raster.height - 1, y + 1); ++ny)
      for (int nx = std::max(0, x - 1); nx <= std::min(raster.width - 1, x + 1); ++nx)
        visit(static_cast<size_t>(ny) * static_cast<size_t>(raster.width) + static_cast<size_t>(nx));
  };
  const auto nearestBeside = [&](size_t i) {
    std::optional<uint8_t> nearest;
    double least = 0;
    forNeighbours(i, [&](size_t n) {
      if (kinds[n] == PixelKind::rim) return;
      const double apart = distance2(exactly(raster.pixels[i]), exactly(palette[numbers[n]]));
      if (nearest && apart >= least) return;
      least = apart;
      nearest = numbers[n];
    });
    return nearest;
  };
  // Layer by layer from outside: after a layer only its neighbours can be taken.
  std::vector<uint8_t> isNext(kinds.size(), 0);
  while (!rims.empty()) {
    std::vector<size_t> taken;
    for (const size_t i : rims) {
      isNext[i] = 0;
      const std::optional<uint8_t> number = nearestBeside(i);
      if (!number) continue;
      numbers[i] = *number;
      taken.push_back(i);
    }
    for (const size_t i : taken) kinds[i] = PixelKind::area;
    rims.clear();
    for (const size_t i : taken)
      forNeighbours(i, [&](size_t n) {
        if (kinds[n] != PixelKind::rim || std::exchange(isNext[n], 1) != 0) return;
        rims.push_back(n);
      });
  }
}

}  // namespace loomlight
