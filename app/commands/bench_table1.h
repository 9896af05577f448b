#pragma once

#include <string>

#include "core/base/task.h"

namespace loomlight {

/// What `bench table1` and `bench figures` are asked for.
struct ReportBench {
  std::string folder;  ///< where page, pictures and tables go
  bool quick = false;  ///< small pieces, few paths: seconds instead of an hour, for tests
  double memoryLimit_bytes = 0;
};

/// Table 1 of the report, and the pictures it was measured on (Figs. 9 and 10): four cloths round a cylinder, explicit
/// fibres against the volume at falling resolution, under three lights. False when stopped.
bool benchTable1(const ReportBench& bench, const Task& task);

}  // namespace loomlight
