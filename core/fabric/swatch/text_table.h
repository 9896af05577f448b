#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace loomlight {

/// A table of text: lines of cells between commas, semicolons or tabs, whichever most lines have. Empty lines and
/// comments, from "#" on at the start of a line, are none; "#1A2B3C" is a colour.
class TextTable {
 public:
  struct Row {
    int line = 0;                         ///< in the file, from 1
    std::vector<std::string_view> cells;  ///< at least one; without blanks and quotes around
  };

  /// Views into `text`. Throws InputError, naming `source`, for more rows or cells than any table of colours has.
  TextTable(std::string_view text, const std::string& source);

  const std::vector<Row>& rows() const { return rows_; }
  bool hasPercentSign() const { return hasPercentSign_; }

  /// A number, with a decimal comma where no comma parts the cells; a "%" behind it is left out.
  std::optional<double> number(std::string_view cell) const;

  /// Throws InputError: source: line: expected.
  [[noreturn]] void wrong(int line, const std::string& expected) const;

 private:
  std::string source_;
  char separator_ = ',';
  bool hasPercentSign_ = false;
  std::vector<Row> rows_;
};

}  // namespace loomlight
