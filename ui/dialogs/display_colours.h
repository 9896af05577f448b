#pragma once

#include <string>

#include "ui/widgets/ui.h"

namespace loomlight {

/// How colours come to the eye. Kept from one session to the next.
struct DisplayColours {
  enum class Source { srgb, system, file };
  Source source = Source::system;  ///< of the display's profile
  std::string displayFile;         ///< of Source::file; empty: none was chosen
  std::string printerFile;         ///< whose prints can be shown; empty: none was chosen
  bool proofs = false;             ///< the picture is shown as that printer prints it
  bool warnsOfGamut = false;       ///< what it cannot print is marked, or of the picture itself what sRGB has not
};

/// What the profiles call themselves; empty where there is none.
struct ProfileNames {
  std::string system, display, printer;
};

/// Rows of the preferences. True: a profile is to be chosen.
bool displayColourRows(Ui& ui, const ProfileNames& names, DisplayColours& colours);

}  // namespace loomlight
