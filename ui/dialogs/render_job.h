#pragma once

#include <string>

namespace loomlight {

/// Something that is rendered to a file behind a dialog.
struct RenderJob {
  bool running = false;
  double fraction = 0;
  std::string outcome;  ///< after it: what was written, or what went wrong
  bool failed = false;
};

}  // namespace loomlight
