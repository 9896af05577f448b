#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "app/bench/studies/bench_cloths.h"
#include "app/bench/studies/report_bench.h"
#include "core/base/task.h"
#include "render/film/image.h"
#include "render/metrics/comparison.h"
#include "render/transport/half_dome.h"

namespace loomlight {

/// One measurement made twice, with two patterns of noise.
using TwoMeasures = std::array<HalfDomeMeasure, 2>;
/// nullopt when stopped.
std::optional<TwoMeasures> measureTwice(const Scene& scene, const Medium& medium, const Light& light,
                                        const HalfDomeGrid& grid, int samples, const Task& task);
/// Squared relative difference of the cameras' colours, free of noise (noiseFreeBiasEstimate).
Estimate squaredDifference(const TwoMeasures& measures, const TwoMeasures& reference);

/// Half-dome BRDFs of one cloth, fibres beside the volume.
struct HalfDomeStudy {
  std::vector<std::vector<std::string>> rows;  ///< cloth, light, errors of the three channels, RMS without noise
  Pixels8 picture;                             ///< a row for each light
};

/// Parallel light from above, at 45 degrees and from behind, and the dome. nullopt when stopped.
std::optional<HalfDomeStudy> studyHalfDomes(const BenchCloth& cloth, const ReportBench& bench, const Task& task);

}  // namespace loomlight
