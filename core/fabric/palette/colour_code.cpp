#include "core/fabric/palette/colour_code.h"

#include <algorithm>
#include <cmath>

#include "core/base/rgb.h"
#include "core/base/text.h"
#include "core/fabric/wif/wif_values.h"

namespace loomlight {
namespace {

constexpr std::string_view kBetween = " \t,;";

/// The next word of the text, which is taken off it; empty where there is none.
std::string_view nextWord(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(kBetween), text.size()));
  const std::string_view word = text.substr(0, text.find_first_of(kBetween));
  text.remove_prefix(word.size());
  return word;
}

std::optional<WhiteLab> labFromText(std::string_view text) {
  if (lowerCase(nextWord(text)) != "lab") return std::nullopt;
  double numbers[3];
  for (double& number : numbers) {
    const std::optional<double> read = wifDecimal(nextWord(text));
    if (!read) return std::nullopt;
    number = *read;
  }
  if (!nextWord(text).empty()) return std::nullopt;
  if (numbers[0] < 0 || numbers[0] > 100 || std::abs(numbers[1]) > 200 || std::abs(numbers[2]) > 200)
    return std::nullopt;
  return WhiteLab{numbers[0], numbers[1], numbers[2], "D65", 2};
}

}  // namespace

std::optional<glm::dvec3> hexColour(std::string_view text) {
  if (text.starts_with('#')) text.remove_prefix(1);
  const auto digit = [](char c) {
    return c >= '0' && c <= '9'   ? c - '0'
           : c >= 'a' && c <= 'f' ? c - 'a' + 10
           : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                  : -1;
  };
  if (text.size() != 6 || std::any_of(text.begin(), text.end(), [&](char c) { return digit(c) < 0; }))
    return std::nullopt;
  glm::dvec3 colour;
  for (int c = 0; c < 3; ++c) colour[c] = (16 * digit(text[2 * c]) + digit(text[2 * c + 1])) / 255.0;
  return colour;
}

std::optional<NamedColour> colourFromCode(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(kBetween), text.size()));
  text = text.substr(0, text.find_last_not_of(kBetween) + 1);
  NamedColour colour;
  colour.name = text;
  if (const auto encoded = hexColour(text))
    colour.linear = linearFromSrgb(Rgb(*encoded));
  else if (const auto lab = labFromText(text))
    colour.lab = lab;
  else
    return std::nullopt;
  return colour;
}

}  // namespace loomlight
