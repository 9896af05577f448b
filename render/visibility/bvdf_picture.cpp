#include "render/visibility/bvdf_picture.h"

#include <fmt/format.h>

#include <cmath>

#include "core/base/units.h"

namespace loomlight {
namespace {

constexpr auto kPiF = static_cast<float>(kPi);

glm::vec3 direction(float theta, float phi) {
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

float centre(int bin, int bins, float range) {
  return (static_cast<float>(bin) + 0.5f) / static_cast<float>(bins) * range;
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
            const glm::vec3 wo = direction(centre(to, r.thetaO, kPiF / 2), centre(po, r.phiO, kPiF));
            const glm::vec3 wi = direction(centre(ti, r.thetaI, kPiF), centre(pi, r.phiI, 2 * kPiF));
            values[pixel++] = set.tables[t].occlusion(wi, wo);
          }
  }
  return image;
}

Pixels8 bvdfPicture(const BvdfSet& set) {
  constexpr int kSquares = 8, kSide = 96, kGap = 6;
  Pixels8 picture;
  picture.channels = 3;
  picture.width = kSquares * (kSide + kGap) + kGap;
  picture.height = static_cast<int>(set.tables.size()) * (kSide + kGap) + kGap;
  picture.bytes.assign(static_cast<size_t>(picture.width) * picture.height * 3, 96);
  for (size_t t = 0; t < set.tables.size(); ++t)
    for (int square = 0; square < kSquares; ++square) {
      const float phiI = kPiF * static_cast<float>(square) / (kSquares - 1);
      const int left = kGap + square * (kSide + kGap), top = kGap + static_cast<int>(t) * (kSide + kGap);
      for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
          const glm::vec3 wo = direction(centre(y, kSide, kPiF / 2), 0), wi = direction(centre(x, kSide, kPiF), phiI);
          const auto grey = static_cast<uint8_t>(std::lround(255 * (1 - set.tables[t].occlusion(wi, wo))));
          const size_t at = (static_cast<size_t>(top + y) * picture.width + left + x) * 3;
          picture.bytes[at] = picture.bytes[at + 1] = picture.bytes[at + 2] = grey;
        }
    }
  return picture;
}

}  // namespace loomlight
