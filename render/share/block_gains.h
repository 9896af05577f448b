#pragma once

#include <vector>

#include "render/film/film.h"
#include "render/share/shared_picture.h"

namespace loomlight {

/// How much brighter than its cells the film is, place by place: light that cells do not know of, such as the shade of
/// a fold, differs alike over many pixels, so blocks of pixels know it when a pixel has a sample or less.
class BlockGains {
 public:
  BlockGains(const SharedPicture& shared, const Film& film, int threads);

  /// What the cells' light is to be multiplied with in this pixel, channel by channel. Never negative.
  Rgb at(int x, int y) const;

 private:
  /// Film and cells in blocks of one size, row by row.
  struct Block {
    Rgb light{0};       ///< of the cells, mean over its pixels
    Rgb difference{0};  ///< of the film from that
    float noise = 0;    ///< variance of the difference, summed over the channels
    float light2 = 0;   ///< of the cells, squared: what errors are in proportion to
    float square = 0;   ///< of the pixels' own differences, mean over them
    float pixels = 0;   ///< with samples

    void operator+=(const Block& part);
    Rgb gain() const;
    float likelyNoise() const;
  };
  struct Blocks {
    Blocks(int w, int h) : width(w), height(h), all(static_cast<size_t>(w) * static_cast<size_t>(h)) {}
    int width, height;
    std::vector<Block> all;

    Block& at(int x, int y) { return all[index(x, y)]; }
    const Block& at(int x, int y) const { return all[index(x, y)]; }
    /// Between the centres of blocks; `x` and `y` in blocks from the top left.
    Rgb gain(float x, float y) const;

   private:
    size_t index(int x, int y) const {
      return static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x);
    }
  };
  static Blocks smallest(const SharedPicture& shared, const Film& film, int threads);
  static Blocks ofTwiceTheSize(const Blocks& small);
  static float relativeError2(const Blocks& blocks, const Blocks* larger);
  static Blocks freedOfNoise(Blocks smallest);

  Blocks blocks_;  ///< the smallest
};

}  // namespace loomlight
