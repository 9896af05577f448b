#include "core/fabric/wif/wif_values.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/base/text.h"

namespace loomlight {
namespace {

/// A number's or a switch's text: no comment, no quotes.
std::string_view bare(std::string_view value) {
  return unquoted(value.substr(0, value.find(';')));
}

template <class Number>
std::optional<Number> parsed(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

}  // namespace

std::optional<int> wifWhole(std::string_view value) {
  std::string_view text = bare(value);
  // 12.0, as a spreadsheet writes it. 1.000 may be a thousand, and is no number here.
  if (const size_t point = text.find('.'); point != std::string_view::npos && text.substr(point) == ".0")
    text = text.substr(0, point);
  return parsed<int>(text);
}

std::optional<double> wifDecimal(std::string_view value) {
  std::string text(bare(value).substr(0, 64));
  if (const size_t comma = text.find(','); comma != std::string::npos) text[comma] = '.';
  const std::optional<double> number = parsed<double>(text);
  return number && std::isfinite(*number) ? number : std::nullopt;
}

std::optional<bool> wifBoolean(std::string_view value) {
  const std::string text = lowerCase(bare(value).substr(0, 8));
  for (const char* yes : {"true", "on", "yes", "1", "-1", "t", "y"})
    if (text == yes) return true;
  for (const char* no : {"false", "off", "no", "0", "f", "n"})
    if (text == no) return false;
  return std::nullopt;
}

std::string_view unquoted(std::string_view value) {
  value = trimmed(value);
  const bool quoted = value.size() >= 2 && value.front() == value.back() && (value[0] == '"' || value[0] == '\'');
  return quoted ? value.substr(1, value.size() - 2) : value;
}

std::vector<std::string_view> wifList(std::string_view value) {
  constexpr std::string_view kBetween = ", \t";
  std::string_view rest = bare(value);
  std::vector<std::string_view> parts;
  for (;;) {
    const size_t start = rest.find_first_not_of(kBetween);
    if (start == std::string_view::npos) return parts;
    rest.remove_prefix(start);
    const std::string_view part = rest.substr(0, rest.find_first_of(kBetween));
    parts.push_back(part);
    rest.remove_prefix(part.size());
  }
}

WifNumbers wifNumbers(std::string_view value) {
  WifNumbers numbers;
  std::string text(value);
  const size_t semicolon = text.find(';');
  const auto isDigit = [&](size_t at) { return at < text.size() && text[at] >= '0' && text[at] <= '9'; };
  constexpr std::string_view kBlanks = " \t";
  if (semicolon != std::string::npos && isDigit(text.find_first_not_of(kBlanks, semicolon + 1))) {
    const size_t before = semicolon == 0 ? std::string::npos : text.find_last_not_of(kBlanks, semicolon - 1);
    const bool onlyNumbers = isDigit(before) && text.find_first_not_of("0123456789;,+/&- \t") == std::string::npos;
    if (onlyNumbers) std::replace(text.begin(), text.end(), ';', ',');
    numbers.remarks.emplace_back(
        onlyNumbers ? "A semicolon begins a comment in this format; between numbers it is read as a comma."
                    : "What stands behind a semicolon is a comment; numbers of a list are parted by commas.");
  }
  for (const std::string_view part : wifList(text)) {
    size_t start = 0;
    for (size_t sign = part.find_first_of("+/&-", 1); sign != std::string_view::npos;
         start = sign + 1, sign = part.find_first_of("+/&-", start + 1)) {
      numbers.parts.emplace_back(part.substr(start, sign - start));
      const bool isDash = part[sign] == '-';
      numbers.remarks.emplace_back(
          isDash ? "Two numbers with a dash are read as those two, as weavers write them, not as all between."
                 : "Numbers of a list should be parted by commas; other signs between them are read as such.");
    }
    numbers.parts.emplace_back(part.substr(start));
  }
  return numbers;
}

}  // namespace loomlight
