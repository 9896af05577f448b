#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <unordered_set>

#include "core/base/text.h"
#include "core/fabric/wif/wif_entries.h"
#include "core/fabric/wif/wif_numbered.h"
#include "core/fabric/wif/wif_reader.h"

// How it works. What a fabric has no place for is kept, so that a file which is written again still has it: colours
// by their numbers, spacing and thickness in the file's own unit and to a millionth of it, and line by line whatever
// nothing here reads. Of equal keys the last one counts. Lines that are numbered by ends or picks are counted from
// 1; private sections of programs stay as they are, letter by letter. Sections come in the order of the format.
// Cost: linear in the lines.

namespace loomlight {
namespace {

// Sizes

/// How lengths are written, and what they are multiplied by for a unit that the format has.
struct ReadUnit {
  WifUnit unit = WifUnit::centimeters;
  double factor = 1;
};

/// A length in a unit that the format has, held to a millionth of it, so that it is written as it was read.
std::optional<double> length(const WifSection& section, const WifEntry& entry, double factor, WifWarnings& warnings) {
  if (entry.value.empty()) return std::nullopt;  // as if the line were not there
  constexpr double kSteps = 1e6, kMost = 1e5;
  const std::optional<double> value = wifDecimal(entry.value);
  const double held = value && *value <= kMost ? std::round(*value * factor * kSteps) / kSteps : 0;
  if (held > 0) return held;
  warnings.add(entry.line, section.name, entryText(entry),
               fmt::format("A length should be from {:g} to {:g}; this one is passed over.", 1 / kSteps, kMost));
  return std::nullopt;
}

ReadUnit readUnit(const WifSections& sections, System system, WifWarnings& warnings) {
  const WifEntry* const entry = findEntry(sections, sectionName(system), "units");
  if (!entry) {
    const bool needed =
        findEntry(sections, sectionName(system), "spacing") || findEntry(sections, sectionName(system), "thickness");
    if (needed)
      warnings.add(0, sectionName(system), "Units",
                   "It is not said in which unit lengths are; they are taken as centimetres.");
    return {};
  }
  const std::string unit = lowerCase(unquoted(entry->value.substr(0, entry->value.find(';'))));
  const auto isOne = [&unit](std::initializer_list<const char*> names) {
    return std::find(names.begin(), names.end(), unit) != names.end();
  };
  if (unit == "decipoints") return {WifUnit::decipoints};
  if (isOne({"inches", "inch", "in", "english"})) return {WifUnit::inches};
  if (isOne({"centimeters", "centimetres", "centimeter", "centimetre", "cm", "metric"})) return {};
  if (isOne({"millimeters", "millimetres", "millimeter", "millimetre", "mm"})) {
    warnings.add(entry->line, sectionName(system), entryText(*entry),
                 "The format knows no millimetres; they are understood, and exported as centimetres.");
    return {WifUnit::centimeters, 0.1};
  }
  warnings.add(entry->line, sectionName(system), entryText(*entry),
               "Lengths should be in decipoints, inches or centimetres; they are taken as centimetres.");
  return {};
}

WifSizes readSizes(const WifSections& sections, System system, const WifCounting& counting, WifWarnings& warnings) {
  WifSizes sizes;
  const ReadUnit written = readUnit(sections, system, warnings);
  sizes.unit = written.unit;
  const WifSection* const threads = sections.find(sectionName(system));
  const auto common = [&](const char* key, std::optional<double>& value) {
    if (const WifEntry* const entry = findEntry(sections, sectionName(system), key))
      value = length(*threads, *entry, written.factor, warnings);
  };
  common("spacing", sizes.spacing);
  common("thickness", sizes.thickness);
  const auto single = [&](const char* section, std::map<int, double>& values) {
    const std::string name = sectionName(system, section);
    const WifSection* const found = sections.find(name);
    forEachNumbered(found, counting.firstLine(name), Weave::kMaxSide, "thread", warnings,
                    [&](int number, const WifEntry& entry) {
                      if (const auto value = length(*found, entry, written.factor, warnings)) values[number] = *value;
                    });
  };
  single(" SPACING", sizes.spacings);
  single(" THICKNESS", sizes.thicknesses);
  return sizes;
}

// What is kept line by line

bool isRgb(const WifEntry& form) {
  return lowerCase(unquoted(form.value)) == "rgb";
}

/// The keys of a section that are read; all of its keys where there are none here.
struct KnownKeys {
  const char* section;
  std::vector<const char*> keys;
};

const std::vector<KnownKeys>& knownKeys() {
  static const std::vector<KnownKeys> known = {
      {"WIF", {"version", "date", "developers", "source program", "source version"}},
      {"TEXT", {"title"}},
      {"WEAVING", {"shafts", "treadles", "rising shed"}},
      {"WARP", {"threads", "color", "units", "spacing", "thickness"}},
      {"WEFT", {"threads", "color", "units", "spacing", "thickness"}},
      {"COLOR PALETTE", {"entries", "range"}},
      {"CONTENTS", {}},
      {"NOTES", {}},
      {"COLOR TABLE", {}},
      {"THREADING", {}},
      {"TIEUP", {}},
      {"TREADLING", {}},
      {"LIFTPLAN", {}},
      {"WARP COLORS", {}},
      {"WEFT COLORS", {}},
      {"WARP SPACING", {}},
      {"WEFT SPACING", {}},
      {"WARP THICKNESS", {}},
      {"WEFT THICKNESS", {}},
  };
  return known;
}

/// The key as files that count from 1 have it, which is how it is handed back: of lines about single threads.
std::string keptKey(const WifSection& section, const WifEntry& entry, const WifCounting& counting) {
  const bool ofThreads = section.name.ends_with(" SYMBOLS") || section.name.ends_with(" ZOOM");
  const std::optional<int> number =
      ofThreads && counting.firstLine(section.name) == 0 ? wifWhole(entry.key) : std::nullopt;
  return number && *number >= 0 && *number < Weave::kMaxSide ? fmt::format("{}", *number + 1) : std::string(entry.key);
}

std::vector<std::string> keptLines(const WifSection& section, const WifCounting& counting) {
  if (!isStandardWifSection(section.name)) return {section.lines.begin(), section.lines.end()};
  const auto known = std::find_if(knownKeys().begin(), knownKeys().end(),
                                  [&](const KnownKeys& one) { return section.name == one.section; });
  const bool readWhole = known != knownKeys().end() && known->keys.empty();
  std::vector<std::string> lines;
  if (readWhole) return lines;
  std::unordered_set<std::string> seen;
  if (known != knownKeys().end()) seen.insert(known->keys.begin(), known->keys.end());
  // From the end, because the last of equal keys counts.
  for (auto entry = section.entries.rbegin(); entry != section.entries.rend(); ++entry) {
    const std::string key = lowerCase(entry->key);
    if (!seen.insert(key).second) continue;
    // Colours go out as red, green and blue, so that another form would be wrong from now on.
    const bool isUntrue = section.name == "COLOR PALETTE" && key == "form" && !isRgb(*entry);
    if (!isUntrue) lines.push_back(fmt::format("{}={}", keptKey(section, *entry, counting), entry->value));
  }
  std::reverse(lines.begin(), lines.end());
  return lines;
}

std::vector<WifLines> readKept(const WifSections& sections, const WifCounting& counting, bool coloured) {
  std::vector<WifLines> kept;
  WifLines head{"WIF", {}};
  if (const WifSection* const wif = sections.find("WIF")) head.lines = keptLines(*wif, counting);
  head.lines.insert(head.lines.end(), sections.comments.begin(), sections.comments.end());
  if (!head.lines.empty()) kept.push_back(std::move(head));
  for (const WifSection& section : sections.sections) {
    if (section.name == "WIF" || (section.name == "COLOR PALETTE" && !coloured)) continue;
    std::vector<std::string> lines = keptLines(section, counting);
    if (!lines.empty() || !isStandardWifSection(section.name)) kept.push_back({section.name, std::move(lines)});
  }
  std::stable_sort(kept.begin(), kept.end(), [](const WifLines& a, const WifLines& b) {
    return wifSectionRank(a.section) < wifSectionRank(b.section);
  });
  return kept;
}

}  // namespace

WifRest readWifRest(const WifSections& sections, const WifCounting& counting, WifWarnings& warnings) {
  WifRest rest;
  rest.palette = readWifPalette(sections, counting, warnings);
  rest.warp = readSizes(sections, System::warp, counting, warnings);
  rest.weft = readSizes(sections, System::weft, counting, warnings);
  rest.kept = readKept(sections, counting, !rest.palette.colours.empty());
  return rest;
}

}  // namespace loomlight
