#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "app/bench/studies/bench_cloths.h"
#include "app/bench/studies/report_bench.h"
#include "core/base/task.h"
#include "core/fabric/model/fabric.h"
#include "render/film/image.h"
#include "render/metrics/comparison.h"

namespace loomlight {

/// What the cloth is looked at in, from straight above: white from above, a point at the eye, white from below, and
/// parallel light from below, slanting.
struct AccuracyLight {
  const char* name;
  LightKind kind;
  double azimuth_deg = 0, elevation_deg = 0;
};
inline constexpr std::array kAccuracyLights{
    AccuracyLight{"dome", LightKind::dome}, AccuracyLight{"headlight", LightKind::headlight},
    AccuracyLight{"back light", LightKind::back}, AccuracyLight{"sun from behind", LightKind::directional, 30, -45}};
inline constexpr size_t kAccuracyDome = 0;  ///< among these

/// How far one way to trace a cloth is from its fibres, in percent.
struct Accuracy {
  std::string method;
  /// Difference of the mean colour, for each light: three channels.
  std::array<std::array<Estimate, 3>, kAccuracyLights.size()> colour;
  Estimate pixels;                   ///< RMS of pixels of d / 4.6 under the dome, free of noise; d: the yarn's diameter
  std::optional<Estimate> halfDome;  ///< RMS of a half-dome's cameras under the dome, free of noise
};

/// One cloth. The yardstick, other fibres in the same yarns, comes first.
struct AccuracyStudy {
  std::vector<Accuracy> methods;
  double segments = 0;  ///< of fibres, in the piece that was traced
  Pixels8 picture;      ///< under each light: fibres, other fibres, ours
};

/// Names of methods; the quick form does without the last.
inline constexpr const char* kOtherFibres = "other fibres, same yarns";
inline constexpr const char* kOurs8 = "loomlight, resolution 8";
inline constexpr const char* kOurs16 = "loomlight, resolution 16";

/// A piece so large that no edge is seen, the same fibres explicit and as a volume. nullopt when stopped.
std::optional<AccuracyStudy> studyAccuracy(const BenchCloth& cloth, const ReportBench& bench, const Task& task);

}  // namespace loomlight
