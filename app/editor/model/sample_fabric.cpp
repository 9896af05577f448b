#include "app/editor/model/sample_fabric.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "app/wardrobe/wardrobe.h"
#include "core/fabric/json/fabric_json.h"
#include "core/fabric/yarn/presets.h"
#include "core/fabric/yarn/yarn_edit.h"
#include "sample_text.h"
#include "ui/words/preset_words.h"

namespace loomlight {
namespace {

struct Sample {
  const char* name;
  const std::string_view& json;
};
constexpr Sample kSamples[] = {
    {words::samples::blueCloth, kBlueCloth},
    {words::samples::colourfulCloth, kColourfulCloth},
    {words::samples::blackAndWhiteCloth, kBlackAndWhiteCloth},
    {words::samples::greenCloth, kGreenCloth},
    {words::samples::denim, kDenim},
    {words::samples::sheerSilk, kSheerSilk},
    {words::samples::woolSuiting, kWoolSuiting},
    {words::samples::jacquard, kJacquard},
};

constexpr size_t kOfTheirOwn = std::size(kSamples);  // the others are the wardrobe's

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

Fabric newFabric() {
  constexpr double kHandsBreadth_mm = 90;
  Fabric fabric = sampleFabric();
  fabric.name = Fabric().name;
  fabric.description.clear();
  fabric.colourways.clear();
  fabric.mill = {};
  fabric.wif.reset();
  // Spun cotton in the sample's colours.
  const Fabric cotton = plainCotton();
  for (Yarn& yarn : fabric.yarns) {
    const int fibre = yarn.fibre;
    yarn = cotton.yarns[0];
    yarn.name.clear();
    yarn.fibre = fibre;
  }
  for (Fibre& fibre : fabric.fibres) fibre = dyedLike(cotton.fibres[0], fibre);
  fabric.settCv_percent = cotton.settCv_percent;
  // Nothing is called by colours that soon go.
  std::vector<Fibre> named;
  named.swap(fabric.fibres);
  for (Fibre& fibre : named) {
    fibre.name = fibreNameFor(fabric, kindName(fibre.name));
    fabric.fibres.push_back(std::move(fibre));
  }
  fabric.drape = Drape{};
  fabric.drape.width_mm = fabric.drape.height_mm = kHandsBreadth_mm;
  fabric.light.kind = LightKind::window;
  return fabric;
}

Fabric welcomeFabric() {
  return wardrobeFabric("denim_raw");
}

}  // namespace loomlight
