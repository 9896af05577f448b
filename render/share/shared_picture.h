#pragma once

#include <span>
#include <vector>

#include "render/film/film.h"
#include "render/share/first_hits.h"

namespace loomlight {

/// A picture of cells: each pixel the mean of the cells that it shows, as far as it shows cloth. Row by row from the
/// top left.
struct SharedPicture {
  /// Black and empty at first.
  SharedPicture(int w, int h)
      : width(w), height(h), light(pixelCount(w, h)), alpha(light.size()), variances(light.size()) {}

  int width, height;
  std::vector<Rgb> light;  ///< linear, premultiplied
  std::vector<float> alpha;
  /// Of one path through the pixel, as the cells let expect it, summed over the channels.
  std::vector<float> variances;
};

/// A film of the same view with 1/divider of its pixels each way, rounded up.
struct CoarseFilm {
  Film film;
  int divider = 1;
};

/// Each pixel the mean over `side` x `side`, or over what there is of them at the right and at the bottom.
SharedPicture reduced(const SharedPicture& fine, int side);

SharedPicture sharedPicture(const FirstHits& hits, const CellMeans& means, int threads);

/// The picture of cells, which has hardly any noise but an error of its own, brought nearer to a film of the same
/// paths, which has noise alone: by what the film knows of places that are in another light than their cells, and pixel
/// by pixel as its noise falls. So the picture converges to the film, and is exactly that from `samplesAlone` samples
/// on.
/// `coarser`: films of the same view, each finer than the one before, which know how bright places are that the film
/// has no samples of yet.
std::vector<glm::vec4> corrected(SharedPicture shared, const Film& film, std::span<const CoarseFilm> coarser,
                                 uint32_t samplesAlone, int threads);

}  // namespace loomlight
