#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/fabric_options.h"
#include "core/base/spectrum.h"
#include "core/fabric/wif/wif_fabric.h"

namespace loomlight {

/// `loomlight colour`: what a spectrophotometer and a light booth say of a cloth, and of it beside a standard.
struct ColourCommand {
  std::string input;                                        ///< a fabric or draft, or a measured swatch
  std::string standard;                                     ///< likewise; empty: there is none
  std::vector<std::string> illuminants{"D65", "F11", "A"};  ///< the first is the reference of metamerism
  Observer observer = Observer::degrees10;
  double tolerance = 1;   ///< largest CMC(2:1) that passes
  FabricOptions options;  ///< of the input
  FabricOptions standardOptions;
  WifChoices wif;
  bool json = false;
  int threads = 0;
};

/// 0; 1 where a standard is given and the cloth does not pass under the first illuminant.
int run(const ColourCommand& command);

}  // namespace loomlight
