#pragma once

#include <string>

#include "core/base/spectrum.h"
#include "core/fabric/model/lamp_name.h"
#include "render/colour/observer.h"

namespace loomlight {

/// What a colour is seen under: the relative power of a light at every nm from 360 to 780.
struct Illuminant {
  std::string name;
  PerNm<double> power{};
};

/// The spectrum of a lamp that has a name (CIE 15:2018).
Illuminant illuminantOf(const NamedLamp& lamp);

/// That of the lamp of this name (lampFromName()); black bodies are of 1000 to 25000 K. Throws InputError for other
/// names; it lists those there are.
Illuminant illuminantNamed(const std::string& name);

/// The illuminant of that name, or, for the name of a file, of its two columns: wavelength in nm, ascending, at least
/// from 380 to 730; and power, in any unit. Columns are parted by blanks, a comma or a semicolon; "#" starts a comment,
/// and one line of headings may come first. Between its lines power goes straight, beyond them it stays. Throws
/// InputError.
Illuminant illuminantCalled(const std::string& nameOrFile);

/// Whether a file is one of two columns, by its first line of numbers; nothing is said of the rest. A table of one
/// measured reflectance looks the same.
bool isIlluminantFile(const std::string& file);

}  // namespace loomlight
