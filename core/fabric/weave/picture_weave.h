#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/fabric/model/weave.h"
#include "core/fabric/weave/picture_colour.h"

namespace loomlight {

/// How a picture becomes a jacquard: few colours, and a structure woven in the place of each.

/// Pixels row by row from the top left, as pictures are.
struct Raster {
  int width = 0, height = 0;
  std::vector<Rgb8> pixels;
};

/// Another size, 1..Weave::kMaxSide both: the mean of what a pixel covers where it gets smaller, the nearest pixel
/// where it gets larger, so that no colour is added.
Raster resampled(const Raster& raster, int width, int height);
/// Of the same proportions, and at most so many pixels long.
Raster reducedTo(const Raster& raster, int longestSide);

struct ReducedPicture {
  int width = 0, height = 0;
  std::vector<uint8_t> colourOf;  ///< number in the palette of each pixel, from the top left
  std::vector<Rgb8> palette;
  std::vector<double> shares;  ///< of the area, 0..1
};

/// How often each colour occurs: what palettes are made of, so that the pixels are looked at once. The mixed colours
/// of smooth edges are not among the bins.
struct ColourCounts {
  struct Bin {
    double weight = 0;                    ///< pixels of nearly one colour
    std::array<double, 3> mean{0, 0, 0};  ///< of the colours in the bin
  };
  std::vector<Bin> bins;
  std::vector<Rgb8> few;  ///< the colours themselves, where there are at most 32
};
ColourCounts coloursOf(const Raster& raster);

/// At most `colours` colours, 1..32, from dark to light: those that leave little difference. A picture that has no more
/// keeps them as they are. The same picture always gives the same palette.
std::vector<Rgb8> paletteOf(const ColourCounts& counts, int colours);
/// Each pixel in the nearest of these colours, 1..32. Where the picture has others, a rim between two areas, which is a
/// mixture of both, becomes a part of the nearer one.
ReducedPicture reduced(const Raster& raster, std::vector<Rgb8> palette);

/// One end for each column and one pick for each row, the first pick at the bottom; a pixel is woven as the structure
/// of its colour is there. One structure for each colour.
Weave weaveOf(const ReducedPicture& picture, const std::vector<Weave>& structures);

}  // namespace loomlight
