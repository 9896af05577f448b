#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/spectrum.h"

namespace loomlight {

/// Whether an instrument with a sphere counts what the surface mirrors (ISO 7724-1: di:8 and de:8). Cloth reflects
/// nearly the same either way; two measurements that are compared should agree in it.
enum class SpecularComponent { unknown, included, excluded };

/// "SCI, specular included", as instruments say it; empty where it is unknown.
std::string_view specularText(SpecularComponent specular);

/// One measurement of a spectrophotometer.
struct MeasuredSwatch {
  std::string name;                  ///< never empty
  double first_nm = 0, step_nm = 0;  ///< of the values; at most 400 nm, 1 to 20 nm
  std::vector<double> values;  ///< reflectance factors, 1 for a perfect diffuser, up to 700 nm at least; in [0, 2]
  SpecularComponent specular = SpecularComponent::unknown;

  double last_nm() const { return first_nm + step_nm * static_cast<double>(values.size() - 1); }
};

/// The measurement in the bands that are computed with: between the values by Sprague's polynomial, as CIE 15 says, and
/// beyond them the first and the last. In [0, 1]: what a brightener adds beyond 1 is cut off.
Spectrum bandReflectance(const MeasuredSwatch& swatch);

/// What a file holds, and sentences about what was guessed or will look otherwise than measured.
struct SwatchFile {
  std::vector<MeasuredSwatch> swatches;  ///< at least one
  std::vector<std::string> remarks;
};

/// Reads the measurements of a file: CGATS.17 (.txt), CxF3 (.cxf), Datacolor (.qtx), or a table (.csv), with
/// wavelengths as its columns or as its rows; which of them it is, its content says. Throws InputError.
SwatchFile readSwatches(const std::string& file);

/// Whether a file is one of these, by the ending of its name; of a .txt, which may be anything, by its words.
bool isSwatchFile(const std::string& file);

/// The same of a file's bytes; `source` names them in messages and gives a swatch without a name its own.
SwatchFile swatchesFrom(std::string_view bytes, const std::string& source);

}  // namespace loomlight
