#pragma once

#include <cstdint>

namespace loomlight {

/// Samples a pixel at which a picture in the window rests, unless another number is asked for.
inline constexpr uint32_t kUsualRest = 1024;

/// What the tracer should do next: bring a picture of 1/divider of the resolution to `samples` samples a pixel.
struct PassPlan {
  int divider = 1;
  uint32_t samples = 0;
  bool operator==(const PassPlan&) const = default;
};

/// How coarse the first pass may be: its divider is at most `coarsest`, as long as it takes no longer than `patience_s`
/// on all threads; a slower cloth begins as coarse as any, at kCoarsest. Then it is rounded up to a multiple of
/// `finer`.
struct FirstPass {
  static constexpr int kCoarsest = 32;
  /// Coarser pictures that stand still say nothing of the weave.
  static constexpr int kLegible = 8;
  /// In motion, or where every pixel of a pass is seen as `finer` by `finer` of its own, they may be as coarse as this.
  static constexpr int kInMotion = 12;
  int coarsest = kCoarsest;
  double patience_s = 0.1;
  int finer = 1;  ///< shown with so many times its pixels each way, where light is known (SharedLight::known)
};

/// What it has done since the last restart.
struct PassHistory {
  int width = 0, height = 0;   ///< of the full picture
  double secondsPerPath = 0;   ///< measured, on all threads together; 0: nothing measured yet
  int divider = 0;             ///< of the last pass; 0: none yet
  uint32_t coarseSamples = 0;  ///< of the last pass, where that was coarse
  uint32_t samples = 0;        ///< at full resolution
  double seconds = 0;          ///< since the restart
  /// Light is shared between repeats, and the first paths at full resolution would wait for fibres to be laid.
  bool waitsForFibres = false;
  FirstPass first{};
};

/// What passes that take longer than one sample are to take: a quarter of the picture's age, as the eye sees progress
/// in proportion. Seconds.
double passBudget_s(const PassHistory& history);

/// Coarse and quick first, then finer, then more samples in passes that grow longer as the picture grows older. Pure.
/// samples == 0 in the plan: converged, nothing left to do.
PassPlan nextPass(const PassHistory& history, uint32_t samplesWanted);

/// First fibres that every pixel should have before the next pass, where light is shared between repeats: each round of
/// them costs a fraction of a sample, and shows the picture at full resolution.
uint32_t hitsWanted(const PassHistory& history);

/// One of the two pictures that share the tracer's threads.
struct Contender {
  bool wants = false;  ///< there is something left to trace
  int divider = 0;     ///< of its last pass; 0: nothing to be seen yet
  double spent_s = 0;  ///< tracing it, since both have been there
};

enum class Subject { none, picture, inset };

/// Of which the next pass is: first what cannot be seen yet, then what is coarse, then what has had less time. Pure.
Subject nextSubject(const Contender& picture, const Contender& inset);

}  // namespace loomlight
