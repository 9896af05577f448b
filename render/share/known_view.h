#pragma once

#include <optional>
#include <vector>

#include "core/base/task.h"
#include "render/film/film.h"
#include "render/media/medium.h"
#include "render/scene/scene.h"
#include "render/share/cell_sums.h"
#include "render/share/shared_picture.h"

namespace loomlight {

/// A view in light that is known before paths are traced for it, from the picture before an edit. Each pixel shows
/// one first fibre, which costs a fraction of a path.
struct KnownView {
  SharedPicture picture;
  std::vector<Film::Hit> hits;  ///< of each pixel
};

/// None when stopped. A pure function of its arguments, whatever the threads.
std::optional<KnownView> knownView(const Scene& scene, const Medium& medium, const CellSums& cells, int width,
                                   int height, const Task& task);

/// Brightens a picture to the light that a film of the same view knows of, which has 1/finer of its pixels each way:
/// what shines into another direction now, such as the sheen of satin, is not known to the cells.
void brightenTo(SharedPicture& picture, const Film& coarse, int finer, int threads);

}  // namespace loomlight
