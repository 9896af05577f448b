#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/fabric_options.h"
#include "core/base/spectrum.h"
#include "core/fabric/wif/wif_fabric.h"

namespace loomlight {

/// One of two that are judged: a cloth or a part of it, or a measured swatch.
struct ColourSide {
  std::string file;  ///< a fabric, a draft, or a measured swatch (swatchFrom()); empty: there is none
  std::string part;  ///< a yarn's or a fibre's name (partNamed()); empty: the piece
  FabricOptions options;
};

/// `loomlight colour`: what a spectrophotometer and a light booth say of a cloth, and of it beside a standard.
struct ColourCommand {
  ColourSide sample;
  ColourSide standard;  ///< without a file but with a part or a colourway: of the sample's own cloth
  std::vector<std::string> illuminants{"D65", "F11", "A"};  ///< the first is the reference of metamerism
  Observer observer = Observer::degrees10;
  double tolerance = 1;  ///< largest CMC(2:1) that passes
  WifChoices wif;
  bool json = false;
  int threads = 0;

  static constexpr int kFails = 3;  ///< exit status that is no error, so that scripts tell a FAIL from a bad file
};

/// 0; kFails where there is a standard and the sample does not pass under the first illuminant.
int run(const ColourCommand& command);

}  // namespace loomlight
