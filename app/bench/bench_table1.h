#pragma once

#include "app/bench/studies/report_bench.h"
#include "core/base/task.h"

namespace loomlight {

/// Table 1 of the report, and the pictures it was measured on (Figs. 9 and 10): four cloths round a cylinder, explicit
/// fibres against the volume at falling resolution, under three lights. False when stopped.
bool benchTable1(const ReportBench& bench, const Task& task);

}  // namespace loomlight
