#include "app/export/draft_picture.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/base/rgb.h"
#include "core/fabric/yarn/derived.h"

namespace loomlight {
namespace {

/// The colour of what lies on top, linear.
std::function<Rgb(int pick, int end)> colouring(const Fabric& fabric, std::span<const Rgb> yarnColours) {
  std::vector<Rgb> yarns;  // as displayed
  for (const Rgb& colour : yarnColours) yarns.push_back(clippedSrgbFromLinear(colour));
  const Rgb first = yarns[static_cast<size_t>(fabric.warpYarn(0))];
  const auto isFirst = [&](int yarn) {
    const Rgb& c = yarns[static_cast<size_t>(yarn)];
    constexpr float kSeen = 0.1f;
    return std::abs(c[0] - first[0]) + std::abs(c[1] - first[1]) + std::abs(c[2] - first[2]) < kSeen;
  };
  const bool plain = std::all_of(fabric.warpSequence.begin(), fabric.warpSequence.end(), isFirst) &&
                     std::all_of(fabric.weftSequence.begin(), fabric.weftSequence.end(), isFirst);
  return [&fabric, plain, yarns = std::move(yarns)](int pick, int end) {
    const bool warp = fabric.weave.warpOver(pick, end);
    const Rgb yarn = yarns[static_cast<size_t>(warp ? fabric.warpYarn(end) : fabric.weftYarn(pick))];
    if (!plain) return linearFromSrgb(yarn);
    constexpr float kApart = 0.45f;
    return linearFromSrgb((1 - kApart) * yarn + (warp ? 0 : kApart));
  };
}

}  // namespace

Pixels8 draftPicture(const Fabric& fabric, std::span<const Rgb> yarnColours, int width, int height) {
  constexpr int kFewest = 32;  // crossings along the longer side
  const int side = std::max(width, height);
  const CrossingShape shape = crossingShape(fabric);
  const double longest = std::max(fabric.weave.ends() * shape.width, fabric.weave.picks() * shape.height);
  const double unit = side / std::max(static_cast<double>(std::min(kFewest, side)), longest);
  const bool whole = unit >= 1;  // every crossing has pixels of its own
  const auto pitch = [&](double length) { return 1 / (whole ? std::round(std::floor(unit) * length) : unit * length); };
  const double acrossPixel = pitch(shape.width), downPixel = pitch(shape.height);  // crossings from pixel to pixel
  const int samples = whole ? 1 : 16;
  const auto colourAt = colouring(fabric, yarnColours);
  Pixels8 picture{width, height, 3, {}};
  picture.bytes.reserve(static_cast<size_t>(width) * static_cast<size_t>(height) * 3);
  for (int y = height - 1; y >= 0; --y)
    for (int x = 0; x < width; ++x) {
      Rgb sum(0.0f);
      for (int i = 0; i < samples; ++i) {
        // Spread evenly, and in step with no weave (Roberts's sequence).
        const double dx = std::fmod(0.5 + 0.7548776662466927 * i, 1), dy = std::fmod(0.5 + 0.5698402909980532 * i, 1);
        sum += colourAt(static_cast<int>((y + dy) * downPixel), static_cast<int>((x + dx) * acrossPixel));
      }
      const Rgb shown = srgbFromLinear(sum / static_cast<float>(samples));
      for (int c = 0; c < 3; ++c) picture.bytes.push_back(byteOf(shown[c]));
    }
  return picture;
}

}  // namespace loomlight
