#pragma once

#include <string>

#include "app/export/cloth_sheet.h"

namespace loomlight {

/// loomlight sheet FABRIC -o OUT.pdf
struct SheetCommand {
  std::string input;
  std::string output;
  ClothSheetOptions options;
  bool colourways = false;  ///< all of them at 1 : 1, in the place of the sheet of the cloth
  int threads = 0;          ///< 0: all
};

/// Writes the page that goes to a mill (app/export/cloth_sheet.h). Exit status 0, or that of an interrupt. Throws
/// InputError.
int run(const SheetCommand& command);

}  // namespace loomlight
