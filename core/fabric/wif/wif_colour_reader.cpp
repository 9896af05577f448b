#include <algorithm>
#include <cmath>

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

/// The number of a colour, from 1.
std::optional<int> counted(std::string_view text, const WifCounting& counting) {
  const std::optional<int> number = wifWhole(text);
  return number && *number <= kMaxWifNumber ? std::optional(*number + 1 - counting.colour) : std::nullopt;
}

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

bool isWhole(double value) {
  return value == std::floor(value);
}

}  // namespace

WifPalette readWifPalette(const WifSections& sections, const WifCounting& counting, WifWarnings& warnings) {
  std::map<int, glm::dvec3> colours;
  const WifSection* const table = sections.find("COLOR TABLE");
  forEachNumbered(table, counting.colour, kMaxWifNumber, "colour", warnings, [&](int number, const WifEntry& entry) {
    if (const auto colour = channels(*table, entry, 0, warnings)) colours[number] = *colour;
  });
  // Color=number,red,green,blue names a colour that the table may lack.
  for (const System system : {System::warp, System::weft}) {
    const WifEntry* const entry = findEntry(sections, name(system), "color");
    const auto parts = entry ? wifList(entry->value) : std::vector<std::string_view>();
    const std::optional<int> number = parts.size() > 1 ? counted(parts[0], counting) : std::nullopt;
    if (!number || *number < 1 || *number > kMaxWifNumber || colours.count(*number) > 0) continue;
    if (const auto colour = channels(*sections.find(name(system)), *entry, 1, warnings)) colours[*number] = *colour;
  }

  if (colours.empty()) {
    if (sections.find("COLOR PALETTE"))
      warnings.add(0, "COLOR PALETTE", "", "A palette is announced, but there are no colours.");
    return {};
  }
  if (const WifEntry* const form = findEntry(sections, "COLOR PALETTE", "form");
      form && lowerCase(unquoted(form->value)) != "rgb")
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

std::vector<int> readWifColours(const WifSections& sections, const WifCounting& counting, System system, int threads,
                                const WifPalette& palette, WifWarnings& warnings) {
  /// The colour an entry names first; 0 where there is none of that number.
  const auto colourOf = [&](const std::string& section, const WifEntry& entry, const char* instead) {
    const std::vector<std::string_view> parts = wifList(entry.value);
    if (parts.empty()) return 0;
    const std::optional<int> number = counted(parts[0], counting);
    if (number && palette.colours.count(*number) > 0) return *number;
    warnings.add(entry.line, section, said(entry), fmt::format("There is no colour of this number; {}.", instead));
    return 0;
  };
  const WifEntry* const common = findEntry(sections, name(system), "color");
  const int usual = common ? colourOf(name(system), *common, "the threads take the yarn's own colour") : 0;
  std::vector<int> colours(static_cast<size_t>(threads), usual);
  const std::string section = name(system, " COLORS");
  const int first = system == System::warp ? counting.end : counting.pick;
  forEachNumbered(sections.find(section), first, threads, "thread", warnings, [&](int number, const WifEntry& entry) {
    const int own = colourOf(section, entry, "the thread takes the usual colour");
    colours[number - 1] = own > 0 ? own : usual;
  });
  return colours;
}

}  // namespace loomlight
