#pragma once

#include "app/bench/studies/report_bench.h"
#include "core/base/task.h"

namespace loomlight {

/// Cloths of the wardrobe seen so near that a fibre is a pixel wide: what close-ups cost in processor time beside the
/// volume alone, and how far both are from explicit fibres. False when stopped.
bool benchCloseUp(const ReportBench& bench, const Task& task);

}  // namespace loomlight
