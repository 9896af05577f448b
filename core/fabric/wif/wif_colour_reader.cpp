#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>
#include <span>

#include "core/base/text.h"
#include "core/fabric/wif/wif_entries.h"
#include "core/fabric/wif/wif_numbered.h"
#include "core/fabric/wif/wif_reader.h"

// How it works. Colours are gathered as they are written: those of [COLOR TABLE], and those that Color= of [WARP]
// and [WEFT] spells out, of which the ones without a number get one that is free. They are brought to red, green
// and blue in the palette's range: from hexadecimal digits, from hue, saturation and value. The range is what [COLOR
// PALETTE] says, or else the smallest usual one that all of them fit into. They stay whole numbers in that range
// where they are such, so that a file is written as it was read; others become steps of 1/65535. Every end and pick
// then gets the number of its own line, or of its system, or 0: the yarn's own colour. Cost: linear in the lines.

namespace loomlight {
namespace {

/// The number of a colour, from 1.
std::optional<int> counted(std::string_view text, const WifCounting& counting) {
  const std::optional<int> number = wifWhole(text);
  return number && *number <= kMaxWifNumber ? std::optional(*number + 1 - counting.colour) : std::nullopt;
}

struct RealRange {
  double low = 0, high = 255;
};

/// A colour as it is written.
struct Written {
  glm::dvec3 channels{0.0};
  bool isHex = false;  ///< #RRGGBB: from 0 to 255, whatever the range is
};

std::optional<Written> hexColour(std::string_view text) {
  for (const char* mark : {"#", "0x", "0X"})
    if (text.starts_with(mark)) text.remove_prefix(std::string_view(mark).size());
  uint32_t rgb = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), rgb, 16);
  if (text.size() != 6 || error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return Written{glm::dvec3(rgb >> 16, rgb >> 8 & 0xFF, rgb & 0xFF), true};
}

/// The colour behind the first so many parts of a list; nothing where it is none.
std::optional<Written> written(std::span<const std::string_view> parts) {
  if (parts.size() == 1 && !wifWhole(parts[0])) return hexColour(parts[0]);
  if (parts.size() != 3) return std::nullopt;
  Written colour;
  for (int i = 0; i < 3; ++i) {
    const std::optional<double> channel = wifDecimal(parts[static_cast<size_t>(i)]);
    if (!channel) return std::nullopt;
    colour.channels[i] = *channel;
  }
  return colour;
}

std::optional<Written> written(const WifSection& table, const WifEntry& entry, size_t first, WifWarnings& warnings) {
  const std::vector<std::string_view> parts = wifList(entry.value);
  std::optional<Written> colour;
  if (parts.size() > first) colour = written(std::span(parts).subspan(first));
  if (!colour)
    warnings.add(entry.line, table.name, entryText(entry),
                 "A colour should be three numbers, of red, green and blue; this one is passed over.",
                 WifConcern::look);
  return colour;
}

/// Color=red,green,blue, which the format does not know: where three numbers stand, and the first is no colour's.
bool isUnnumbered(const WifSections& sections, const WifCounting& counting, System system) {
  const WifEntry* const entry = findEntry(sections, sectionName(system), "color");
  if (!entry) return false;
  const std::vector<std::string_view> parts = wifList(entry->value);
  if (parts.size() != 3 || !written(parts)) return false;
  const std::optional<int> number = counted(parts[0], counting);
  const WifSection* const table = sections.find("COLOR TABLE");
  return !table || !number || std::none_of(table->entries.begin(), table->entries.end(), [&](const WifEntry& line) {
    return counted(line.key, counting) == number;
  });
}

glm::dvec3 rgbFromHsv(const glm::dvec3& hsv) {
  glm::dvec3 rgb;
  for (int i = 0; i < 3; ++i) {
    constexpr double kSectors[] = {5, 3, 1};
    const double k = std::fmod(kSectors[i] + 6.0 * hsv.x, 6.0);
    rgb[i] = hsv.z * (1.0 - hsv.y * std::clamp(std::min(k, 4.0 - k), 0.0, 1.0));
  }
  return rgb;
}

std::optional<RealRange> statedRange(const WifEntry* entry) {
  if (!entry) return std::nullopt;
  const std::vector<std::string_view> parts = wifList(entry->value);
  const auto low = parts.size() == 2 ? wifDecimal(parts[0]) : std::nullopt;
  const auto high = parts.size() == 2 ? wifDecimal(parts[1]) : std::nullopt;
  constexpr double kMost = 1e9;
  const bool isRange = low && high && *low < *high && std::abs(*low) <= kMost && std::abs(*high) <= kMost;
  return isRange ? std::optional(RealRange{*low, *high}) : std::nullopt;
}

RealRange rangeOf(const WifSections& sections, const std::map<int, Written>& colours, WifWarnings& warnings) {
  const WifEntry* const entry = findEntry(sections, "COLOR PALETTE", "range");
  if (const auto stated = statedRange(entry)) return *stated;
  RealRange range;
  double largest = 0;
  for (const auto& [number, colour] : colours)
    if (!colour.isHex) largest = std::max({largest, colour.channels.x, colour.channels.y, colour.channels.z});
  for (const double usual : {255.0, 999.0, 65535.0}) {
    range.high = usual;
    if (largest <= usual) break;
  }
  warnings.add(entry ? entry->line : 0, "COLOR PALETTE", entry ? entryText(*entry) : "Range",
               fmt::format("The lowest and highest of the colours' numbers should stand here; they are taken as 0 and "
                           "{:.0f}.",
                           range.high));
  return range;
}

bool isWhole(double value) {
  return value == std::floor(value);
}

/// The number that the colour of a system gets which stands there without one: none that the file names. Nothing where
/// no number is free.
std::optional<int> ownNumber(const WifSections& sections, const WifCounting& counting, System system) {
  std::set<int> named;
  const auto name = [&](std::string_view text) {
    const std::optional<int> number = counted(text, counting);
    if (number && *number >= 1 && *number <= kMaxWifNumber) named.insert(*number);
  };
  if (const WifSection* const table = sections.find("COLOR TABLE"))
    for (const WifEntry& entry : table->entries) name(entry.key);
  for (const System each : {System::warp, System::weft}) {
    const WifEntry* const entry = findEntry(sections, sectionName(each), "color");
    const auto parts = entry ? wifList(entry->value) : std::vector<std::string_view>();
    if (!parts.empty() && !isUnnumbered(sections, counting, each)) name(parts[0]);
  }
  if (system == System::weft && isUnnumbered(sections, counting, System::warp))
    if (const auto ofWarp = ownNumber(sections, counting, System::warp)) named.insert(*ofWarp);
  return freeWifNumber(named);
}

std::map<int, Written> writtenColours(const WifSections& sections, const WifCounting& counting, WifWarnings& warnings) {
  std::map<int, Written> colours;
  const WifSection* const table = sections.find("COLOR TABLE");
  forEachNumbered(table, counting.colour, kMaxWifNumber, "colour", warnings, [&](int number, const WifEntry& entry) {
    if (const auto colour = written(*table, entry, 0, warnings)) colours[number] = *colour;
  });
  // Color=number,red,green,blue names a colour that the table may lack.
  for (const System system : {System::warp, System::weft}) {
    const WifEntry* const entry = findEntry(sections, sectionName(system), "color");
    const auto parts = entry ? wifList(entry->value) : std::vector<std::string_view>();
    if (parts.size() < 2 || isUnnumbered(sections, counting, system)) continue;
    const std::optional<int> number = counted(parts[0], counting);
    if (!number || *number < 1 || *number > kMaxWifNumber || colours.count(*number) > 0) continue;
    if (const auto colour = written(*sections.find(sectionName(system)), *entry, 1, warnings))
      colours[*number] = *colour;
  }
  for (const System system : {System::warp, System::weft}) {
    if (!isUnnumbered(sections, counting, system)) continue;
    const WifEntry& entry = *findEntry(sections, sectionName(system), "color");
    const std::optional<int> number = ownNumber(sections, counting, system);
    if (number) colours[*number] = *written(wifList(entry.value));
    warnings.add(entry.line, sectionName(system), entryText(entry),
                 number ? "A colour stands here without its number; it is read as red, green and blue."
                        : "A colour stands here without its number, and no number is free; it is passed over.",
                 WifConcern::look);
  }
  return colours;
}

std::string formOf(const WifSections& sections) {
  const WifEntry* const form = findEntry(sections, "COLOR PALETTE", "form");
  return form ? lowerCase(unquoted(form->value)) : "rgb";
}

bool isHsv(const WifSections& sections) {
  const std::string form = formOf(sections);
  return form == "hsv" || form == "hsb";
}

/// Whether hue is in degrees, saturation and value per cent, though the format wants all three in one range: where all
/// numbers are so small, and the range that is stated, if any, does not hold them.
bool isInDegrees(const std::map<int, Written>& colours, const std::optional<RealRange>& stated) {
  bool fits = true, outside = !stated;
  for (const auto& [number, colour] : colours) {
    if (colour.isHex) continue;
    const glm::dvec3& hsv = colour.channels;
    fits = fits && glm::all(glm::greaterThanEqual(hsv, glm::dvec3(0))) && hsv.x <= 360 && hsv.y <= 100 && hsv.z <= 100;
    outside = outside || hsv.x > stated->high;
  }
  return fits && outside;
}

/// Brings hue, saturation and value into the range that red, green and blue will have.
RealRange fromDegrees(std::map<int, Written>& colours, WifWarnings& warnings) {
  warnings.add(0, "COLOR PALETTE", "", "Hue is taken as degrees, saturation and value as per cent.");
  constexpr double kMost = 65535;  // hues and values of three digits lose nothing
  for (auto& [number, colour] : colours)
    if (!colour.isHex) colour.channels *= kMost / glm::dvec3(360, 100, 100);
  return {0, kMost};
}

std::string heldTo(const RealRange& range) {
  return fmt::format("The numbers of a colour go from {:g} to {:g}; others are held to that.", range.low, range.high);
}

/// Colours of all forms as red, green and blue in the range.
void toRgb(std::map<int, Written>& colours, const WifSections& sections, const RealRange& range,
           WifWarnings& warnings) {
  const WifEntry* const form = findEntry(sections, "COLOR PALETTE", "form");
  const bool hasHues = isHsv(sections);
  if (form && formOf(sections) != "rgb")
    warnings.add(form->line, "COLOR PALETTE", entryText(*form),
                 hasHues
                     ? "Colours are of hue, saturation and value here; they are read so, and exported as red, green "
                       "and blue."
                     : "Colours of another form than RGB and HSV are not known; they are read as red, green and "
                       "blue.");
  const double span = range.high - range.low;
  for (auto& [number, colour] : colours) {
    if (colour.isHex) {
      colour.channels = range.low + glm::round(colour.channels / 255.0 * span);
    } else if (hasHues) {
      const glm::dvec3 inside = glm::clamp(colour.channels, range.low, range.high);
      if (inside != colour.channels) warnings.add(0, "COLOR TABLE", fmt::format("{}", number), heldTo(range));
      colour.channels = range.low + glm::round(span * rgbFromHsv((inside - range.low) / span));
    }
  }
}

}  // namespace

