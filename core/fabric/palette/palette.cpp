#include "core/fabric/palette/palette.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/rgb.h"
#include "core/base/text.h"
#include "core/base/text_encoding.h"
#include "core/fabric/palette/palette_readers.h"
#include "core/fabric/wif/wif_values.h"

namespace loomlight {
namespace {

void add(Palette& palette, NamedColour colour, const std::string& place) {
  if (palette.colours.size() == kMostColours)
    throw InputError(fmt::format("{}: expected at most {} colours", place, kMostColours));
  palette.colours.push_back(std::move(colour));
}

Palette read(std::string_view bytes, const std::string& source) {
  if (bytes.starts_with("ASEF")) return paletteFromAse(bytes, source);
  if (lowerExtension(source) == ".aco") return paletteFromAco(bytes, source);
  const std::string text = decodeText(bytes, source).text;
  const std::string_view start = trimmed(text);
  if (start.starts_with("GIMP Palette")) return paletteFromGpl(text, source);
  if (start.starts_with('<')) return paletteFromCxf(text, source);
  return paletteFromTable(text, source);
}

}  // namespace

void addSrgb(Palette& palette, std::string name, const glm::dvec3& encoded, const std::string& place) {
  for (int c = 0; c < 3; ++c)
    if (!(encoded[c] >= -0.01 && encoded[c] <= 1.01))
      throw InputError(
          fmt::format("{}: expected red, green and blue from 0 to their largest; they are {:g}, {:g} and {:g} of "
                      "it",
                      place, encoded.r, encoded.g, encoded.b));
  const Rgb linear = linearFromSrgb(Rgb(glm::clamp(encoded, 0.0, 1.0)));
  add(palette, {std::move(name), linear, std::nullopt, std::nullopt}, place);
}

void addLab(Palette& palette, std::string name, WhiteLab lab, const std::string& place) {
  constexpr double kMost = 200;  // of a and b
  if (!(lab.L >= 0 && lab.L <= 100.5 && std::abs(lab.a) <= kMost && std::abs(lab.b) <= kMost))
    throw InputError(
        fmt::format("{}: expected CIELAB, L* of 0 to 100; it is {:g}, {:g}, {:g}", place, lab.L, lab.a, lab.b));
  lab.L = std::min(lab.L, 100.0);  // instruments round
  add(palette, {std::move(name), Rgb(0), lab, std::nullopt}, place);
}

void addCmyk(Palette& palette, std::string name, const glm::dvec4& inks, const std::string& place) {
  addSrgb(palette, std::move(name), (1.0 - glm::dvec3(inks)) * (1.0 - inks.w), place);
  const std::string remark = "Colours of four inks are shown as screens without a profile show them.";
  if (std::find(palette.remarks.begin(), palette.remarks.end(), remark) == palette.remarks.end())
    palette.remarks.push_back(remark);
}

Palette paletteOf(const SwatchFile& measured) {
  Palette palette;
  palette.remarks = measured.remarks;
  for (const MeasuredSwatch& swatch : measured.swatches)
    palette.colours.push_back({swatch.name, Rgb(0), std::nullopt, bandReflectance(swatch)});
  return palette;
}

bool isPaletteFile(const std::string& file) {
  constexpr std::string_view kEndings[] = {".ase", ".aco", ".gpl", ".cxf", ".csv"};
  const std::string ending = lowerExtension(file);
  return std::find(std::begin(kEndings), std::end(kEndings), ending) != std::end(kEndings);
}

Palette readPalette(const std::string& file) {
  return paletteFrom(readFile(file, kMostPaletteBytes), file);
}

Palette paletteFrom(std::string_view bytes, const std::string& source) {
  if (bytes.size() > kMostPaletteBytes)
    throw InputError(fmt::format("{}: expected at most {} bytes", source, kMostPaletteBytes));
  Palette palette = read(bytes, source);
  if (palette.colours.empty()) throw InputError(fmt::format("{}: expected colours; there are none", source));
  if (palette.name.empty()) palette.name = std::filesystem::path(source).stem().string();
  for (size_t i = 0; i < palette.colours.size(); ++i)
    if (palette.colours[i].name.empty()) palette.colours[i].name = fmt::format("{} {}", palette.name, i + 1);
  return palette;
}

}  // namespace loomlight
