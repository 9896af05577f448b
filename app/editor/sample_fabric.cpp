#include "app/editor/sample_fabric.h"

#include "core/fabric/fabric_json.h"
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

}  // namespace

std::vector<std::string> sampleNames() {
  std::vector<std::string> names;
  for (const Sample& sample : kSamples) names.emplace_back(sample.name);
  return names;
}

Fabric sampleFabric(size_t index) {
  return fabricFromJson(kSamples[index].json, kSamples[index].name);
}

}  // namespace loomlight
