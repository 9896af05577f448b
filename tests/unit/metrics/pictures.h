#pragma once

#include <functional>
#include <random>

#include "render/metrics/comparison.h"

namespace loomlight::test {

inline LinearPicture picture(int width, int height, const std::function<Rgb(int x, int y)>& colour) {
  LinearPicture made{width, height, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) made.pixels.push_back(colour(x, y));
  return made;
}

inline LinearPicture uniform(Rgb colour, int width = 40, int height = 30) {
  return picture(width, height, [&](int, int) { return colour; });
}

/// Every channel of every pixel independent, evenly distributed from 0 to `most`.
inline LinearPicture noise(unsigned seed, float most = 1, int width = 40, int height = 30) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> value(0, most);
  return picture(width, height, [&](int, int) { return Rgb(value(random), value(random), value(random)); });
}

inline PicturePair pairOf(LinearPicture a, LinearPicture r) {
  return {std::move(a), std::move(r), "a.exr", "r.exr"};
}

}  // namespace loomlight::test
