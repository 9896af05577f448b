#include <fmt/format.h>

#include <algorithm>

#include "core/fabric/swatch/raw_swatch.h"
#include "core/fabric/swatch/text_table.h"

// How it works. Where a line titles six columns or more with wavelengths, each line below it is a swatch. Otherwise the
// first column is the wavelength, and each of the others is a swatch.

namespace loomlight {
namespace {

constexpr size_t kTitles = 6;  // of wavelengths make a line of titles
using Row = TextTable::Row;

class TableReader {
 public:
  TableReader(std::string_view text, const std::string& source) : table_(text, source), specular_(specularIn(text)) {
    expectNoKubelkaMunk(text, source);
  }

  std::vector<RawSwatch> all() const {
    for (size_t i = 0; i < table_.rows().size(); ++i)
      if (wavelengthsAmong(table_.rows()[i]) >= kTitles) return below(i);
    return beside();
  }

  ReflectanceUnit unit() const {
    if (table_.hasPercentSign()) return ReflectanceUnit::percent;
    return saysFraction() ? ReflectanceUnit::fraction : ReflectanceUnit::unsaid;
  }

 private:
  static size_t wavelengthsAmong(const Row& row) {
    return static_cast<size_t>(std::count_if(row.cells.begin(), row.cells.end(),
                                             [](std::string_view cell) { return wavelengthIn(cell).has_value(); }));
  }

  bool saysFraction() const {
    const auto says = [](std::string_view cell) { return saysWord(cell, "fraction") || saysWord(cell, "fractions"); };
    return std::any_of(table_.rows().begin(), table_.rows().end(),
                       [&](const Row& row) { return std::any_of(row.cells.begin(), row.cells.end(), says); });
  }

  RawSwatch swatchAt(int line) const {
    RawSwatch swatch;
    swatch.place = fmt::format("line {}", line);
    swatch.specular = specular_;
    return swatch;
  }

  /// Swatches are lines below their titles.
  std::vector<RawSwatch> below(size_t titles) const {
    std::vector<std::optional<double>> columns_nm;
    for (const std::string_view title : table_.rows()[titles].cells) columns_nm.push_back(wavelengthIn(title));
    std::vector<RawSwatch> swatches;
    for (size_t r = titles + 1; r < table_.rows().size(); ++r) {
      const Row& row = table_.rows()[r];
      RawSwatch swatch = swatchAt(row.line);
      for (size_t i = 0; i < columns_nm.size(); ++i) {
        const std::optional<double>& nm = columns_nm[i];
        const std::string_view cell = i < row.cells.size() ? row.cells[i] : std::string_view();
        if (!nm && swatch.name.empty()) swatch.name = cell;
        if (!nm) continue;
        const std::optional<double> value = table_.number(cell);
        if (!value) table_.wrong(row.line, fmt::format("expected a reflectance at {:g} nm", *nm));
        swatch.wavelengths_nm.push_back(*nm);
        swatch.values.push_back(*value);
      }
      if (swatches.size() == kMostSwatches)
        table_.wrong(row.line, fmt::format("expected at most {} swatches", kMostSwatches));
      swatches.push_back(std::move(swatch));
    }
    return swatches;
  }

  /// Swatches are columns beside the wavelengths; what comes before the first wavelength names them.
  std::vector<RawSwatch> beside() const {
    std::vector<RawSwatch> swatches;
    for (size_t r = 0; r < table_.rows().size(); ++r) {
      const Row& row = table_.rows()[r];
      const std::optional<double> nm = table_.number(row.cells[0]);
      if (!nm && swatches.empty()) continue;
      if (!nm) table_.wrong(row.line, "expected a wavelength in nm in the first column");
      if (swatches.empty()) swatches = named(r);
      if (row.cells.size() != swatches.size() + 1)
        table_.wrong(row.line, fmt::format("expected {} cells, as in the lines above; there are {}",
                                           swatches.size() + 1, row.cells.size()));
      for (size_t i = 0; i < swatches.size(); ++i) {
        const std::optional<double> value = table_.number(row.cells[i + 1]);
        if (!value) table_.wrong(row.line, fmt::format("expected a reflectance in column {}", i + 2));
        if (swatches[i].values.size() == kMostSwatchValues)
          table_.wrong(row.line, fmt::format("expected at most {} wavelengths", kMostSwatchValues));
        swatches[i].wavelengths_nm.push_back(*nm);
        swatches[i].values.push_back(*value);
      }
    }
    return swatches;
  }

  std::vector<RawSwatch> named(size_t first) const {
    if (table_.rows()[first].cells.size() < 2)
      table_.wrong(table_.rows()[first].line, "expected a wavelength and a reflectance, parted by a comma");
    std::vector<RawSwatch> swatches(table_.rows()[first].cells.size() - 1, swatchAt(table_.rows()[first].line));
    for (size_t i = 0; i < swatches.size(); ++i) {
      swatches[i].place = fmt::format("column {}", i + 2);
      if (first > 0 && i + 1 < table_.rows()[first - 1].cells.size())
        swatches[i].name = table_.rows()[first - 1].cells[i + 1];
    }
    return swatches;
  }

  TextTable table_;
  SpecularComponent specular_;
};

}  // namespace

SwatchFile swatchesFromTable(std::string_view text, const std::string& source) {
  const TableReader reader(text, source);
  return swatchesOf(reader.all(), reader.unit(), source,
                    "; write % or \"fraction\" into the line of titles, as in \"nm (fraction)\"");
}

}  // namespace loomlight
