#include <algorithm>
#include <cmath>

#include "core/fabric/palette/big_endian.h"
#include "core/fabric/palette/palette_readers.h"

// How it works. Photoshop writes its colours twice: version 1 without names, then version 2 with them. Each colour is
// the number of a space and four numbers of 16 bits. Colours of books that only Photoshop knows are counted and left
// out.

namespace loomlight {
namespace {

enum Space : uint16_t { kRgb = 0, kHsb = 1, kCmyk = 2, kLab = 7, kGrey = 8 };
constexpr double kFull = 65535;

/// Hue, saturation and brightness in [0, 1].
glm::dvec3 rgbFromHsb(double hue, double saturation, double brightness) {
  const auto channel = [&](double turn) {
    const double k = std::fmod(turn + 6 * hue, 6.0);
    return brightness * (1 - saturation * std::max(0.0, std::min({k, 4 - k, 1.0})));
  };
  return {channel(5), channel(3), channel(1)};
}

/// Whether the space was one that is known.
bool addColour(Palette& palette, uint16_t space, const glm::dvec4& numbers, std::string name,
               const std::string& place) {
  const glm::dvec4 parts = numbers / kFull;
  // a and b count from -12800 to 12700 in steps of a hundredth, as a signed number of 16 bits.
  const auto hundredths = [](double number) { return (number >= 32768 ? number - 65536 : number) / 100; };
  switch (space) {
    case kRgb:
      addSrgb(palette, std::move(name), glm::dvec3(parts), place);
      return true;
    case kHsb:
      addSrgb(palette, std::move(name), rgbFromHsb(parts.x, parts.y, parts.z), place);
      return true;
    case kCmyk:
      addCmyk(palette, std::move(name), 1.0 - parts, place);
      return true;
    case kLab:
      addLab(palette, std::move(name), {numbers.x / 100, hundredths(numbers.y), hundredths(numbers.z)}, place);
      return true;
    case kGrey:
      addSrgb(palette, std::move(name), glm::dvec3(numbers.x / 10000), place);
      return true;
    default:
      return false;
  }
}

Palette readColours(BigEndian& file, bool named) {
  Palette palette;
  int unknown = 0;
  for (uint16_t left = file.u16(); left > 0; --left) {
    const std::string place = file.place();
    const uint16_t space = file.u16();
    glm::dvec4 numbers;
    for (int i = 0; i < 4; ++i) numbers[i] = file.u16();
    std::string name = named ? file.text(file.u32()) : std::string();
    if (!addColour(palette, space, numbers, std::move(name), place)) ++unknown;
  }
  if (unknown > 0)
    palette.remarks.push_back(fmt::format("Colours of books that only Photoshop knows were left out: {}.", unknown));
  return palette;
}

}  // namespace

Palette paletteFromAco(std::string_view bytes, const std::string& source) {
  BigEndian file(bytes, source);
  const uint16_t version = file.u16();
  if (version != 1 && version != 2)
    throw InputError(fmt::format("{}: expected colours of Photoshop, version 1 or 2; it is {}", source, version));
  Palette palette = readColours(file, version == 2);
  if (version == 1 && !file.atEnd() && file.u16() == 2) palette = readColours(file, true);
  return palette;
}

}  // namespace loomlight
