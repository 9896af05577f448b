#pragma once

#include <string>

#include "ui/widgets/ui.h"

namespace loomlight {

/// Something that is rendered to a file behind a dialog.
struct RenderJob {
  bool running = false;
  double fraction = 0;
  std::string outcome;  ///< after it: what was written, or what went wrong
  bool failed = false;
};

struct RenderJobAnswer {
  bool start = false, cancel = false, close = false;
};

// Widgets are named after their dialog.

/// Below the row of the file, with its name: the path may go on beyond its field.
bool chooseFileButton(Ui& ui, const std::string& dialog, const std::string& file);
/// Pixels of the next above its buttons, for which a dialog whose rows scroll leaves room.
float renderJobHeight(const Ui& ui);
/// The last rows of the dialog: progress or outcome; Cancel or Close, and Render where a file is named, or
/// Replace where there is one already.
RenderJobAnswer renderJobRows(Ui& ui, const std::string& dialog, const RenderJob& job, const std::string& file);

}  // namespace loomlight
