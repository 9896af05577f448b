#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/fabric/model/wif_document.h"
#include "core/fabric/wif/wif_sections.h"
#include "core/fabric/wif/wif_warnings.h"

namespace loomlight {

/// What numbers begin with: 1, as the format has it, or 0, as some programs write them.
struct WifCounting {
  int end = 1, pick = 1;
  int tiedTreadle = 1;     ///< the lines of the tie-up
  int pressedTreadle = 1;  ///< what the treadling names
  int shaft = 1;
  int colour = 1;
  int note = 1;
  std::vector<std::string> fromOne;  ///< sections of single threads that count from 1, whatever the threads do

  /// The number that the first line of a section of single threads has: of WARP COLORS, WEFT SPACING...
  int firstLine(std::string_view section) const;
};

/// How a file counts: from 0 what has a line 0, unless it has the line of the last as well, which comes only where 1 is
/// the first. Says in `warnings` what is counted from 0.
WifCounting wifCounting(const WifSections& sections, WifWarnings& warnings);

/// The number of threads, shafts, treadles, colours that a key states; 0 where it states none.
int statedNumber(const WifSections& sections, std::string_view section, std::string_view key);

}  // namespace loomlight
