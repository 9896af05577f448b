#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "core/fabric/wif/wif_warnings.h"

namespace loomlight {

/// The layer of a WIF file below all meaning: sections, keys, values, comments. Names and keys are case-insensitive;
/// sections and keys come in any order, and more than once.

/// Largest file, and most lines, that are read; a draft of Weave::kMaxSide ends and picks has some 10^5.
inline constexpr size_t kMaxWifBytes = 32'000'000;
inline constexpr size_t kMaxWifLines = 2'000'000;
inline constexpr size_t kMaxWifSections = 4096;

struct WifEntry {
  std::string_view key;    ///< without blanks around
  std::string_view value;  ///< likewise; comments and quotes are still in it
  int line = 0;
};

struct WifSection {
  std::string name;  ///< as wifName() makes it
  int line = 0;      ///< of its first heading
  std::vector<WifEntry> entries;
  std::vector<std::string_view> lines;  ///< of a private section: all there is below the heading, as it is written

  /// The value of a key (lower case), the last one where there are several; null where there is none.
  const WifEntry* find(std::string_view key) const;
};

struct WifSections {
  std::vector<WifSection> sections;        ///< in file order; sections of one name are one
  std::vector<std::string_view> comments;  ///< lines, of the sections that WIF defines
  std::deque<std::string> joined;          ///< values that were continued on further lines

  const WifSection* find(std::string_view name) const;
};

/// Splits a text. All views point into `text` or `joined`. Throws InputError, naming `source`, for more lines or
/// sections than any draft has.
WifSections parseWifSections(std::string_view text, const std::string& source, WifWarnings& warnings);

/// A section's name without brackets, as this reader compares it: upper case, one blank between words, COLOR for
/// COLOUR.
std::string wifName(std::string_view heading);
/// Whether WIF 1.1 defines a section of that name; all others are private to some program.
bool isStandardWifSection(std::string_view name);
/// Where a section stands in a file as we write it, 0 first; all private ones have the same place, the last.
size_t wifSectionRank(std::string_view name);

}  // namespace loomlight
