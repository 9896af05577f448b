#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/commands/bench_cloths.h"
#include "app/commands/bench_table1.h"
#include "render/film/image.h"

namespace loomlight {

/// Half-dome BRDFs of one cloth, fibres beside the volume.
struct HalfDomeStudy {
  std::vector<std::vector<std::string>> rows;  ///< cloth, light, errors of the three channels, RMS without noise
  Pixels8 picture;                             ///< a row for each light
};

/// Parallel light from above, at 45 degrees and from behind, and the dome. nullopt when stopped.
std::optional<HalfDomeStudy> studyHalfDomes(const BenchCloth& cloth, const ReportBench& bench, const Task& task);

}  // namespace loomlight
