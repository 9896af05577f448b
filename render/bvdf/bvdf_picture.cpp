#include "render/bvdf/bvdf_picture.h"

#include <fmt/format.h>

#include <cmath>

#include "core/base/units.h"
#include "render/film/pixel_rect.h"

namespace loomlight {
namespace {

float centre(int bin, int bins, float range) {
  return (static_cast<float>(bin) + 0.5f) / static_cast<float>(bins) * range;
}

constexpr int kSquares = 8, kSide = 96;  // of Fig. 8

Pixels8 grey(int width, int height) {
  constexpr uint8_t kGround = 96;
  return {width, height, 3, std::vector<uint8_t>(3 * pixelCount(width, height), kGround)};
}

/// One square of the figure, of its own phi_i, with its corner at (left, top).
void drawSquare(const Bvdf& table, int square, Pixels8& picture, int left, int top) {
  const float phiI = kPiF * static_cast<float>(square) / (kSquares - 1);
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const glm::vec3 wo = polarDirection(centre(y, kSide, kPiF / 2), 0);
      const glm::vec3 wi = polarDirection(centre(x, kSide, kPiF), phiI);
      const auto shade = static_cast<uint8_t>(std::lround(255 * (1 - table.occlusion(wi, wo))));
      const size_t at = 3 * pixelIndex(left + x, top + y, picture.width);
      picture.bytes[at] = picture.bytes[at + 1] = picture.bytes[at + 2] = shade;
    }
}

}  // namespace

Image bvdfImage(const BvdfSet& set) {
  const BvdfResolution r = set.tables.front().resolution();
  Image image;
  image.width = r.phiI * r.thetaI;
  image.height = r.phiO * r.thetaO;
  for (size_t t = 0; t < set.tables.size(); ++t) {
    std::vector<float>& values = image.add(fmt::format("{}.p", t));
    size_t pixel = 0;
    for (int po = 0; po < r.phiO; ++po)
      for (int to = 0; to < r.thetaO; ++to)
        for (int pi = 0; pi < r.phiI; ++pi)
          for (int ti = 0; ti < r.thetaI; ++ti) {
            const glm::vec3 wo = polarDirection(centre(to, r.thetaO, kPiF / 2), centre(po, r.phiO, kPiF));
            const glm::vec3 wi = polarDirection(centre(ti, r.thetaI, kPiF), centre(pi, r.phiI, 2 * kPiF));
            values[pixel++] = set.tables[t].occlusion(wi, wo);
          }
  }
  return image;
}

Pixels8 bvdfPicture(const BvdfSet& set) {
  constexpr int kGap = 6;
  Pixels8 picture = grey(kSquares * (kSide + kGap) + kGap, static_cast<int>(set.tables.size()) * (kSide + kGap) + kGap);
  for (size_t t = 0; t < set.tables.size(); ++t)
    for (int square = 0; square < kSquares; ++square)
      drawSquare(set.tables[t], square, picture, kGap + square * (kSide + kGap),
                 kGap + static_cast<int>(t) * (kSide + kGap));
  return picture;
}

Pixels8 bvdfSquares(const Bvdf& table, int columns) {
  Pixels8 picture = grey(columns * kSide, (kSquares + columns - 1) / columns * kSide);
  for (int square = 0; square < kSquares; ++square)
    drawSquare(table, square, picture, square % columns * kSide, square / columns * kSide);
  return picture;
}

}  // namespace loomlight
