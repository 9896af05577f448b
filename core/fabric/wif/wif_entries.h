#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

#include "core/base/units.h"
#include "core/base/utf8.h"
#include "core/fabric/wif/wif_sections.h"

/// What the readers of a draft's sections share.
namespace loomlight {

/// A line as the file has it, for a warning; cut off where it is long.
inline std::string entryText(const WifEntry& entry) {
  return fmt::format("{}={}", entry.key, wholeCharacters(entry.value, 40));
}

/// Null where there is no such section, or no such key in it.
inline const WifEntry* findEntry(const WifSections& sections, std::string_view section, std::string_view key) {
  const WifSection* const found = sections.find(section);
  return found ? found->find(key) : nullptr;
}

/// "WARP" or "WEFT", and the rest of a section's name.
inline std::string sectionName(System system, const char* rest = "") {
  return fmt::format("{}{}", system == System::warp ? "WARP" : "WEFT", rest);
}

}  // namespace loomlight
