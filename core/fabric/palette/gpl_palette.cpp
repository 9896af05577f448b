#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/fabric/palette/palette_readers.h"
#include "core/fabric/swatch/cxf_document.h"
#include "core/fabric/swatch/raw_swatch.h"
#include "core/fabric/wif/wif_values.h"

namespace loomlight {
namespace {

void readColour(std::string_view line, const std::string& place, Palette& palette) {
  glm::dvec3 colour;
  for (int c = 0; c < 3; ++c) {
    const std::optional<double> value = swatchNumber(cxfWord(line));
    if (!value) throw InputError(fmt::format("{}: expected red, green and blue of 0 to 255, and a name", place));
    colour[c] = *value / 255;
  }
  const std::string_view name = trimmed(line);
  addSrgb(palette, std::string(name == "Untitled" ? "" : name), colour, place);
}

}  // namespace

Palette paletteFromGpl(std::string_view text, const std::string& source) {
  Palette palette;
  for (int number = 1; !text.empty(); ++number) {
    const std::string_view line = trimmed(takeLine(text));
    if (line.empty() || line.starts_with('#') || line == "GIMP Palette" || line.starts_with("Columns:")) continue;
    if (line.starts_with("Name:")) {
      palette.name = trimmed(line.substr(5));
    } else {
      readColour(line, fmt::format("{}: line {}", source, number), palette);
    }
  }
  return palette;
}

}  // namespace loomlight
