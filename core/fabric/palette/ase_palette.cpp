#include "core/fabric/palette/big_endian.h"
#include "core/fabric/palette/palette_readers.h"

// How it works. Adobe Swatch Exchange is a list of blocks, each with its kind and its length; those of groups and of
// kinds that nobody has told of are passed over. A colour has a name, a model of four letters, and a number of 32 bits
// for each component: L* as a fraction of 100.

namespace loomlight {
namespace {

constexpr uint16_t kGroup = 0xC001, kColour = 0x0001;

void readColour(BigEndian block, Palette& palette) {
  const std::string name = block.text(block.u16());
  const std::string place = block.place();
  const std::string_view model = block.bytes(4);
  const auto next = [&block] { return static_cast<double>(block.f32()); };
  if (model == "RGB ") {
    const double r = next(), g = next(), b = next();
    addSrgb(palette, name, {r, g, b}, place);
  } else if (model == "Gray" || model == "GRAY") {
    addSrgb(palette, name, glm::dvec3(next()), place);
  } else if (model == "LAB ") {
    const double L = next(), a = next(), b = next();
    addLab(palette, name, {100 * L, a, b}, place);
  } else if (model == "CMYK") {
    const double c = next(), m = next(), y = next(), k = next();
    addCmyk(palette, name, {c, m, y, k}, place);
  } else {
    throw InputError(fmt::format("{}: expected a colour of RGB, LAB, CMYK or Gray", place));
  }
}

}  // namespace

Palette paletteFromAse(std::string_view bytes, const std::string& source) {
  BigEndian file(bytes, source);
  file.bytes(4);
  if (const uint16_t version = file.u16(); version != 1)
    throw InputError(fmt::format("{}: expected version 1 of Adobe Swatch Exchange; it is {}", source, version));
  file.u16();
  Palette palette;
  for (uint32_t left = file.u32(); left > 0; --left) {
    const uint16_t kind = file.u16();
    BigEndian block = file.block(file.u32());
    if (kind == kColour) readColour(block, palette);
    if (kind == kGroup && palette.name.empty()) palette.name = block.text(block.u16());
  }
  return palette;
}

}  // namespace loomlight
