#pragma once

#include <string>
#include <vector>

#include "app/cli/inputs.h"
#include "app/export/sheet/cloth_sheet.h"

namespace loomlight {

/// loomlight sheet FABRIC -o OUT.pdf
struct SheetCommand {
  FabricSource input;
  std::string output;
  ClothSheetOptions options;           ///< but for the standards
  std::vector<std::string> standards;  ///< a swatch (swatchFrom()) for the piece, or PART=SWATCH (partNamed())
  bool colourways = false;             ///< all of them at 1 : 1, in the place of the sheet of the cloth
  int threads = 0;                     ///< 0: all
};

/// A standard as it is written. Names of files come first, as they may have "=" of their own.
struct StandardChoice {
  std::string part;    ///< empty: the piece
  std::string swatch;  ///< of swatchFrom()
};
StandardChoice standardChoice(const std::string& text);

/// Writes the page that goes to a mill (app/export/sheet/cloth_sheet.h). Exit status 0, or that of an interrupt. Throws
/// InputError.
int run(const SheetCommand& command);

}  // namespace loomlight
