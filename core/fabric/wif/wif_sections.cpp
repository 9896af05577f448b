#include "core/fabric/wif/wif_sections.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <map>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/base/text_encoding.h"
#include "core/fabric/wif/wif_values.h"

// How it works. One pass, line by line: [a heading], key=value, ; a comment. A value that ends in a comma or a
// backslash goes on in the next line that has no key. Sections that the format knows are found by their names in
// capitals; all others are private to a program and kept as they are. A section that comes twice goes on where it
// was. Everything points into the text, but for joined values; the number of lines and of sections is bounded, and
// with them the memory. Cost: linear in the text.

namespace loomlight {
namespace {

/// In the order in which a file has them.
constexpr std::array kStandardSections = {"WIF",
                                          "CONTENTS",
                                          "COLOR PALETTE",
                                          "WARP SYMBOL PALETTE",
                                          "WEFT SYMBOL PALETTE",
                                          "TEXT",
                                          "WEAVING",
                                          "WARP",
                                          "WEFT",
                                          "NOTES",
                                          "TIEUP",
                                          "COLOR TABLE",
                                          "WARP SYMBOL TABLE",
                                          "WEFT SYMBOL TABLE",
                                          "THREADING",
                                          "WARP THICKNESS",
                                          "WARP THICKNESS ZOOM",
                                          "WARP SPACING",
                                          "WARP SPACING ZOOM",
                                          "WARP COLORS",
                                          "WARP SYMBOLS",
                                          "TREADLING",
                                          "LIFTPLAN",
                                          "WEFT THICKNESS",
                                          "WEFT THICKNESS ZOOM",
                                          "WEFT SPACING",
                                          "WEFT SPACING ZOOM",
                                          "WEFT COLORS",
                                          "WEFT SYMBOLS"};

class Parser {
 public:
  Parser(const std::string& source, WifWarnings& warnings) : source_(source), warnings_(warnings) {}

  void line(std::string_view raw) {
    if (static_cast<size_t>(++number_) > kMaxWifLines)
      throw InputError(fmt::format("{}: expected at most {} lines", source_, kMaxWifLines));
    const std::string_view text = trimmed(raw);
    if (text.starts_with('[')) {
      openSection(text);
    } else if (current_ < 0) {
      if (text.starts_with(';')) {
        sections_.comments.push_back(text);
      } else if (!text.empty()) {
        warnings_.add(number_, "", text, "This stands before the first heading, and is passed over.");
      }
    } else if (isPrivate_) {
      now().lines.push_back(raw);
    } else if (text.starts_with(';')) {
      sections_.comments.push_back(text);
    } else if (!text.empty()) {
      entry(text);
    }
  }

  WifSections finish() {
    for (WifSection& section : sections_.sections)
      while (!section.lines.empty() && trimmed(section.lines.back()).empty()) section.lines.pop_back();
    return std::move(sections_);
  }

 private:
  WifSection& now() { return sections_.sections[static_cast<size_t>(current_)]; }

  void openSection(std::string_view text) {
    const size_t end = text.find(']');
    if (end == std::string_view::npos)
      warnings_.add(number_, "", text, "This heading does not end in ]; it is read as if it did.");
    const std::string_view heading = text.substr(1, end == std::string_view::npos ? end : end - 1);
    std::string name = wifName(heading);
    isPrivate_ = !isStandardWifSection(name);
    const auto [position, isNew] = index_.emplace(name, sections_.sections.size());
    current_ = static_cast<long>(position->second);
    if (!isNew) {
      warnings_.add(number_, name, "", "This part comes twice; its lines are added to those above.");
      return;
    }
    if (index_.size() > kMaxWifSections)
      throw InputError(fmt::format("{}: expected at most {} sections", source_, kMaxWifSections));
    WifSection section;
    // A private section keeps the spelling that its program looks for.
    section.name = isPrivate_ ? std::string(trimmed(heading)) : std::move(name);
    section.line = number_;
    sections_.sections.push_back(std::move(section));
  }

  void entry(std::string_view text) {
    std::vector<WifEntry>& entries = now().entries;
    const size_t equals = text.find('=');
    if (equals != std::string_view::npos && equals > 0) {
      entries.push_back({trimmed(text.substr(0, equals)), trimmed(text.substr(equals + 1)), number_});
    } else if (!entries.empty() && continues(entries.back().value)) {
      std::string_view& value = entries.back().value;
      if (value.ends_with('\\')) value.remove_suffix(1);
      // A value that goes on over many lines grows in place: only the first one moves it.
      if (sections_.joined.empty() || joinedAt_ != entries.back().line) {
        sections_.joined.emplace_back(value);
        joinedAt_ = entries.back().line;
      }
      std::string& whole = sections_.joined.back();
      whole.resize(value.size());
      whole += text;
      value = whole;
      warnings_.add(number_, now().name, text, "A line broke off above and goes on here; the two are joined.");
    } else {
      warnings_.add(number_, now().name, text, "This line is not of the form key=value, and is passed over.");
    }
  }

  static bool continues(std::string_view value) { return value.ends_with(',') || value.ends_with('\\'); }

  const std::string& source_;
  WifWarnings& warnings_;
  WifSections sections_;
  std::map<std::string, size_t> index_;
  long current_ = -1;
  bool isPrivate_ = false;
  int number_ = 0;
  int joinedAt_ = 0;  ///< the line of the entry whose value is the last of `joined`
};

}  // namespace

const WifEntry* WifSection::find(std::string_view key) const {
  for (auto entry = entries.rbegin(); entry != entries.rend(); ++entry)
    if (lowerCase(entry->key) == key) return &*entry;
  return nullptr;
}

const WifSection* WifSections::find(std::string_view name) const {
  for (const WifSection& section : sections)
    if (section.name == name) return &section;
  return nullptr;
}

WifSections parseWifSections(std::string_view text, const std::string& source, WifWarnings& warnings) {
  Parser parser(source, warnings);
  while (!text.empty()) parser.line(takeLine(text));
  return parser.finish();
}

std::string wifName(std::string_view heading) {
  std::string name;
  for (const char c : trimmed(heading)) {
    const bool blank = c == ' ' || c == '\t';
    if (blank && name.ends_with(' ')) continue;
    name += blank ? ' ' : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  std::string american = name;
  if (const size_t at = american.find("COLOUR"); at != std::string::npos) american.erase(at + 4, 1);
  return isStandardWifSection(american) ? american : name;
}

bool isStandardWifSection(std::string_view name) {
  return wifSectionRank(name) < kStandardSections.size();
}

size_t wifSectionRank(std::string_view name) {
  return static_cast<size_t>(std::find(kStandardSections.begin(), kStandardSections.end(), name) -
                             kStandardSections.begin());
}

}  // namespace loomlight
