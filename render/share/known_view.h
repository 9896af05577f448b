#pragma once

#include <optional>
#include <vector>

#include "core/base/task.h"
#include "render/film/film.h"
#include "render/media/medium.h"
#include "render/scene/camera_rays.h"
#include "render/scene/scene.h"
#include "render/share/cell_sums.h"
#include "render/share/shared_picture.h"

namespace loomlight {

/// A view in light that is known before paths are traced for it, from the picture before an edit. Each pixel
/// looks for one first fibre, which costs a fraction of a path; how open the cloth is there, and its light where there
/// was no fibre, comes from the pixels around.
struct KnownView {
  SharedPicture picture;
  std::vector<Film::Hit> hits;  ///< of each pixel; without a yarn where its ray went through the cloth or past it
};

/// As the camera sees it, in so many pixels. None when stopped. A pure function of its arguments, whatever the threads.
std::optional<KnownView> knownView(const Scene& scene, const Medium& medium, const CellSums& cells,
                                   const CameraRays& camera, int width, int height, const Task& task);

/// Brightens a picture to the light that a film of the same view knows of, which has 1/finer of its pixels each way:
/// what shines into another direction now, such as the sheen of satin, is not known to the cells.
void brightenTo(SharedPicture& picture, const Film& coarse, int finer, int threads);

}  // namespace loomlight
