#include "app/cli/commands/cloth_colour.h"

#include <fmt/format.h>

#include <charconv>
#include <optional>

#include "app/cli/usage_error.h"
#include "core/fabric/swatch/measured_swatch.h"

namespace loomlight {
namespace {

std::optional<Rgb8> colourFromText(const std::string& text) {
  uint32_t value = 0;
  const char* const end = text.data() + text.size();
  if (text.size() != 7 || text[0] != '#') return std::nullopt;
  const auto [stopped, error] = std::from_chars(text.data() + 1, end, value, 16);
  if (error != std::errc{} || stopped != end) return std::nullopt;
  return Rgb8{static_cast<uint8_t>(value >> 16), static_cast<uint8_t>(value >> 8), static_cast<uint8_t>(value)};
}

}  // namespace

ClothColour parseClothColour(const std::string& option, const std::string& text) {
  const size_t sign = text.rfind('=');
  const std::string what = sign == std::string::npos || sign == 0 ? "" : text.substr(sign + 1);
  const std::string fibre = text.substr(0, sign);
  if (const auto colour = colourFromText(what)) return {fibre, *colour, ""};
  if (isSwatchFile(what)) return {fibre, {}, what};
  throw UsageError(
      fmt::format("{}: expected FIBRE=#RRGGBB, such as cotton=#b04020 or 1=#b04020, or a measured swatch, "
                  "such as cotton=navy.csv, got '{}'",
                  option, text));
}

}  // namespace loomlight
