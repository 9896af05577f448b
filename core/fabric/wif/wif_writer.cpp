#include "core/fabric/wif/wif_writer.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/text.h"
#include "core/fabric/wif/wif_sections.h"
#include "core/fabric/wif/wif_values.h"

namespace loomlight {
namespace {

using Lines = std::vector<std::string>;

std::string oneLine(std::string text) {
  std::replace_if(text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r' || c == '\0'; }, ' ');
  return text;
}

/// A text on one line; in quotes where a reader would take something off its ends.
std::string quotedWhereNeeded(const std::string& text) {
  const std::string line = oneLine(text);
  const bool stripped = trimmed(line).size() != line.size() || unquoted(line).size() != line.size();
  return stripped ? '"' + line + '"' : line;
}

/// A length in steps of a millionth, without zeros at its end and never with an exponent.
std::string decimal(double value) {
  std::string text = fmt::format("{:.6f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text;
}

/// Gathers sections, piece by piece: what is added under a name comes below what is there.
class Writer {
 public:
  void head(const WifDocument& document) {
    add("WIF", {"Version=1.1", "Date=April 20, 1997", "Developers=wif@mhsoft.com", "Source Program=Loomlight",
                std::string("Source Version=") + LOOMLIGHT_VERSION});
    if (!document.title.empty()) add("TEXT", {"Title=" + quotedWhereNeeded(document.title)});
    const Draft& draft = document.draft;
    add("WEAVING", {fmt::format("Shafts={}", draft.shafts), fmt::format("Treadles={}", draft.treadles),
                    fmt::format("Rising Shed={}", draft.risingShed)});
    Lines notes;
    for (const std::string& note : document.notes)
      notes.push_back(numbered(notes.size() + 1, std::string(trimmed(oneLine(note)))));
    addFilled("NOTES", notes);
  }

  void palette(const WifPalette& palette) {
    if (palette.colours.empty()) return;
    add("COLOR PALETTE", {fmt::format("Entries={}", palette.colours.rbegin()->first),
                          fmt::format("Range={},{}", palette.low, palette.high)});
    Lines table;
    for (const auto& [number, c] : palette.colours) table.push_back(fmt::format("{}={},{},{}", number, c.x, c.y, c.z));
    add("COLOR TABLE", table);
  }

  void threads(const char* system, const std::vector<int>& colours) {
    add(system, {fmt::format("Threads={}", colours.size())});
    const bool oneColour = std::equal(colours.begin() + 1, colours.end(), colours.begin());
    if (oneColour && colours[0] > 0) add(system, {fmt::format("Color={}", colours[0])});
    if (oneColour) return;
    Lines each;
    for (size_t i = 0; i < colours.size(); ++i)
      if (colours[i] > 0) each.push_back(numbered(i + 1, std::to_string(colours[i])));
    add(fmt::format("{} COLORS", system), each);
  }

  void sizes(const char* system, const WifSizes& sizes) {
    static constexpr const char* kUnits[] = {"Decipoints", "Inches", "Centimeters"};
    if (!(sizes == WifSizes{})) add(system, {fmt::format("Units={}", kUnits[static_cast<size_t>(sizes.unit)])});
    if (sizes.spacing) add(system, {"Spacing=" + decimal(*sizes.spacing)});
    if (sizes.thickness) add(system, {"Thickness=" + decimal(*sizes.thickness)});
    single(fmt::format("{} SPACING", system), sizes.spacings);
    single(fmt::format("{} THICKNESS", system), sizes.thicknesses);
  }

  void draft(const Draft& draft) {
    add("THREADING", lists(draft.threading));
    if (!draft.tieUp.empty()) add("TIEUP", lists(draft.tieUp));
    if (!draft.treadling.empty()) add("TREADLING", lists(draft.treadling));
    if (!draft.liftplan.empty()) add("LIFTPLAN", lists(draft.liftplan));
  }

  /// `ends` and `picks`: lines that name a thread beyond them are left out; 0 keeps all.
  void kept(const std::vector<WifLines>& all, int ends, int picks) {
    for (const WifLines& lines : all) {
      const std::string& name = lines.section;
      const bool single = isStandardWifSection(name) && (name.ends_with(" SYMBOLS") || name.ends_with(" ZOOM"));
      const int threads = name.starts_with("WARP") ? ends : picks;
      if (single && threads > 0) {
        Lines inside;
        for (const std::string& line : lines.lines)
          if (wifWhole(line.substr(0, line.find('='))).value_or(0) <= threads) inside.push_back(line);
        addFilled(name, inside);
      } else {
        add(name, lines.lines);
      }
    }
  }

  Lines lines() const {
    Lines all;
    for (const WifLines& section : sections_) {
      all.push_back('[' + section.section + ']');
      all.insert(all.end(), section.lines.begin(), section.lines.end());
      all.emplace_back();
    }
    return all;
  }

  /// [CONTENTS], second, of all that is there; but a private section of a name that would be read there as something
  /// else cannot be listed.
  void contents() {
    WifLines contents{"CONTENTS", {}};
    const auto isKey = [](const std::string& name) {
      return !name.empty() && name.find('=') == std::string::npos && name.front() != '[' && name.front() != ';';
    };
    for (const WifLines& section : sections_)
      if (section.section != "WIF" && isKey(section.section)) contents.lines.push_back(section.section + "=true");
    sections_.insert(sections_.begin() + 1, std::move(contents));
  }

  void sort() {
    std::stable_sort(sections_.begin(), sections_.end(), [](const WifLines& a, const WifLines& b) {
      return wifSectionRank(a.section) < wifSectionRank(b.section);
    });
  }

 private:
  static std::string numbered(size_t number, const std::string& value) { return fmt::format("{}={}", number, value); }

  void add(const std::string& name, const Lines& lines) {
    auto section =
        std::find_if(sections_.begin(), sections_.end(), [&](const WifLines& s) { return s.section == name; });
    if (section == sections_.end()) section = sections_.insert(sections_.end(), {name, {}});
    section->lines.insert(section->lines.end(), lines.begin(), lines.end());
  }
  void addFilled(const std::string& name, const Lines& lines) {
    if (!lines.empty()) add(name, lines);
  }

  static Lines lists(const NumberLists& lists) {
    Lines lines;
    for (const std::vector<int>& list : lists)
      lines.push_back(numbered(lines.size() + 1, list.empty() ? "0" : fmt::format("{}", fmt::join(list, ","))));
    return lines;
  }

  void single(const std::string& section, const std::map<int, double>& values) {
    Lines lines;
    for (const auto& [thread, value] : values) lines.push_back(numbered(static_cast<size_t>(thread), decimal(value)));
    addFilled(section, lines);
  }

  std::vector<WifLines> sections_;
};

}  // namespace

std::string wifFromDocument(const WifDocument& document) {
  Writer writer;
  writer.head(document);
  writer.palette(document.rest.palette);
  writer.threads("WARP", document.warpColours);
  writer.threads("WEFT", document.weftColours);
  writer.sizes("WARP", document.rest.warp);
  writer.sizes("WEFT", document.rest.weft);
  writer.draft(document.draft);
  writer.kept(document.rest.kept, document.ends(), document.picks());
  writer.sort();
  writer.contents();
  std::string text;
  for (const std::string& line : writer.lines()) text.append(line).append("\r\n");
  return text;
}

std::vector<std::string> wifRestLines(const WifRest& rest) {
  Writer writer;
  writer.palette(rest.palette);
  writer.sizes("WARP", rest.warp);
  writer.sizes("WEFT", rest.weft);
  writer.kept(rest.kept, 0, 0);
  return writer.lines();
}

}  // namespace loomlight
