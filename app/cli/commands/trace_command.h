#pragma once

#include <cstdint>
#include <string>

#include "app/cli/fabric_options.h"
#include "app/cli/inputs.h"
#include "render/transport/make_medium.h"

namespace loomlight {

/// loomlight trace FABRIC --pixel X,Y --sample N: the path of one sample of one pixel again, in words. With the options
/// that a picture was rendered with, or with the picture itself as FABRIC, it is the very path that this picture holds.
struct TraceCommand {
  FabricSource input;
  FabricOptions options;
  PixelChoice pixel;
  uint32_t sample = 0;
  int threads = 0;  ///< to build with; 0: all
  double memoryLimit_bytes = defaultMemoryLimit_bytes();
  FibreExtent fibreExtent = FibreExtent::automatic;
};

/// Prints the path. Exit status 0, or 130 when stopped. Throws InputError, and UsageError for a pixel that the picture
/// does not have.
int run(const TraceCommand& command);

}  // namespace loomlight
