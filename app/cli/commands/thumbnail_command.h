#pragma once

#include <string>

namespace loomlight {

/// loomlight thumbnail FABRIC -o OUT: what file managers show in place of an icon.
struct ThumbnailCommand {
  std::string input;
  std::string output;  ///< a PNG whatever its name: file managers give names without an extension
  int side = 256;      ///< pixels
};

/// Draws the drawdown in the colours of its yarns, which takes no light and so no time. Exit status 0. Throws
/// InputError.
int run(const ThumbnailCommand& command);

}  // namespace loomlight
