#include "ui/number_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

namespace loomlight {

std::optional<LeadingNumber> leadingNumber(std::string_view text) {
  constexpr std::string_view kDigits = "0123456789";
  std::string number(text.substr(0, text.find_first_not_of("0123456789.,+-eE")));
  if (const size_t comma = number.find(','); comma != std::string::npos) {
    const size_t end = std::min(number.find_first_not_of(kDigits, comma + 1), number.size());
    const std::string_view whole = std::string_view(number).substr(0, comma);
    const bool grouping = end == comma + 4 && whole.find_first_of("123456789") != std::string_view::npos;
    if (end == comma + 1 || grouping || whole.find('.') != std::string_view::npos) return std::nullopt;
    if (end < number.size() && (number[end] == ',' || number[end] == '.')) return std::nullopt;
    number[comma] = '.';
  }
  LeadingNumber leading;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), leading.value);
  if (error != std::errc() || !std::isfinite(leading.value)) return std::nullopt;
  leading.length = static_cast<size_t>(end - number.data());
  return leading;
}

}  // namespace loomlight
