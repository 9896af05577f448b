#pragma once

#include <string>

#include "app/cli/fabric_options.h"
#include "app/cli/inputs.h"
#include "core/fabric/yarn/long_floats.h"
#include "core/fabric/yarn/yarn_need.h"

namespace loomlight {

/// loomlight info FABRIC: what follows from a fabric, without a picture.
struct InfoCommand {
  FabricSource input;
  FabricOptions options;
  PieceSize piece;                             ///< that yarn is needed for
  double floatLimit_mm = kUsualFloatLimit_mm;  ///< longer floats are listed; 0.1..100
  bool json = false;
};

/// A table with units, or JSON, on stdout. Exit status 0, or 130 when stopped. Throws InputError.
int run(const InfoCommand& command);

}  // namespace loomlight
