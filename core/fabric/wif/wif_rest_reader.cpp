#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <unordered_set>

#include "core/fabric/wif/wif_numbered.h"
#include "core/fabric/wif/wif_reader.h"

namespace loomlight {
namespace {

std::string said(const WifEntry& entry) {
  return fmt::format("{}={}", entry.key, entry.value.substr(0, 40));
}

const WifEntry* findEntry(const WifSections& sections, std::string_view section, std::string_view key) {
  const WifSection* const found = sections.find(section);
  return found ? found->find(key) : nullptr;
}

std::string name(System system, const char* rest = "") {
  return fmt::format("{}{}", system == System::warp ? "WARP" : "WEFT", rest);
}

// Colours

struct RealRange {
  double low = 0, high = 255;
};

/// The channels of one colour; nothing, with a warning, where they are no three numbers.
std::optional<glm::dvec3> channels(const WifSection& table, const WifEntry& entry, size_t first,
                                   WifWarnings& warnings) {
  const std::vector<std::string_view> parts = wifList(entry.value);
  glm::dvec3 colour(0.0);
  bool good = parts.size() == first + 3;
  for (int i = 0; i < 3 && good; ++i) {
    const std::optional<double> channel = wifDecimal(parts[first + static_cast<size_t>(i)]);
    good = channel.has_value();
    if (good) colour[i] = *channel;
  }
  if (good) return colour;
  warnings.add(entry.line, table.name, said(entry),
               "A colour should be three numbers, of red, green and blue; this one is passed over.");
  return std::nullopt;
}

RealRange rangeOf(const WifSections& sections, const std::map<int, glm::dvec3>& colours, WifWarnings& warnings) {
  const WifEntry* const entry = findEntry(sections, "COLOR PALETTE", "range");
  if (entry) {
    const std::vector<std::string_view> parts = wifList(entry->value);
    const auto low = parts.size() == 2 ? wifDecimal(parts[0]) : std::nullopt;
    const auto high = parts.size() == 2 ? wifDecimal(parts[1]) : std::nullopt;
    constexpr double kMost = 1e9;
    if (low && high && *low < *high && std::abs(*low) <= kMost && std::abs(*high) <= kMost) return {*low, *high};
  }
  RealRange range;
  double largest = 0;
  for (const auto& [number, colour] : colours) largest = std::max({largest, colour.x, colour.y, colour.z});
  for (const double usual : {255.0, 999.0, 65535.0}) {
    range.high = usual;
    if (largest <= usual) break;
  }
  warnings.add(entry ? entry->line : 0, "COLOR PALETTE", entry ? said(*entry) : "Range",
               fmt::format("The lowest and highest of the colours' numbers should stand here; they are taken as 0 and "
                           "{:.0f}.",
                           range.high));
  return range;
}

bool isRgb(const WifEntry& form) {
  return lowerCase(unquoted(form.value)) == "rgb";
}

bool isWhole(double value) {
  return value == std::floor(value);
}

WifPalette readPalette(const WifSections& sections, WifWarnings& warnings) {
  std::map<int, glm::dvec3> colours;
  const WifSection* const table = sections.find("COLOR TABLE");
  forEachNumbered(table, kMaxWifNumber, "colour", warnings, [&](int number, const WifEntry& entry) {
    if (const auto colour = channels(*table, entry, 0, warnings)) colours[number] = *colour;
  });
  // Color=number,red,green,blue names a colour that the table may lack.
  for (const System system : {System::warp, System::weft}) {
    const WifEntry* const entry = findEntry(sections, name(system), "color");
    const auto parts = entry ? wifList(entry->value) : std::vector<std::string_view>();
    const std::optional<int> number = parts.size() > 1 ? wifWhole(parts[0]) : std::nullopt;
    if (!number || *number < 1 || *number > kMaxWifNumber || colours.count(*number) > 0) continue;
    if (const auto colour = channels(*sections.find(name(system)), *entry, 1, warnings)) colours[*number] = *colour;
  }

  if (colours.empty()) {
    if (sections.find("COLOR PALETTE"))
      warnings.add(0, "COLOR PALETTE", "", "A palette is announced, but there are no colours.");
    return {};
  }
  if (const WifEntry* const form = findEntry(sections, "COLOR PALETTE", "form"); form && !isRgb(*form))
    warnings.add(form->line, "COLOR PALETTE", said(*form),
                 "Colours of another form than RGB are not known; they are read as red, green and blue.");
  const RealRange range = rangeOf(sections, colours, warnings);
  bool whole = isWhole(range.low) && isWhole(range.high);
  for (const auto& [number, colour] : colours)
    whole = whole && isWhole(colour.x) && isWhole(colour.y) && isWhole(colour.z);
  WifPalette palette;
  palette.low = whole ? static_cast<int>(range.low) : 0;
  palette.high = whole ? static_cast<int>(range.high) : 65535;
  if (!whole)
    warnings.add(0, "COLOR TABLE", "",
                 "Some colours have numbers that are not whole; they are kept in steps of 1/65535.");
  for (const auto& [number, colour] : colours) {
    const glm::dvec3 inside = glm::clamp(colour, range.low, range.high);
    if (inside != colour)
      warnings.add(
          0, "COLOR TABLE", fmt::format("{}", number),
          fmt::format("The numbers of a colour go from {:g} to {:g}; others are held to that.", range.low, range.high));
    const double steps = static_cast<double>(palette.high) - palette.low;
    for (int i = 0; i < 3; ++i)
      palette.colours[number][i] =
          palette.low + static_cast<int>(std::lround((inside[i] - range.low) / (range.high - range.low) * steps));
  }

  const WifEntry* const entries = findEntry(sections, "COLOR PALETTE", "entries");
  const std::optional<int> stated = entries ? wifWhole(entries->value) : std::nullopt;
  const int last = palette.colours.rbegin()->first;
  if (entries && stated != last && stated != static_cast<int>(palette.colours.size()))
    warnings.add(entries->line, "COLOR PALETTE", said(*entries),
                 fmt::format("The number of colours is another, {}; all of them are read.", palette.colours.size()));
  return palette;
}

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
  warnings.add(entry.line, section.name, said(entry),
               fmt::format("A length should be from {:g} to {:g}; this one is passed over.", 1 / kSteps, kMost));
  return std::nullopt;
}

ReadUnit readUnit(const WifSections& sections, System system, WifWarnings& warnings) {
  const WifEntry* const entry = findEntry(sections, name(system), "units");
  if (!entry) {
    const bool needed = findEntry(sections, name(system), "spacing") || findEntry(sections, name(system), "thickness");
    if (needed)
      warnings.add(0, name(system), "Units",
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
    warnings.add(entry->line, name(system), said(*entry),
                 "The format knows no millimetres; they are understood, and exported as centimetres.");
    return {WifUnit::centimeters, 0.1};
  }
  warnings.add(entry->line, name(system), said(*entry),
               "Lengths should be in decipoints, inches or centimetres; they are taken as centimetres.");
  return {};
}

WifSizes readSizes(const WifSections& sections, System system, WifWarnings& warnings) {
  WifSizes sizes;
  const ReadUnit written = readUnit(sections, system, warnings);
  sizes.unit = written.unit;
  const WifSection* const threads = sections.find(name(system));
  const auto common = [&](const char* key, std::optional<double>& value) {
    if (const WifEntry* const entry = findEntry(sections, name(system), key))
      value = length(*threads, *entry, written.factor, warnings);
  };
  common("spacing", sizes.spacing);
  common("thickness", sizes.thickness);
  const auto single = [&](const char* section, std::map<int, double>& values) {
    const WifSection* const found = sections.find(name(system, section));
    forEachNumbered(found, Weave::kMaxSide, "thread", warnings, [&](int number, const WifEntry& entry) {
      if (const auto value = length(*found, entry, written.factor, warnings)) values[number] = *value;
    });
  };
  single(" SPACING", sizes.spacings);
  single(" THICKNESS", sizes.thicknesses);
  return sizes;
}

// What is kept line by line

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

std::vector<std::string> keptLines(const WifSection& section) {
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
    if (!isUntrue) lines.push_back(fmt::format("{}={}", entry->key, entry->value));
  }
  std::reverse(lines.begin(), lines.end());
  return lines;
}

std::vector<WifLines> readKept(const WifSections& sections, bool coloured) {
  std::vector<WifLines> kept;
  WifLines head{"WIF", {}};
  if (const WifSection* const wif = sections.find("WIF")) head.lines = keptLines(*wif);
  head.lines.insert(head.lines.end(), sections.comments.begin(), sections.comments.end());
  if (!head.lines.empty()) kept.push_back(std::move(head));
  for (const WifSection& section : sections.sections) {
    if (section.name == "WIF" || (section.name == "COLOR PALETTE" && !coloured)) continue;
    std::vector<std::string> lines = keptLines(section);
    if (!lines.empty() || !isStandardWifSection(section.name)) kept.push_back({section.name, std::move(lines)});
  }
  std::stable_sort(kept.begin(), kept.end(), [](const WifLines& a, const WifLines& b) {
    return wifSectionRank(a.section) < wifSectionRank(b.section);
  });
  return kept;
}

}  // namespace

