#include "app/cli/commands/cloth_colour.h"

#include <fmt/format.h>

#include <optional>

#include "app/cli/swatches.h"
#include "app/cli/usage_error.h"
#include "core/fabric/palette/colour_code.h"

namespace loomlight {
namespace {

/// Six digits alone might be a file's name.
std::optional<NamedColour> colourFromText(const std::string& text) {
  return !text.starts_with('#') && hexColour(text) ? std::nullopt : colourFromCode(text);
}

}  // namespace

ClothColour parseClothColour(const std::string& option, const std::string& text) {
  const size_t sign = text.rfind('=');
  const std::string what = sign == std::string::npos || sign == 0 ? "" : text.substr(sign + 1);
  const std::string fibre = text.substr(0, sign);
  if (const auto colour = colourFromText(what)) return {fibre, *colour, ""};
  if (isSwatch(what)) return {fibre, {}, what};
  throw UsageError(fmt::format(
      "{}: expected FIBRE=#RRGGBB, such as cotton=#b04020 or 1=#b04020, FIBRE=Lab L a b, such as "
      "'cotton=Lab 40 52 38', or a measured swatch, such as cotton=navy.csv or cotton=book.cxf:navy, got '{}'",
      option, text));
}

}  // namespace loomlight
