#include "app/editor/draft_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "ui/yarn_colours.h"

namespace loomlight {
namespace {

using Colour = std::array<float, 3>;  // as displayed, 0..1

/// The colour of what lies on top.
std::function<Colour(int pick, int end)> colouring(const Fabric& fabric) {
  std::vector<Colour> yarns;
  for (const ImVec4& c : yarnColours(fabric)) yarns.push_back({c.x, c.y, c.z});
  const Colour first = yarns[static_cast<size_t>(fabric.warpYarn(0))];
  const auto isFirst = [&](int yarn) {
    const Colour& c = yarns[static_cast<size_t>(yarn)];
    constexpr float kSeen = 0.1f;
    return std::abs(c[0] - first[0]) + std::abs(c[1] - first[1]) + std::abs(c[2] - first[2]) < kSeen;
  };
  const bool plain = std::all_of(fabric.warpSequence.begin(), fabric.warpSequence.end(), isFirst) &&
                     std::all_of(fabric.weftSequence.begin(), fabric.weftSequence.end(), isFirst);
  return [&fabric, plain, yarns = std::move(yarns)](int pick, int end) {
    const bool warp = fabric.weave.warpOver(pick, end);
    const Colour yarn = yarns[static_cast<size_t>(warp ? fabric.warpYarn(end) : fabric.weftYarn(pick))];
    if (!plain) return yarn;
    constexpr float kApart = 0.45f;
    const auto shaded = [warp](float c) { return (1 - kApart) * c + (warp ? 0 : kApart); };
    return Colour{shaded(yarn[0]), shaded(yarn[1]), shaded(yarn[2])};
  };
}

}  // namespace

Pixels8 draftPicture(const Fabric& fabric, int side) {
  constexpr int kFewest = 32;  // crossings a side
  const int longest = std::max(fabric.weave.ends(), fabric.weave.picks());
  const int cell = std::max(1, side / std::max(kFewest, longest));
  const double pitch = std::max(1.0, static_cast<double>(longest) / side) / cell;  // crossings from pixel to pixel
  const int samples = pitch > 1 ? 16 : 1;
  const auto colourAt = colouring(fabric);
  Pixels8 picture{side, side, 3, {}};
  picture.bytes.reserve(static_cast<size_t>(side) * side * 3);
  for (int y = side - 1; y >= 0; --y)
    for (int x = 0; x < side; ++x) {
      Colour sum{};
      for (int i = 0; i < samples; ++i) {
        // Spread evenly, and in step with no weave (Roberts's sequence).
        const double dx = std::fmod(0.5 + 0.7548776662466927 * i, 1), dy = std::fmod(0.5 + 0.5698402909980532 * i, 1);
        const Colour c = colourAt(static_cast<int>((y + dy) * pitch), static_cast<int>((x + dx) * pitch));
        for (size_t k = 0; k < 3; ++k) sum[k] += c[k];
      }
      for (const float channel : sum)
        picture.bytes.push_back(static_cast<uint8_t>(std::lround(255 * channel / static_cast<float>(samples))));
    }
  return picture;
}

}  // namespace loomlight