WifPalette readWifPalette(const WifSections& sections, const WifCounting& counting, WifWarnings& warnings) {
  std::map<int, Written> colours = writtenColours(sections, counting, warnings);
  if (colours.empty()) {
    if (sections.find("COLOR PALETTE"))
      warnings.add(0, "COLOR PALETTE", "", "A palette is announced, but there are no colours.");
    return {};
  }
  const bool inDegrees =
      isHsv(sections) && isInDegrees(colours, statedRange(findEntry(sections, "COLOR PALETTE", "range")));
  const RealRange range = inDegrees ? fromDegrees(colours, warnings) : rangeOf(sections, colours, warnings);
  toRgb(colours, sections, range, warnings);
  bool whole = isWhole(range.low) && isWhole(range.high);
  for (const auto& [number, colour] : colours) whole = whole && colour.channels == glm::floor(colour.channels);
  WifPalette palette;
  palette.low = whole ? static_cast<int>(range.low) : 0;
  palette.high = whole ? static_cast<int>(range.high) : 65535;
  if (!whole)
    warnings.add(0, "COLOR TABLE", "",
                 "Some colours have numbers that are not whole; they are kept in steps of 1/65535.");
  for (const auto& [number, colour] : colours) {
    const glm::dvec3 inside = glm::clamp(colour.channels, range.low, range.high);
    if (inside != colour.channels) warnings.add(0, "COLOR TABLE", fmt::format("{}", number), heldTo(range));
    const double steps = static_cast<double>(palette.high) - palette.low;
    for (int i = 0; i < 3; ++i)
      palette.colours[number][i] =
          palette.low + static_cast<int>(std::lround((inside[i] - range.low) / (range.high - range.low) * steps));
  }

  const WifEntry* const entries = findEntry(sections, "COLOR PALETTE", "entries");
  const std::optional<int> stated = entries ? wifWhole(entries->value) : std::nullopt;
  const int last = palette.colours.rbegin()->first;
  if (entries && stated != last && stated != static_cast<int>(palette.colours.size()))
    warnings.add(entries->line, "COLOR PALETTE", entryText(*entries),
                 fmt::format("The number of colours is another, {}; all of them are read.", palette.colours.size()));
  return palette;
}

