#pragma once

#include <string>

#include "app/cli/fabric_options.h"
#include "app/cli/inputs.h"
#include "app/export/handover/digital_cloth.h"
#include "render/transport/make_medium.h"

namespace loomlight {

/// loomlight handover FABRIC -o FOLDER
struct HandoverCommand {
  static constexpr int kSamples = 32;  ///< a pixel, for each of four pictures

  FabricSource input;
  std::string folder;  ///< made where there is none; the files are named after the fabric
  DigitalClothOrder order;
  FabricOptions options;       ///< samples, seed, method, colourway, resolution
  bool allColourways = false;  ///< each in a folder of its own, beside that of the fabric's own colours
  int threads = 0;             ///< 0: all
  double memoryLimit_bytes = defaultMemoryLimit_bytes();
};

/// Writes a cloth in the formats of other programs (app/export/handover/cloth_handover.h). Exit status 0, or that of an
/// interrupt. Throws InputError.
int run(const HandoverCommand& command);

}  // namespace loomlight
