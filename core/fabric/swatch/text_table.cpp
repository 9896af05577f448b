#include "core/fabric/swatch/text_table.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/fabric/swatch/raw_swatch.h"
#include "core/fabric/wif/wif_values.h"

namespace loomlight {
namespace {

constexpr size_t kMostRows = 100'000;
constexpr size_t kMostCells = 2000;  // of a row

bool isHexDigit(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
}

bool isComment(std::string_view line) {
  constexpr size_t kDigits = 6;
  if (!line.starts_with('#')) return false;
  const bool colour =
      line.size() > kDigits && std::all_of(line.begin() + 1, line.begin() + 1 + kDigits, isHexDigit) &&
      (line.size() == kDigits + 1 || std::string_view(",;\t \"").find(line[kDigits + 1]) != std::string_view::npos);
  return !colour;
}

/// A semicolon or a tab that is in most lines parts the cells of each; otherwise a comma does.
char separatorOf(std::string_view text) {
  int lines = 0, semicolons = 0, tabs = 0;
  while (!text.empty()) {
    const std::string_view line = trimmed(takeLine(text));
    if (line.empty() || isComment(line)) continue;
    ++lines;
    semicolons += line.find(';') != std::string_view::npos;
    tabs += line.find('\t') != std::string_view::npos;
  }
  return 2 * semicolons > lines ? ';' : 2 * tabs > lines ? '\t' : ',';
}

/// Where the first cell of a line ends; what stands in quotes may have separators in it, and doubled quotes.
size_t endOfCell(std::string_view line, char separator) {
  size_t from = 0;
  const size_t start = std::min(line.find_first_not_of(' '), line.size());
  if (line.substr(start).starts_with('"'))
    for (size_t quote = line.find('"', start + 1); quote != std::string_view::npos; quote = line.find('"', from)) {
      from = quote + 1;
      if (from == line.size() || line[from] != '"') break;
      ++from;
    }
  return std::min(line.find(separator, from), line.size());
}

}  // namespace

TextTable::TextTable(std::string_view text, const std::string& source)
    : source_(source), separator_(separatorOf(text)) {
  for (int number = 1; !text.empty(); ++number) {
    std::string_view line = trimmed(takeLine(text));
    if (line.empty() || isComment(line)) continue;
    if (rows_.size() == kMostRows) wrong(number, fmt::format("expected at most {} rows", kMostRows));
    hasPercentSign_ = hasPercentSign_ || line.find('%') != std::string_view::npos;
    std::vector<std::string_view> cells;
    for (;;) {
      const size_t end = endOfCell(line, separator_);
      cells.push_back(unquoted(line.substr(0, end)));
      if (cells.size() > kMostCells) wrong(number, fmt::format("expected at most {} cells", kMostCells));
      if (end == line.size()) break;
      line.remove_prefix(end + 1);
    }
    rows_.push_back({number, std::move(cells)});
  }
}

std::optional<double> TextTable::number(std::string_view cell) const {
  if (cell.ends_with('%')) cell.remove_suffix(1);
  return swatchNumber(cell, separator_ != ',');
}

void TextTable::wrong(int line, const std::string& expected) const {
  throw InputError(fmt::format("{}: line {}: {}", source_, line, expected));
}

}  // namespace loomlight
