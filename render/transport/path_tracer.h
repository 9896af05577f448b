#pragma once

#include "core/base/task.h"
#include "render/film/film.h"
#include "render/transport/path_integrator.h"
#include "render/transport/path_records.h"

namespace loomlight {

/// Traces the samples of pixels, for one thread. Scene, medium and camera must outlive it.
class PathTracer {
 public:
  PathTracer(const Scene& scene, const Medium& medium, const CameraRays& camera);

  /// Sample `index` of the pixel: a pure function of (scene, medium, camera, seed, x, y, index). Adds its cost to
  /// `counts`. `listener` (may be null) hears all that befalls its path, uncoloured.
  PathSample trace(int x, int y, uint32_t index, TraceCounts& counts, PathSink* listener = nullptr);
  /// Where the last path met its first fibre, if its sample has alpha.
  const Collision& first() const { return first_; }

 private:
  const Scene& scene_;
  const CameraRays& camera_;
  PathIntegrator integrator_;
  Collision first_;
};

/// One such sample.
PathSample tracePath(const Scene& scene, const Medium& medium, const CameraRays& camera, int x, int y, uint32_t index,
                     TraceCounts& counts, PathSink* listener = nullptr);

/// Pixels of a film; x to the right, y downwards, from its top left.
struct PixelRect {
  int x = 0, y = 0, width = 0, height = 0;
  bool operator==(const PixelRect&) const = default;
};

struct PassResult {
  bool complete = true;  ///< false when stopped: some pixels lack some samples
  TraceCounts counts;
};

/// Hears where the paths of a pass met their first fibre, and what they brought from there.
class FirstFibreSink {
 public:
  virtual ~FirstFibreSink() = default;
  virtual void begin(size_t tiles) = 0;
  /// From the one thread that traces this tile, in the order of its samples. `first`: null where a path met nothing.
  virtual void sample(size_t tile, int x, int y, const Collision* first, const PathSample& sample) = 0;
};

/// Brings every pixel of the film to `samples` samples, numbered from `firstSample` on: traces those that are missing,
/// so that a stopped or resumed picture goes on where each of its pixels is. Checks stop per path.
PassResult renderUpTo(uint32_t samples, const Scene& scene, const Medium& medium, const CameraRays& camera, Film& film,
                      const Task& task, uint32_t firstSample = 0);
/// Brings the pixels of a window of the film to `samples` samples, the ones that they would have in the whole picture.
/// `records`, of the film's size, keeps the paths it has room for; the window then begins where one of its tiles does.
/// `first` hears of all samples.
PassResult renderUpTo(uint32_t samples, const Scene& scene, const Medium& medium, const CameraRays& camera, Film& film,
                      const PixelRect& window, const Task& task, uint32_t firstSample = 0,
                      PathRecords* records = nullptr, FirstFibreSink* first = nullptr);

/// Samples that every pixel of the window has at least.
uint32_t fewestSamples(const Film& film, const PixelRect& window);

}  // namespace loomlight
