#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/spectrum.h"
#include "core/base/units.h"
#include "core/fabric/swatch/measured_swatch.h"

namespace loomlight {

/// CIELAB, and the white that it is meant for.
struct WhiteLab {
  double L = 0, a = 0, b = 0;      ///< L in [0, 100], a and b in [-200, 200]
  std::string illuminant = "D50";  ///< as files of graphic arts mean it where they do not say
  int observer_degrees = 2;        ///< 2 or 10
};

/// A colour of a palette. A reflectance tells most of it, CIELAB less; where there is neither, `linear` is all.
struct NamedColour {
  std::string name;
  Rgb linear{0};  ///< Rec. 709, in [0, 1]; of a reflectance or CIELAB it is not computed here
  std::optional<WhiteLab> lab;
  std::optional<Spectrum> reflectance;
};

struct Palette {
  std::string name;                  ///< that of the file where it has none of its own
  std::vector<NamedColour> colours;  ///< at least one, in the order of the file
  std::vector<std::string> remarks;  ///< what was left out, guessed or approximated
};

/// What was measured, to choose from; without a name.
Palette paletteOf(const SwatchFile& measured);

/// Reads a palette: Adobe Swatch Exchange (.ase), Photoshop colours (.aco), GIMP (.gpl), a colour book as CxF3 (.cxf),
/// or a table (.csv) of names with hexadecimal codes, r, g and b, L*, a* and b*, or reflectances. Three numbers of red,
/// green and blue are taken as sRGB. Throws InputError.
Palette readPalette(const std::string& file);

/// Whether a file is one of these, by the ending of its name.
bool isPaletteFile(const std::string& file);

/// The same of a file's bytes; `source` names them in messages. Photoshop's colours have no mark of their own, so they
/// are told by `source` ending in ".aco".
Palette paletteFrom(std::string_view bytes, const std::string& source);

}  // namespace loomlight
