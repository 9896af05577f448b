#pragma once

#include <string>
#include <string_view>

#include "core/fabric/palette/palette.h"

/// A reader for each format; all throw InputError, naming `source`, and leave a missing name of the palette empty.
namespace loomlight {

inline constexpr size_t kMostPaletteBytes = 8'000'000;
inline constexpr size_t kMostColours = 20'000;

Palette paletteFromAse(std::string_view bytes, const std::string& source);
Palette paletteFromAco(std::string_view bytes, const std::string& source);
Palette paletteFromGpl(std::string_view text, const std::string& source);
Palette paletteFromCxf(std::string_view text, const std::string& source);
Palette paletteFromTable(std::string_view text, const std::string& source);

/// Adds a colour of encoded sRGB, channels in [0, 1]. Throws InputError for others, naming `place`, and for more
/// colours than a palette may have.
void addSrgb(Palette& palette, std::string name, const glm::dvec3& encoded, const std::string& place);
/// The same of CIELAB and of four inks, each in [0, 1]: these become sRGB as screens without a profile show them.
void addLab(Palette& palette, std::string name, WhiteLab lab, const std::string& place);
void addCmyk(Palette& palette, std::string name, const glm::dvec4& inks, const std::string& place);

}  // namespace loomlight
