#pragma once

#include <vector>

#include "render/film/film.h"
#include "render/share/first_hits.h"

namespace loomlight {

/// A picture of cells: each pixel the mean of the cells that it shows. Row by row from the top left.
struct SharedPicture {
  int width = 0, height = 0;
  std::vector<Rgb> light;  ///< linear, premultiplied
  std::vector<float> alpha;
  /// Of one path through the pixel, as the cells let expect it, summed over the channels.
  std::vector<float> variances;
};
SharedPicture sharedPicture(const FirstHits& hits, const CellMeans& means, int threads);

/// The picture of cells, which has hardly any noise but an error of its own, blended with a film of the same paths,
/// which has noise alone: pixel by pixel in proportion to how little each of them is off. The film's noise is known
/// from the cells and falls with its samples; the error of the cells is estimated from how far they are from the film.
/// So the picture converges to the film, and is exactly that from `samplesAlone` samples on.
std::vector<glm::vec4> corrected(const SharedPicture& shared, const Film& film, uint32_t samplesAlone, int threads);

}  // namespace loomlight
