#pragma once

#include <string>

namespace loomlight {

/// loomlight convert IN OUT
struct ConvertCommand {
  std::string input;   ///< .json, .png (weave bitmap) or .exr (a picture of ours)
  std::string output;  ///< .json or .png
  std::string like;    ///< a fabric that gives all but the weave; empty: none
};

/// Exit status 0. Throws InputError.
int run(const ConvertCommand& command);

}  // namespace loomlight
