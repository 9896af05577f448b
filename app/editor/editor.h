#pragma once

#include <string>

namespace loomlight {

struct EditorOptions {
  std::string fabricFile;     ///< to open; empty: a sample cloth
  int width = 0, height = 0;  ///< of the window; 0: as it was left, or 1440 x 900
  float scale = 0;            ///< of the interface; 0: from the monitor
  int threads = 0;            ///< for tracing; 0: all
  std::string widgetDump;     ///< debugging and tests: a JSON file that always says where the named widgets are
};

/// Opens the window and runs until it is closed. Returns the exit status. Throws InputError when there is no display; a
/// file that cannot be read is said in the window.
int runEditor(const EditorOptions& options);

}  // namespace loomlight
