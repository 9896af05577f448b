#pragma once

#include <optional>
#include <span>
#include <string>

#include "ui/widgets/ui.h"

namespace loomlight {

/// A cloth or draft that was opened or saved lately.
struct RecentFile {
  std::string file;      ///< absolute
  bool missing = false;  ///< when it was last looked for
};

struct RecentMenuChoice {
  std::optional<std::string> file;
  bool clear = false;
  bool appeared = false;  ///< the list has just come up: it is time to look which of them are still there
};

/// The menu of the files that were used lately, the last one first. Names are what they are known by; folders tell
/// apart what has one name.
RecentMenuChoice recentMenu(Ui& ui, std::span<const RecentFile> files);

}  // namespace loomlight
