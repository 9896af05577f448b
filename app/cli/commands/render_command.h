#pragma once

#include <string>

#include "app/cli/fabric_options.h"
#include "core/fabric/wif/wif_fabric.h"
#include "render/colour/tone.h"
#include "render/transport/make_medium.h"

namespace loomlight {

/// loomlight render FABRIC -o OUT
struct RenderCommand {
  std::string input;   ///< a fabric, or a picture that carries one; may be empty where `resume` is not
  std::string output;  ///< .exr or .png
  FabricOptions options;
  WifChoices wif;                                         ///< of a draft
  Tone tone;                                              ///< of a .png
  int threads = 0;                                        ///< 0: all
  double memoryLimit_bytes = defaultMemoryLimit_bytes();  ///< of explicit fibres
  FibreExtent fibreExtent = FibreExtent::automatic;
  std::string stats;   ///< file for the figures; empty: none
  std::string resume;  ///< an .exr with sums, to be continued; empty: none
  bool keepSums = false;
};

/// Renders, and writes the picture. Exit status: 0, or 130 where Ctrl-C ended it early (the picture then holds what
/// was rendered). Throws InputError and UsageError.
int run(const RenderCommand& command);

}  // namespace loomlight
