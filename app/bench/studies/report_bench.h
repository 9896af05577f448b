#pragma once

#include <string>

namespace loomlight {

/// What `bench table1`, `figures`, `accuracy` and `closeup` are asked for.
struct ReportBench {
  std::string folder;  ///< where page, pictures and tables go
  bool quick = false;  ///< small pieces, few paths: seconds instead of a quarter of an hour, for tests
  double memoryLimit_bytes = 0;
};

}  // namespace loomlight
