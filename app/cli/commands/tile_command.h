#pragma once

#include <string>

#include "app/cli/fabric_options.h"
#include "app/cli/inputs.h"
#include "app/export/tile.h"
#include "render/transport/make_medium.h"

namespace loomlight {

/// loomlight tile FABRIC -o FOLDER
struct TileCommand {
  static constexpr int kSamples = 128;

  FabricSource input;
  std::string folder;  ///< made where there is none; the files are named after the fabric
  TileOrder order;
  FabricOptions options;  ///< samples, seed, method, colourway, resolution
  int threads = 0;        ///< 0: all
  double memoryLimit_bytes = defaultMemoryLimit_bytes();
};

/// Writes the maps of a seamless tile (app/export/tile.h). Exit status 0, or that of an interrupt. Throws InputError.
int run(const TileCommand& command);

}  // namespace loomlight
