#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/fabric/palette/colour_code.h"
#include "core/fabric/palette/palette_readers.h"
#include "core/fabric/swatch/raw_swatch.h"
#include "core/fabric/swatch/text_table.h"
#include "core/fabric/wif/wif_values.h"

// How it works. The first line that titles columns says what they are: "hex", or "r", "g" and "b", or "L", "a" and "b";
// the first other column is the name. Without such a line, rows that hold a code such as #1A2B3C are colours; and where
// there are none, the table is one of reflectances.

namespace loomlight {
namespace {

constexpr size_t kNone = static_cast<size_t>(-1);

/// A column's title without its trimmings: "L*" is "l".
std::string titleOf(std::string_view cell) {
  std::string title;
  for (const char c : lowerCase(cell))
    if (std::string_view(" *_()").find(c) == std::string_view::npos) title += c;
  return title;
}

/// Where the columns are that make a colour.
struct Columns {
  enum class Kind { none, hex, rgb, lab } kind = Kind::none;
  std::array<size_t, 3> at{kNone, kNone, kNone};
  size_t name = kNone;
};

std::array<size_t, 3> columnsOf(const TextTable::Row& row, std::array<std::array<const char*, 2>, 3> titles) {
  std::array<size_t, 3> at{kNone, kNone, kNone};
  for (size_t i = 0; i < row.cells.size(); ++i)
    for (size_t k = 0; k < 3; ++k)
      if (const std::string title = titleOf(row.cells[i]);
          at[k] == kNone && (title == titles[k][0] || title == titles[k][1]))
        at[k] = i;
  return at;
}

bool areAllThere(const std::array<size_t, 3>& at) {
  return std::find(at.begin(), at.end(), kNone) == at.end();
}

Columns columnsIn(const TextTable::Row& row) {
  Columns columns;
  const auto lab = columnsOf(row, {{{"l", "ciel"}, {"a", "ciea"}, {"b", "cieb"}}});
  const auto rgb = columnsOf(row, {{{"r", "red"}, {"g", "green"}, {"b", "blue"}}});
  const auto hex = columnsOf(row, {{{"hex", "html"}, {"hex", "html"}, {"hex", "html"}}});
  if (areAllThere(lab)) columns = {Columns::Kind::lab, lab};
  if (areAllThere(rgb)) columns = {Columns::Kind::rgb, rgb};
  if (areAllThere(hex)) columns = {Columns::Kind::hex, hex};
  for (size_t i = row.cells.size(); i-- > 0;)
    if (std::find(columns.at.begin(), columns.at.end(), i) == columns.at.end()) columns.name = i;
  for (size_t i = 0; i < row.cells.size(); ++i)
    if (titleOf(row.cells[i]) == "name") columns.name = i;
  return columns;
}

class TableReader {
 public:
  TableReader(std::string_view text, const std::string& source) : table_(text, source), source_(source) {}

  /// Empty where the table is none of colours.
  Palette all() {
    for (const TextTable::Row& row : table_.rows()) {
      if (columns_.kind == Columns::Kind::none) {
        columns_ = columnsIn(row);
        if (columns_.kind == Columns::Kind::none) takeCode(row);
      } else {
        take(row);
      }
    }
    if (columns_.kind == Columns::Kind::lab)
      palette_.remarks.push_back(
          "The file does not say the light of its L*, a* and b*; they are taken as of D50, 2 degrees.");
    if (columns_.kind == Columns::Kind::rgb) scale();
    return std::move(palette_);
  }

 private:
  std::string place(const TextTable::Row& row) const { return fmt::format("{}: line {}", source_, row.line); }

  static std::string cell(const TextTable::Row& row, size_t i) {
    return i < row.cells.size() ? std::string(row.cells[i]) : std::string();
  }

  /// A row without titles above: a code among its cells is the colour, the first other cell its name.
  void takeCode(const TextTable::Row& row) {
    for (size_t i = 0; i < row.cells.size(); ++i)
      if (const auto colour = hexColour(row.cells[i]); colour && row.cells[i].starts_with('#'))
        return addSrgb(palette_, cell(row, i == 0 ? 1 : 0), *colour, place(row));
  }

  void take(const TextTable::Row& row) {
    const std::string name = cell(row, columns_.name);
    if (columns_.kind == Columns::Kind::hex) {
      const std::optional<glm::dvec3> colour = hexColour(cell(row, columns_.at[0]));
      if (!colour) table_.wrong(row.line, "expected a colour such as #1A2B3C");
      return addSrgb(palette_, name, *colour, place(row));
    }
    glm::dvec3 numbers;
    for (int k = 0; k < 3; ++k) {
      const std::optional<double> number = table_.number(cell(row, columns_.at[k]));
      if (!number) table_.wrong(row.line, fmt::format("expected a number in column {}", columns_.at[k] + 1));
      numbers[k] = *number;
    }
    if (columns_.kind == Columns::Kind::lab)
      return addLab(palette_, name, {numbers.x, numbers.y, numbers.z}, place(row));
    rgb_.push_back({name, place(row), numbers});
  }

  /// Whether red, green and blue go to 1 or to 255 is a matter of the file.
  void scale() {
    double most = 1;
    for (const Rgb3& colour : rgb_)
      for (int c = 0; c < 3; ++c)
        if (colour.numbers[c] > 1) most = 255;
    for (Rgb3& colour : rgb_) addSrgb(palette_, std::move(colour.name), colour.numbers / most, colour.place);
  }

  struct Rgb3 {
    std::string name, place;
    glm::dvec3 numbers;
  };

  TextTable table_;
  const std::string& source_;
  Columns columns_;
  std::vector<Rgb3> rgb_;
  Palette palette_;
};

}  // namespace

Palette paletteFromTable(std::string_view text, const std::string& source) {
  Palette palette = TableReader(text, source).all();
  return palette.colours.empty() ? paletteOf(swatchesFromTable(text, source)) : palette;
}

}  // namespace loomlight
