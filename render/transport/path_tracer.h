#pragma once

#include <optional>

#include "core/base/task.h"
#include "render/film/film.h"
#include "render/transport/path_integrator.h"
#include "render/transport/path_records.h"

namespace loomlight {

/// A sample of a pixel that is to be traced.
struct PixelSample {
  int x = 0, y = 0;
  uint32_t index = 0;
  PathSink* listener = nullptr;  ///< may be null; hears all that befalls its path, uncoloured
};

/// Traces the samples of pixels, for one thread. Scene, medium and camera must outlive it.
class PathTracer {
 public:
  /// With so many under way at once, at most PathIntegrator::kBatch.
  PathTracer(const Scene& scene, const Medium& medium, const CameraRays& camera, size_t most = 1);

  /// Each a pure function of (scene, medium, camera, seed, x, y, index), whichever are traced together. Adds their cost
  /// to `counts`. False where `task` (may be null) was stopped: then there are none.
  bool trace(std::span<const PixelSample> wanted, TraceCounts& counts, const Task* task = nullptr);
  // Of the last call, by index into its list:
  const Ray& ray(size_t i) const { return starts_[i].ray; }  ///< from the eye
  const PathSample& sample(size_t i) const { return sinks_[i].sample(); }
  /// Where the path met its first fibre; null where it met none.
  const Collision* first(size_t i) const { return sinks_[i].sample().alpha > 0 ? &sinks_[i].first() : nullptr; }

 private:
  /// Makes the sample of a pixel; colours light as it comes.
  class PixelSink final : public PathSink {
   public:
    PixelSink(const Scene& scene, PathSink* listener) : scene_(scene), listener_(listener) {}
    bool meets(const Collision& at, uint32_t event) override;
    void gathers(const PathLight& light, std::span<const float> lengths_mm, uint32_t events) override;
    void scatters(const FibreBcsdf::Sample& by, glm::vec3 direction, float weight) override;
    void ends(PathEnd why) override;
    const PathSample& sample() const { return sample_; }
    const Collision& first() const { return first_; }

   private:
    const Scene& scene_;
    PathSink* listener_;
    Collision first_;
    PathSample sample_;
  };

  const Scene& scene_;
  const CameraRays& camera_;
  PathIntegrator integrator_;
  std::vector<PixelSink> sinks_;
  std::vector<PathStart> starts_;
};

/// One such sample.
PathSample tracePath(const Scene& scene, const Medium& medium, const CameraRays& camera, int x, int y, uint32_t index,
                     TraceCounts& counts, PathSink* listener = nullptr);

struct PassResult {
  bool complete = true;  ///< false when stopped: some pixels lack some samples
  TraceCounts counts;
};

/// Hears where the paths of a pass met their first fibre, and what they brought from there.
class FirstFibreSink {
 public:
  virtual ~FirstFibreSink() = default;
  virtual void begin(size_t blocks) = 0;
  /// From the one thread that traces this block of the picture, in the order of its samples. `ray`: from the eye.
  /// `first`: null where a path met nothing.
  virtual void sample(size_t block, int x, int y, const Ray& ray, const Collision* first, const PathSample& sample) = 0;
};

/// What of a picture a pass traces, and who hears of it.
struct PassOptions {
  std::optional<PixelRect> window = {};  ///< these pixels alone, with the samples that they have in the whole picture
  uint32_t firstSample = 0;
  /// Of the film's size: keeps the paths that it has room for. The window then begins where one of its tiles does.
  PathRecords* records = nullptr;
  FirstFibreSink* first = nullptr;  ///< hears of all samples
};

/// Brings every pixel of the window to `samples` samples, numbered from options.firstSample on: traces those that are
/// missing, so that a stopped or resumed picture goes on where each of its pixels is. Checks stop each time that the
/// paths under way have met a fibre; samples that are not in the film then are dropped, two thousand a thread at most.
PassResult renderUpTo(uint32_t samples, const Scene& scene, const Medium& medium, const CameraRays& camera, Film& film,
                      const Task& task, const PassOptions& options = {});

}  // namespace loomlight