std::vector<int> readWifColours(const WifSections& sections, const WifCounting& counting, System system, int threads,
                                const WifPalette& palette, WifWarnings& warnings) {
  const WifEntry* const common = findEntry(sections, sectionName(system), "color");
  /// The colour an entry names first; 0 where there is none of that number.
  const auto colourOf = [&](const std::string& section, const WifEntry& entry, const char* instead) {
    const std::vector<std::string_view> parts = wifList(entry.value);
    if (parts.empty()) return 0;
    if (&entry == common && isUnnumbered(sections, counting, system))
      return ownNumber(sections, counting, system).value_or(0);
    const std::optional<int> number = counted(parts[0], counting);
    if (number && palette.colours.count(*number) > 0) return *number;
    const char* const wrong =
        parts.size() > 1 ? "Expected the number of one colour of the table" : "There is no colour of this number";
    warnings.add(entry.line, section, entryText(entry), fmt::format("{}; {}.", wrong, instead));
    return 0;
  };
  const int usual = common ? colourOf(sectionName(system), *common, "the threads take the yarn's own colour") : 0;
  std::vector<int> colours(static_cast<size_t>(threads), usual);
  const std::string section = sectionName(system, " COLORS");
  forEachNumbered(sections.find(section), counting.firstLine(section), threads, "thread", warnings,
                  [&](int number, const WifEntry& entry) {
                    const int own = colourOf(section, entry, "the thread takes the usual colour");
                    colours[number - 1] = own > 0 ? own : usual;
                  });
  return colours;
}

}  // namespace loomlight
