#include "app/export/picture.h"

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/fabric/json/fabric_json.h"
#include "render/film/image.h"

namespace loomlight {
namespace {

constexpr const char* kFabricKey = "loomlight.fabric";
constexpr const char* kSamplesKey = "loomlight.samples_per_pixel";
constexpr const char* kVersionKey = "loomlight.version";

}  // namespace

Fabric fabricInTexts(const std::map<std::string, std::string>& texts, const std::string& file) {
  const auto found = texts.find(kFabricKey);
  if (found == texts.end())
    throw InputError(fmt::format("{}: expected the metadata '{}' that Loomlight writes into its pictures, found none",
                                 file, kFabricKey));
  return workingNames(fabricFromJson(found->second, fmt::format("{}: {}", file, kFabricKey)), file);
}

std::map<std::string, std::string> exrTexts(const Film& film, const Fabric& fabric, const std::string& file) {
  return {{kFabricKey, fabricToJson(localNames(fabric, file))},
          {kSamplesKey, std::to_string(film.fewestSamples(film.window()))},
          {kVersionKey, LOOMLIGHT_VERSION}};
}

void checkPictureName(const std::string& file) {
  const std::string ending = lowerExtension(file);
  if (ending != ".exr" && ending != ".png")
    throw InputError(fmt::format("{}: expected the name of a picture that ends in .exr or .png", file));
  expectWritable(file);
}

std::map<std::string, std::string> pngTexts(const Fabric& fabric) {
  return {{"Software", "Loomlight " LOOMLIGHT_VERSION}, {"Title", fabric.name}};
}

void writePicture(const std::string& file, const Film& film, const Fabric& fabric, const Tone& tone, double dpi) {
  checkPictureName(file);
  if (lowerExtension(file) == ".png") {
    writePng(file, toPixels(film, tone), pngTexts(fabric), dpi);
    return;
  }
  Image image = film.toImage(false);
  image.metadata.merge(exrTexts(film, fabric, file));
  writeExr(file, image, dpi);
}

Fabric fabricOfPicture(const std::string& file) {
  return fabricInTexts(readExr(file).metadata, file);
}

}  // namespace loomlight
