#include "core/fabric/swatch/measured_swatch.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/sprague.h"
#include "core/base/text.h"
#include "core/base/text_encoding.h"
#include "core/fabric/swatch/raw_swatch.h"
#include "core/fabric/wif/wif_values.h"

namespace loomlight {

std::string_view specularText(SpecularComponent specular) {
  switch (specular) {
    case SpecularComponent::included:
      return "SCI, specular included";
    case SpecularComponent::excluded:
      return "SCE, specular excluded";
    case SpecularComponent::unknown:
      break;
  }
  return {};
}

Spectrum bandReflectance(const MeasuredSwatch& swatch) {
  const auto last = static_cast<double>(swatch.values.size() - 1);
  Spectrum bands;
  for (size_t j = 0; j < kBands; ++j) {
    const double at = std::clamp((bandWavelength_nm(j) - swatch.first_nm) / swatch.step_nm, 0.0, last);
    bands[j] = static_cast<float>(std::clamp(sprague(swatch.values, at), 0.0, 1.0));
  }
  return bands;
}

bool isSwatchFile(const std::string& file) {
  const std::string extension = lowerExtension(file);
  if (extension == ".csv" || extension == ".cxf" || extension == ".qtx") return true;
  if (extension != ".txt") return false;
  try {
    return readFile(file, kMostSwatchBytes).find("BEGIN_DATA_FORMAT") != std::string::npos;
  } catch (const InputError&) {
    return false;  // who opens it will say why
  }
}

SwatchFile readSwatches(const std::string& file) {
  return swatchesFrom(readFile(file, kMostSwatchBytes), file);
}

SwatchFile swatchesFrom(std::string_view bytes, const std::string& source) {
  if (bytes.size() > kMostSwatchBytes)
    throw InputError(fmt::format("{}: expected at most {} bytes", source, kMostSwatchBytes));
  const std::string text = decodeText(bytes, source).text;
  const auto has = [&text](const char* word) { return text.find(word) != std::string::npos; };
  if (trimmed(text).starts_with('<')) return swatchesFromCxf(text, source);
  if (has("[STANDARD_DATA") || has("[BATCH_DATA")) return swatchesFromQtx(text, source);
  if (has("BEGIN_DATA_FORMAT")) return swatchesFromCgats(text, source);
  return swatchesFromTable(text, source);
}

}  // namespace loomlight
