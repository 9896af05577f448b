#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/task.h"
#include "render/film/film.h"
#include "render/media/medium.h"
#include "render/scene/scene.h"

namespace loomlight {

/// A way to sample paths that is measured: a scene's own, with one thing changed.
struct SamplingVariant {
  std::string name;
  void (*change)(Scene& scene);
};

/// All on, each of PathSampling off in turn, and roulette that takes cloth for half as dark.
const std::vector<SamplingVariant>& samplingVariants();

/// How fast a picture of a scene comes near the one it converges to.
class ConvergenceStudy {
 public:
  struct Point {
    uint32_t samples = 0;
    double error = 0;    ///< relMSE, mean over the rounds
    double seconds = 0;  ///< processor time from the first sample on
  };

  /// Renders the reference with another seed. `rounds`: pictures of different seeds whose errors are averaged.
  ConvergenceStudy(const Scene& scene, const Medium& medium, uint32_t referenceSamples, int rounds, const Task& task);

  /// One point for each power of four of samples up to `samples`; empty when stopped.
  std::vector<Point> measure(const SamplingVariant& variant, uint32_t samples) const;
  /// The window's first picture, one sample a pixel at 1/divider of the resolution, stretched over the whole as the
  /// window stretches it.
  std::optional<Point> coarse(int divider) const;

 private:
  double error(const std::vector<Rgb>& picture) const;
  Scene round(int number) const;

  const Scene& scene_;
  const Medium& medium_;
  int rounds_;
  const Task& task_;
  std::vector<Rgb> reference_;
};

}  // namespace loomlight
