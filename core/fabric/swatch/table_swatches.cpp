#include <fmt/format.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/fabric/swatch/raw_swatch.h"
#include "core/fabric/wif/wif_values.h"

// How it works. A table is lines of cells between commas, semicolons or tabs. Where a line
// titles six columns or more with wavelengths, each line below it is a swatch. Otherwise the first column is the
// wavelength, and each of the others is a swatch. With semicolons or tabs a comma is a decimal point.

namespace loomlight {
namespace {

constexpr size_t kTitles = 6;        // of wavelengths make a line of titles
constexpr size_t kMostCells = 2000;  // of a line

struct Row {
  int line = 0;
  std::vector<std::string_view> cells;
};

/// A semicolon or a tab that is in most lines parts the cells of each; otherwise a comma does.
char separatorOf(std::string_view text) {
  int lines = 0, semicolons = 0, tabs = 0;
  while (!text.empty()) {
    const std::string_view line = trimmed(takeLine(text));
    if (line.empty() || line.starts_with('#')) continue;
    ++lines;
    semicolons += line.find(';') != std::string_view::npos;
    tabs += line.find('\t') != std::string_view::npos;
  }
  return 2 * semicolons > lines ? ';' : 2 * tabs > lines ? '\t' : ',';
}

class Table {
 public:
  Table(std::string_view text, const std::string& source)
      : source_(source), separator_(separatorOf(text)), specular_(specularIn(text)) {
    int number = 0;
    while (!text.empty()) {
      const std::string_view line = trimmed(takeLine(text));
      ++number;
      if (line.empty() || line.starts_with('#')) continue;
      percent_ = percent_ || line.find('%') != std::string_view::npos;
      rows_.push_back({number, cellsOf(line, number)});
    }
  }

  std::vector<RawSwatch> all() const {
    for (size_t i = 0; i < rows_.size(); ++i)
      if (wavelengthsAmong(rows_[i]) >= kTitles) return below(i);
    return beside();
  }

  bool percent() const { return percent_; }

 private:
  [[noreturn]] void wrong(int line, const std::string& expected) const {
    throw InputError(fmt::format("{}: line {}: {}", source_, line, expected));
  }

  std::vector<std::string_view> cellsOf(std::string_view line, int number) const {
    std::vector<std::string_view> cells;
    for (;;) {
      const size_t end = std::min(line.find(separator_), line.size());
      cells.push_back(unquoted(line.substr(0, end)));
      if (cells.size() > kMostCells) wrong(number, fmt::format("expected at most {} cells", kMostCells));
      if (end == line.size()) break;
      line.remove_prefix(end + 1);
    }
    return cells;
  }

  std::optional<double> number(std::string_view cell) const {
    if (cell.ends_with('%')) cell.remove_suffix(1);
    return swatchNumber(cell, separator_ != ',');
  }

  static size_t wavelengthsAmong(const Row& row) {
    return static_cast<size_t>(std::count_if(row.cells.begin(), row.cells.end(),
                                             [](std::string_view cell) { return wavelengthIn(cell).has_value(); }));
  }

  RawSwatch swatchAt(int line) const {
    RawSwatch swatch;
    swatch.place = fmt::format("line {}", line);
    swatch.specular = specular_;
    return swatch;
  }

  /// Swatches are lines below their titles.
  std::vector<RawSwatch> below(size_t titles) const {
    const std::vector<std::string_view>& columns = rows_[titles].cells;
    std::vector<RawSwatch> swatches;
    for (size_t r = titles + 1; r < rows_.size(); ++r) {
      const Row& row = rows_[r];
      RawSwatch swatch = swatchAt(row.line);
      for (size_t i = 0; i < columns.size(); ++i) {
        const std::optional<double> nm = wavelengthIn(columns[i]);
        const std::string_view cell = i < row.cells.size() ? row.cells[i] : std::string_view();
        if (!nm && swatch.name.empty()) swatch.name = cell;
        if (!nm) continue;
        const std::optional<double> value = number(cell);
        if (!value) wrong(row.line, fmt::format("expected a reflectance at {:g} nm", *nm));
        swatch.wavelengths_nm.push_back(*nm);
        swatch.values.push_back(*value);
      }
      if (swatches.size() == kMostSwatches) wrong(row.line, fmt::format("expected at most {} swatches", kMostSwatches));
      swatches.push_back(std::move(swatch));
    }
    return swatches;
  }

  /// Swatches are columns beside the wavelengths; what comes before the first wavelength names them.
  std::vector<RawSwatch> beside() const {
    std::vector<RawSwatch> swatches;
    for (size_t r = 0; r < rows_.size(); ++r) {
      const Row& row = rows_[r];
      const std::optional<double> nm = number(row.cells[0]);
      if (!nm && swatches.empty()) continue;
      if (!nm) wrong(row.line, "expected a wavelength in nm in the first column");
      if (swatches.empty()) swatches = named(r);
      if (row.cells.size() != swatches.size() + 1)
        wrong(row.line, fmt::format("expected {} cells, as in the lines above; there are {}", swatches.size() + 1,
                                    row.cells.size()));
      for (size_t i = 0; i < swatches.size(); ++i) {
        const std::optional<double> value = number(row.cells[i + 1]);
        if (!value) wrong(row.line, fmt::format("expected a reflectance in column {}", i + 2));
        if (swatches[i].values.size() == kMostSwatchValues)
          wrong(row.line, fmt::format("expected at most {} wavelengths", kMostSwatchValues));
        swatches[i].wavelengths_nm.push_back(*nm);
        swatches[i].values.push_back(*value);
      }
    }
    return swatches;
  }

  std::vector<RawSwatch> named(size_t first) const {
    if (rows_[first].cells.size() < 2)
      wrong(rows_[first].line, "expected a wavelength and a reflectance, parted by a comma");
    std::vector<RawSwatch> swatches(rows_[first].cells.size() - 1, swatchAt(rows_[first].line));
    for (size_t i = 0; i < swatches.size(); ++i) {
      swatches[i].place = fmt::format("column {}", i + 2);
      if (first > 0 && i + 1 < rows_[first - 1].cells.size()) swatches[i].name = rows_[first - 1].cells[i + 1];
    }
    return swatches;
  }

  const std::string& source_;
  char separator_;
  SpecularComponent specular_;
  bool percent_ = false;
  std::vector<Row> rows_;
};

}  // namespace

SwatchFile swatchesFromTable(std::string_view text, const std::string& source) {
  const Table table(text, source);
  return swatchesOf(table.all(), table.percent() ? ReflectanceUnit::percent : ReflectanceUnit::guess, source);
}

}  // namespace loomlight
