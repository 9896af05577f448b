#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/text_encoding.h"
#include "core/fabric/swatch/measured_swatch.h"

/// Between the files of instruments and measurements: what every reader of a format hands on, and what all share.
namespace loomlight {

/// Largest file that is read, and most swatches and values of one.
inline constexpr size_t kMostSwatchBytes = 8'000'000;
inline constexpr size_t kMostSwatches = 20'000;
inline constexpr size_t kMostSwatchValues = 1000;

/// What a file says of its numbers. `usuallyFraction`: its format says so, but not all who write it heed that.
enum class ReflectanceUnit { unsaid, percent, fraction, usuallyFraction };

/// A measurement as it is written: nothing about it is checked but that these are numbers.
struct RawSwatch {
  std::string name;                            ///< empty where there is none
  std::string place;                           ///< where in the file, for messages: "line 12", "set 3"
  std::vector<double> wavelengths_nm, values;  ///< as many of one as of the other
  SpecularComponent specular = SpecularComponent::unknown;
};

/// Checked, in order, in one unit. Throws InputError, naming `source` and the place, for wavelengths that do not ascend
/// in equal steps or leave out a part of 400 to 700 nm, for values that no reflectance has, and for those that may be
/// of either unit where none is said. `howToSay`: how a file of the format says its unit.
SwatchFile swatchesOf(std::vector<RawSwatch> raw, ReflectanceUnit unit, const std::string& source,
                      std::string_view howToSay = {});

/// The readers. `text` is UTF-8; all throw InputError, naming `source`.
SwatchFile swatchesFromCgats(std::string_view text, const std::string& source);
SwatchFile swatchesFromCxf(std::string_view text, const std::string& source);
SwatchFile swatchesFromQtx(std::string_view text, const std::string& source);
SwatchFile swatchesFromTable(std::string_view text, const std::string& source);

/// SCI, SCE, or in words, anywhere in a text.
SpecularComponent specularIn(std::string_view text);

/// Whether a text has a word, in capitals or not, that is no part of a longer one.
bool saysWord(std::string_view text, std::string_view lowerCaseWord);

/// Throws InputError, naming `source`, where a file says that its numbers are K/S (Kubelka and Munk), which a dyehouse
/// calculates from reflectances: they would pass for percents.
void expectNoKubelkaMunk(std::string_view text, const std::string& source);

/// The wavelength in the title of a column: "400", "400 nm", "R400", "SPECTRAL_NM400"; in [200, 1200].
std::optional<double> wavelengthIn(std::string_view title);

/// A finite number and nothing else; with a decimal comma where `comma`.
std::optional<double> swatchNumber(std::string_view text, bool comma = false);

}  // namespace loomlight
