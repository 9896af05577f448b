#include "app/cli/commands/cloth_colour.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "app/cli/usage_error.h"
#include "core/fabric/palette/colour_code.h"
#include "core/fabric/swatch/measured_swatch.h"

namespace loomlight {
namespace {

std::optional<Rgb8> colourFromText(const std::string& text) {
  const auto colour = text.starts_with('#') ? hexColour(text) : std::nullopt;
  if (!colour) return std::nullopt;
  const auto channel = [&](int c) { return static_cast<uint8_t>(std::lround(255 * (*colour)[c])); };
  return Rgb8{channel(0), channel(1), channel(2)};
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
