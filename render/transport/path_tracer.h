#pragma once

#include "core/base/task.h"
#include "render/film/film.h"
#include "render/media/medium.h"
#include "render/scene/camera_rays.h"
#include "render/scene/scene.h"
#include "render/transport/path_records.h"

namespace loomlight {

/// Sample `index` of the pixel: a pure function of (scene, medium, camera, seed, x, y, index). Adds its cost to
/// `counts`. Light is gathered by sampling lamps and fibres, weighted against each other (Veach 1997); colour is
/// applied where the path meets light, from the lengths travelled inside the fibres of each material. `log` receives
/// all that light as it was before.
PathSample tracePath(const Scene& scene, const Medium& medium, const CameraRays& camera, int x, int y, uint32_t index,
                     TraceCounts& counts, PathLog* log = nullptr);

/// Pixels of a film; x to the right, y downwards, from its top left.
struct PixelRect {
  int x = 0, y = 0, width = 0, height = 0;
  bool operator==(const PixelRect&) const = default;
};

struct PassResult {
  bool complete = true;  ///< false when stopped: some pixels lack some samples
  TraceCounts counts;
};

/// Brings every pixel of the film to `samples` samples, numbered from `firstSample` on: traces those that are missing,
/// so that a stopped or resumed picture goes on where each of its pixels is. Checks stop per path.
PassResult renderUpTo(uint32_t samples, const Scene& scene, const Medium& medium, const CameraRays& camera, Film& film,
                      const Task& task, uint32_t firstSample = 0);
/// The same for a part of the film: its pixels get the samples that they would have in the whole picture. `records`, of
/// the film's size, keeps the paths it has room for; the window then begins where one of its tiles does.
PassResult renderUpTo(uint32_t samples, const Scene& scene, const Medium& medium, const CameraRays& camera, Film& film,
                      const PixelRect& window, const Task& task, uint32_t firstSample = 0,
                      PathRecords* records = nullptr);

/// Samples that every pixel of the window has at least.
uint32_t fewestSamples(const Film& film, const PixelRect& window);

}  // namespace loomlight
