#pragma once

#include <memory>
#include <optional>

#include "core/base/task.h"
#include "render/film/film.h"
#include "render/scene/fibre_extent.h"
#include "render/scene/scene.h"
#include "render/transport/path_tracer.h"

namespace loomlight {

struct WholePicture {
  std::shared_ptr<const Scene> scene;
  Film film;
};

/// A scene traced to its fabric's RenderSettings. `first` (may be null) hears of all samples. Nothing when stopped.
std::optional<Film> tracedFilm(const Scene& scene, const Medium& medium, const Task& task,
                               FirstFibreSink* first = nullptr);

/// A fabric built and traced to its own RenderSettings, with one progress for both. Nothing when stopped. Throws
/// InputError.
std::optional<WholePicture> renderWhole(std::shared_ptr<const Fabric> fabric, const FibreOptions& fibres,
                                        const Task& task, const Tiling& tiling = {});

}  // namespace loomlight
