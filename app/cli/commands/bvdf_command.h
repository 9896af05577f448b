#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "app/cli/fabric_options.h"
#include "app/cli/inputs.h"

namespace loomlight {

/// loomlight bvdf FABRIC -o OUT
struct BvdfCommand {
  FabricSource input;
  std::string output;  ///< .exr: the tables, and the picture beside them as .png; .png: the picture alone
  FabricOptions options;
  bool full = false;             ///< the report's 32 x 64^3 bins
  std::optional<uint64_t> rays;  ///< for each yarn
  int threads = 0;               ///< 0: all
};

/// Bakes the local visibility of a fabric's yarns, or takes it from the user's cache. Exit status 0, or 130 where it
/// was stopped; then nothing is written. Throws InputError.
int run(const BvdfCommand& command);

}  // namespace loomlight
