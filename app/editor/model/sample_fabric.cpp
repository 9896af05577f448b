#include "app/editor/model/sample_fabric.h"

#include <iterator>

#include "app/wardrobe/wardrobe.h"
#include "core/fabric/json/fabric_json.h"
#include "sample_text.h"

namespace loomlight {
namespace {

struct Sample {
  const char* name;
  const std::string_view& json;
};
constexpr Sample kSamples[] = {
    {"Blue cloth", kBlueCloth},
    {"Colourful cloth", kColourfulCloth},
    {"Black and white cloth", kBlackAndWhiteCloth},
    {"Green cloth", kGreenCloth},
    {"Denim", kDenim},
    {"Sheer silk", kSheerSilk},
    {"Wool suiting", kWoolSuiting},
    {"Jacquard damask", kJacquard},
};

constexpr size_t kOfTheirOwn = std::size(kSamples);  // the others are the wardrobe's
constexpr size_t kWelcome = 4;                       // Denim

}  // namespace

std::vector<std::string> sampleNames() {
  std::vector<std::string> names;
  for (const Sample& sample : kSamples) names.emplace_back(sample.name);
  for (const WardrobeCloth& cloth : wardrobe()) names.emplace_back(cloth.name);
  return names;
}

Fabric sampleFabric(size_t index) {
  if (index >= kOfTheirOwn) return fabricOf(wardrobe()[index - kOfTheirOwn]);
  return fabricFromJson(kSamples[index].json, kSamples[index].name);
}

Fabric welcomeFabric() {
  Fabric fabric = sampleFabric(kWelcome);
  fabric.drape.kind = DrapeKind::folds;
  fabric.drape.width_mm = 84;
  fabric.drape.height_mm = 66;
  fabric.drape.radius_mm = 5;
  fabric.light.kind = LightKind::window;  // clear after a few samples, as the sun is not
  fabric.camera.azimuth_deg = -78;
  fabric.camera.elevation_deg = 48;
  fabric.camera.distance_mm = 110;
  return fabric;
}

}  // namespace loomlight
