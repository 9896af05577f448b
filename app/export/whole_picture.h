#pragma once

#include <memory>
#include <optional>

#include "core/base/task.h"
#include "render/film/film.h"
#include "render/scene/fibre_extent.h"
#include "render/scene/scene.h"

namespace loomlight {

struct WholePicture {
  std::shared_ptr<const Scene> scene;
  Film film;
};

/// A fabric built and traced to its own RenderSettings, with one progress for both. Nothing when stopped. Throws
/// InputError.
std::optional<WholePicture> renderWhole(std::shared_ptr<const Fabric> fabric, const FibreOptions& fibres,
                                        const Task& task);

}  // namespace loomlight
