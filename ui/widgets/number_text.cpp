#include "ui/widgets/number_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <string>

#include "ui/words/common_words.h"

namespace loomlight {
namespace {

constexpr std::string_view kDigits = "0123456789";

std::string numberAtBeginning(std::string_view text) {
  return std::string(text.substr(0, text.find_first_not_of("0123456789.,+-eE")));
}

/// Three digits behind the comma, and before it more than zeros.
bool mayGroup(std::string_view number, size_t comma) {
  const size_t end = std::min(number.find_first_not_of(kDigits, comma + 1), number.size());
  return end == comma + 4 && number.substr(0, comma).find_first_of("123456789") != std::string_view::npos;
}

bool isLetter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0;
}

/// A unit without blanks, and with its words in the singular: "dents/10 cm" becomes "dent/10cm". Words of less than
/// four letters are signs, such as "m" and "dpi", and have no plural.
std::string bareUnit(std::string_view unit) {
  constexpr size_t kShortestPlural = 4;
  std::string bare;
  size_t word = 0;  // letters, up to here
  for (size_t i = 0; i < unit.size(); ++i) {
    word = isLetter(unit[i]) ? word + 1 : 0;
    const bool ends = i + 1 == unit.size() || !isLetter(unit[i + 1]);
    const bool isPlural = ends && word >= kShortestPlural && unit[i] == 's';
    if (unit[i] != ' ' && !isPlural) bare += unit[i];
  }
  return bare;
}

}  // namespace

bool hasDoubtfulComma(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  const std::string number = numberAtBeginning(text);
  const size_t comma = number.find(',');
  return comma != std::string::npos && mayGroup(number, comma);
}

std::optional<LeadingNumber> leadingNumber(std::string_view text) {
  std::string number = numberAtBeginning(text);
  if (const size_t comma = number.find(','); comma != std::string::npos) {
    const size_t end = std::min(number.find_first_not_of(kDigits, comma + 1), number.size());
    const std::string_view whole = std::string_view(number).substr(0, comma);
    if (end == comma + 1 || mayGroup(number, comma) || whole.find('.') != std::string_view::npos) return std::nullopt;
    if (end < number.size() && (number[end] == ',' || number[end] == '.')) return std::nullopt;
    number[comma] = '.';
  }
  LeadingNumber leading;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), leading.value);
  if (error != std::errc() || !std::isfinite(leading.value)) return std::nullopt;
  leading.length = static_cast<size_t>(end - number.data());
  return leading;
}

std::optional<double> numberIn(std::string_view unit, std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  const std::optional<LeadingNumber> leading = leadingNumber(text);
  if (!leading) return std::nullopt;
  const std::string rest = bareUnit(text.substr(leading->length));
  if (rest.empty() || rest == bareUnit(unit)) return leading->value;
  return std::nullopt;
}

std::string sampleText(int samples) {
  if (samples <= 0) return words::common::preview;
  return samples == 1 ? std::string(words::common::oneSample) : fmt::format(words::common::samples, samples);
}

}  // namespace loomlight
