#pragma once

#include <span>
#include <vector>

#include "render/film/film.h"
#include "render/share/shared_picture.h"

namespace loomlight {

/// How much brighter than its cells a film is, place by place: light that cells do not know of, such as the shade of
/// a fold, differs alike over many pixels, so blocks of pixels know it when a pixel has a sample or less.
class BlockGains {
 public:
  /// `coarser`: films of the same view, each finer than the one before. Pixels that the film has no samples of yet are
  /// known by the finest of these that has some.
  BlockGains(const SharedPicture& shared, const Film& film, std::span<const CoarseFilm> coarser, int threads);

  /// What the cells' light is to be multiplied with here, in pixels from the top left, channel by channel. Never
  /// negative.
  Rgb at(glm::vec2 place) const;
  /// In the middle of a pixel.
  Rgb at(int x, int y) const { return at(glm::vec2(x, y) + 0.5f); }

 private:
  /// One of each for blocks of one size, row by row.
  template <class OfBlock>
  struct Grid {
    Grid(int w, int h) : width(w), height(h), all(pixelCount(w, h)) {}
    int width, height;
    std::vector<OfBlock> all;

    OfBlock& at(int x, int y) { return all[pixelIndex(x, y, width)]; }
    const OfBlock& at(int x, int y) const { return all[pixelIndex(x, y, width)]; }
  };
  /// Film and cells in it.
  struct Block {
    Rgb light{0};       ///< of the cells, mean over its pixels
    Rgb difference{0};  ///< of the film from that
    float noise = 0;    ///< variance of the difference, summed over the channels
    float light2 = 0;   ///< of the cells, squared: what errors are in proportion to
    float square = 0;   ///< of the pixels' own differences, mean over them
    float pixels = 0;   ///< with samples; each a part of one where several share them

    void operator+=(const Block& part);
    Rgb gain(Rgb difference) const;
    float likelyNoise() const;
  };
  using Gains = Grid<Rgb>;
  /// A film, and the cells as its pixels would show them.
  struct Compared {
    const SharedPicture& shared;
    const Film& film;
    int divider;  ///< of the resolution

    Block at(int x, int y) const;
  };

  static Grid<Block> smallest(std::span<const Compared> finestFirst, int threads);
  static Grid<Block> ofTwiceTheSize(const Grid<Block>& small);
  static float relativeError2(const Grid<Block>& blocks, const Grid<Block>* larger);
  static Gains freedOfNoise(Grid<Block> smallest);
  static Rgb between(const Gains& gains, float x, float y);

  Gains gains_;  ///< of the smallest
};

}  // namespace loomlight
