#pragma once

#include <string>
#include <vector>

#include "app/cli/progress.h"
#include "render/colour/tone.h"

namespace loomlight {

/// loomlight merge PART... -o OUT
struct MergeCommand {
  std::vector<std::string> parts;  ///< .exr with sums
  std::string output;              ///< .exr or .png
  Tone tone;                       ///< of a .png
  bool keepSums = false;
  bool partial = false;  ///< whether samples may be missing
  ProgressStyle progress = ProgressStyle::plain;
};

/// Writes what one run over the samples of all parts writes, to the bit. Exit status: 0, or 130 where it was stopped.
/// Throws InputError where parts do not go together, or are not all there.
int run(const MergeCommand& command);

}  // namespace loomlight
