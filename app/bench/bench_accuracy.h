#pragma once

#include "app/bench/studies/report_bench.h"
#include "core/base/task.h"

namespace loomlight {

/// How near the volume comes to the very fibres that it was made of: six cloths, seen from above in four lights and
/// from a half-dome, with every estimator, and ours without one ingredient after another. Beside it the yardstick,
/// other fibres in the same yarns. False when stopped.
bool benchAccuracy(const ReportBench& bench, const Task& task);

}  // namespace loomlight
