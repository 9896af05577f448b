#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace loomlight {

/// The number that a text begins with.
struct LeadingNumber {
  double value = 0;
  size_t length = 0;  ///< characters that it takes
};

/// A finite number, with a decimal point or a decimal comma: "19.7", "19,7", "-1e3". nullopt where there is none, and
/// for "1,000", which is one to some people and a thousand to others.
std::optional<LeadingNumber> leadingNumber(std::string_view text);
/// Whether the text begins with such a number.
bool hasDoubtfulComma(std::string_view text);

/// The number of a text that says nothing else but its unit, in the singular or the plural and with blanks or without:
/// "8 ends", "8end" and "8" where the unit is "end" or "ends", "600turn/m" where it is "turns/m". nullopt for any
/// other.
std::optional<double> numberIn(std::string_view unit, std::string_view text);

/// How many samples a picture has for each of its pixels, in words; before the first it is a preview.
std::string sampleText(int samples);

}  // namespace loomlight
