#pragma once

#include "app/bench/studies/report_bench.h"
#include "core/base/task.h"

namespace loomlight {

/// The report's figures, ours beside explicit fibres: Fig. 1 (large pieces), 7 (with and without local visibility), 8
/// (the BVDF) and 11 to 15 (half-dome BRDFs). Figs. 9 and 10 are the pictures of Table 1. False when stopped.
bool benchFigures(const ReportBench& bench, const Task& task);

}  // namespace loomlight
