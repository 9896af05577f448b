#pragma once

#include <cstdint>
#include <vector>

#include "render/display/frame.h"
#include "render/scene/camera_rays.h"

namespace loomlight {

/// What an earlier picture shows of a cloth, as another camera sees it: sharp at once, while a hand turns the cloth.
/// Full resolution, row by row from the top left.
struct MovedView {
  int width = 0, height = 0;
  std::vector<glm::vec4> light;  ///< linear, premultiplied; black and empty where nothing is kept
  std::vector<Film::Hit> hits;   ///< likewise
  std::vector<uint8_t> kept;     ///< 1 where the earlier picture has seen what is seen now
  int samples = 0;               ///< of the earlier picture
};

/// `earlier` has full resolution and hits, shows the whole viewport and was seen by `from`, which makes rays for
/// pictures of the same size as `to`. What is further apart than `thickness_mm` along a ray, more where cloth is seen
/// at a slant, is not the same place of the cloth. The same for any number of threads.
MovedView movedView(const Frame& earlier, const CameraRays& from, const CameraRays& to, float thickness_mm,
                    int threads);

/// Brightens it to the light of a film of the new view that has 1/divider of its pixels each way, as sheen moves with
/// the camera.
void brightenTo(MovedView& view, const Film& coarse, int divider, int threads);

/// The share of the cloth in a film of the new view, of 1/divider of its pixels each way, which the view has not kept.
float missingIn(const MovedView& view, const Film& coarse, int divider);

/// The view at full resolution, with what is not kept from a picture of the same view, perhaps a coarse one.
Frame filledFrom(const Frame& fresh, const MovedView& view, int threads);

}  // namespace loomlight