std::vector<int> readWifColours(const WifSections& sections, System system, int threads, const WifPalette& palette,
                                WifWarnings& warnings) {
  /// The colour an entry names first; 0 where there is none of that number.
  const auto colourOf = [&](const std::string& section, const WifEntry& entry, const char* instead) {
    const std::vector<std::string_view> parts = wifList(entry.value);
    if (parts.empty()) return 0;
    const std::optional<int> number = wifWhole(parts[0]);
    if (number && palette.colours.count(*number) > 0) return *number;
    warnings.add(entry.line, section, said(entry), fmt::format("There is no colour of this number; {}.", instead));
    return 0;
  };
  const WifEntry* const common = findEntry(sections, name(system), "color");
  const int usual = common ? colourOf(name(system), *common, "the threads take the yarn's own colour") : 0;
  std::vector<int> colours(static_cast<size_t>(threads), usual);
  const std::string section = name(system, " COLORS");
  forEachNumbered(sections.find(section), threads, "thread", warnings, [&](int number, const WifEntry& entry) {
    const int own = colourOf(section, entry, "the thread takes the usual colour");
    colours[number - 1] = own > 0 ? own : usual;
  });
  return colours;
}

WifRest readWifRest(const WifSections& sections, WifWarnings& warnings) {
  WifRest rest;
  rest.palette = readPalette(sections, warnings);
  rest.warp = readSizes(sections, System::warp, warnings);
  rest.weft = readSizes(sections, System::weft, warnings);
  rest.kept = readKept(sections, !rest.palette.colours.empty());
  return rest;
}

}  // namespace loomlight
