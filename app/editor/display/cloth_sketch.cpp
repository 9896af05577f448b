#include "app/editor/display/cloth_sketch.h"

#include <algorithm>
#include <cmath>

#include "app/export/draft_picture.h"
#include "core/base/rgb.h"
#include "core/fabric/yarn/yarn_reflectance.h"
#include "render/colour/tone.h"

namespace loomlight {
namespace {

/// From left to right through the middle, before the grey that pictures of cloths have behind them.
Pixels8 strand(const Rgb& colour, int width, int height) {
  constexpr double kThickness = 0.4;  // of the height, as in close-ups
  Pixels8 picture{width, height, 3, {}};
  picture.bytes.reserve(3 * static_cast<size_t>(width) * static_cast<size_t>(height));
  for (int y = 0; y < height; ++y) {
    const bool isYarn = std::abs((y + 0.5) / height - 0.5) < 0.5 * kThickness;
    const Rgb shown = clippedSrgbFromLinear(isYarn ? colour : Tone{}.background);
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < 3; ++c) picture.bytes.push_back(byteOf(shown[c]));
  }
  return picture;
}

}  // namespace

Pixels8 clothSketch(const Fabric& fabric) {
  const int width = fabric.render.width, height = fabric.render.height;
  const std::vector<Rgb> colours = yarnReflectances(fabric);
  // Where every end lies over every pick nothing is woven: it is the close-up of a yarn.
  const bool isWoven = fabric.weave.ends() > 1 || fabric.weave.picks() > 1;
  if (!isWoven) return strand(colours[static_cast<size_t>(fabric.warpYarn(0))], width, height);
  return draftPicture(fabric, colours, width, height);
}

}  // namespace loomlight
