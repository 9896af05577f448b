#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/editor/model/recent_files.h"
#include "app/live/pass_scheduler.h"
#include "ui/dialogs/display_colours.h"
#include "ui/dock_layout.h"
#include "ui/draft/draft_view.h"
#include "ui/inspector/colour_book.h"
#include "ui/inspector/trade_units.h"
#include "ui/viewport/snapshot_options.h"

namespace loomlight {

/// Three eighths of the machine's memory: fibres of the viewport may take as much beside those of the inset.
double defaultFibreMemory_GB();

/// What the viewport may take.
struct ViewLimits {
  double fibreMemory_GB = defaultFibreMemory_GB();  ///< for the truth lens
  int samples = kUsualRest;                         ///< a pixel, at which the picture rests
};
inline constexpr int kSampleLimits[] = {1, 65536};

/// How pictures and drafts are looked at.
struct ViewSettings {
  bool denoised = false, filmic = true;
  double exposure_stops = 0;
  bool draftInColour = false, draftBack = false, marksFloats = false;
  bool booth = false;  ///< all its lamps, side by side
};

/// What the editor remembers from one session to the next; nothing of the fabric.
struct Settings {
  int windowWidth = 1440, windowHeight = 900;
  bool darkTheme = true;
  double rulerFactor = 1;   ///< how much longer a millimetre of the display is than the system says
  float interfaceSize = 1;  ///< beside what the monitor asks for
  DockLayout dock;
  ViewSettings view;
  DraftPreferences draft;
  DisplayColours colours;
  SnapshotOptions snapshot;
  TradeUnits units;
  ViewLimits limits;
  BookShelf books;                 ///< that colours were chosen from; the open one is to be opened
  double tolerance_cmc = 1;        ///< the largest CMC(2:1) that passes
  std::string folder;              ///< where files were last opened or saved
  std::vector<RecentFile> recent;  ///< the last one first
  bool hintsSeen = false;          ///< what to try first is known; false where there are no settings yet
};

/// A file that is missing or makes no sense gives the defaults: losing them costs a drag of a splitter.
Settings readSettings(const std::filesystem::path& file);
/// Throws InputError where they cannot be written; the old ones are still there then.
void writeSettings(const std::filesystem::path& file, const Settings& settings);

}  // namespace loomlight
