#include "ui/widgets/number_text.h"

#include <fmt/format.h>

#include <algorithm>
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

std::string sampleText(int samples) {
  if (samples <= 0) return words::common::preview;
  return samples == 1 ? std::string(words::common::oneSample) : fmt::format(words::common::samples, samples);
}

}  // namespace loomlight
