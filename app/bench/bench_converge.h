#pragma once

#include <string>

namespace loomlight {

/// loomlight bench converge: how fast pictures come near what they converge to, for six cloths under three lights, with
/// each way in which paths are sampled on and off.
struct ConvergeBenchCommand {
  std::string folder;  ///< where page and tables go
  bool quick = false;  ///< one cloth, a small picture, few paths: for tests
  int threads = 0;     ///< 0: all
};

/// Exit status 0, or 130 when stopped, without a page then. Throws InputError.
int run(const ConvergeBenchCommand& command);

}  // namespace loomlight
