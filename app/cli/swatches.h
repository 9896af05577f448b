#pragma once

#include <string>

#include "core/base/spectrum.h"
#include "core/fabric/swatch/measured_swatch.h"

namespace loomlight {

/// A swatch as it is called on a command line: FILE, or FILE:NAME for one of several.
struct SwatchChoice {
  std::string file;
  std::string name;  ///< or its number from 1; empty: the first
};
/// Names of files come first, as they may have colons of their own.
SwatchChoice swatchChoice(const std::string& text);

/// Whether the file of a choice is one of measured swatches.
bool isSwatch(const std::string& text);

/// The measurement of a choice; what was guessed of its file goes to stderr, and that there are more where none was
/// named. Throws InputError.
MeasuredSwatch swatchFrom(const std::string& text);

/// Of the same, in the bands.
Spectrum reflectanceFrom(const std::string& text);

}  // namespace loomlight
