#include "app/wardrobe/wardrobe.h"

#include <algorithm>
#include <cassert>

#include "core/fabric/json/fabric_json.h"
#include "wardrobe_text.h"

namespace loomlight {
namespace {

// The trade's figures were set down before ours were looked at, but for the gabardine's, whose first construction was
// heavier than what is sold. Ours were not all set down before theirs: the page of `bench cloths` says which knobs were
// turned after a comparison. Mills publish counts, setts and mass, hardly ever thickness: what is recalled of it is a
// range, whose middle stands here. It agrees with the bulk densities of measured cloths, 0.47 g/cm3 of a cotton, 0.41
// of a wool, 0.65 of a polyester (Penava et al. 2014).

constexpr const char* kNap = "the nap that raising makes, which a gauge rests on, is not modelled";
constexpr Allowance kRaisedBlanket{0.55, kNap},
    kDeepens{0.70, "the cells of a honeycomb deepen as it shrinks, which is not modelled"},
    kLiesFlat{
        0.30,
        "relaxed yarns of this construction are 0.28 to 0.30 mm thick before they are pressed: the figure, recalled, "
        "may be that of a heavier one"},
    kCrinkles{0.35, "crepe yarns crinkle as the cloth shrinks, which is not modelled"};

const WardrobeCloth kCloths[] = {
    {"poplin",
     "Poplin",
     kWardrobePoplin,
     {"Ne 40 x 40 / 133 x 72", 118, 0.24,
      "construction: a mill; mass: recalled, 115 to 120 (a shirtmaker: 100 to 130); thickness: recalled, 0.22 to "
      "0.27"}},
    {"oxford",
     "Oxford",
     kWardrobeOxford,
     {"Ne 40 x 20 / 110 x 58, two ends as one", 140, 0.36,
      "construction: recalled; mass: recalled, 135 to 145 (a shirtmaker: 130 to 180); thickness: recalled, 0.33 to "
      "0.40",
      kLiesFlat}},
    {"chambray",
     "Chambray",
     kWardrobeChambray,
     {"Ne 30 x 30 / 76 x 68", 118, 0.29,
      "construction, mass: recalled, 115 to 120 (a shirtmaker: 120 to 160); thickness: recalled, 0.27 to 0.32"}},
    {"voile",
     "Voile",
     kWardrobeVoile,
     {"Ne 2/100 x 2/100 / 62 x 58", 58, 0.18, "construction, mass, thickness: recalled, 55 to 65 and 0.16 to 0.20"}},
    {"percale",
     "Percale sheeting",
     kWardrobePercale,
     {"Ne 40 x 40 / 110 x 90", 118, 0.25,
      "construction: recalled, of 200 threads; mass: recalled, 115 to 120; thickness: recalled, 0.23 to 0.28"}},
    {"denim_raw",
     "Denim, 12 oz, raw",
     kWardrobeDenimRaw,
     {"Ne 7 x 7 / 70 x 44, sanforised", 407, 0.76,
      "mass: by its name, 12 oz to the square yard; construction: after a mill's Ne 7 x 10 / 72 x 56; thickness: "
      "recalled, 0.7 to 0.8"}},
    {"denim_washed",
     "Denim, 12 oz, washed",
     kWardrobeDenimWashed,
     {"Ne 7 x 7 / 72 x 45, desized", 415, 0.88,
      "mass: recalled, shrinkage makes up for the size that is lost; thickness: recalled, 0.8 to 0.95"}},
    {"chino_twill",
     "Chino twill",
     kWardrobeChinoTwill,
     {"Ne 20 x 16 / 128 x 60", 250, 0.46,
      "construction, mass: recalled, 245 to 260 (a list of drills: Ne 20 x 16 / 108 x 56); thickness: recalled, 0.43 "
      "to 0.50"}},
    {"canvas",
     "Canvas",
     kWardrobeCanvas,
     {"Ne 2/12 x 2/12 / 48 x 30, army duck", 340, 0.60,
      "mass: by its name, 10 oz to the square yard; construction, thickness: recalled, 0.56 to 0.66"}},
    {"linen",
     "Linen",
     kWardrobeLinen,
     {"Ne 14 x 14 (NeL 39) / 54 x 54", 185, 0.40,
      "construction, mass: recalled, as mills quote it; thickness: recalled, 0.36 to 0.44"}},
    {"tropical_wool",
     "Tropical worsted",
     kWardrobeTropicalWool,
     {"Nm 2/60 x 2/60, 22 x 20 per cm", 150, 0.35,
      "mass: recalled, 220 to 240 g a metre of 150 cm; thickness: recalled, 0.32 to 0.38"}},
    {"herringbone",
     "Worsted herringbone",
     kWardrobeHerringbone,
     {"Nm 2/60 x 2/60, 28 x 25 per cm", 190, 0.45,
      "mass: recalled, 280 to 300 g a metre of 150 cm; thickness: recalled, 0.40 to 0.50"}},
    {"gabardine",
     "Gabardine",
     kWardrobeGabardine,
     {"Nm 2/72 x 2/72, 42 x 25 per cm", 210, 0.45,
      "mass: recalled, 300 to 330 g a metre of 150 cm; thickness: recalled, 0.42 to 0.50"}},
    {"flannel",
     "Flannel",
     kWardrobeFlannel,
     {"woollen Nm 14, 17 x 15.5 per cm, milled and raised", 250, 0.80,
      "mass: recalled, 370 to 400 g a metre of 150 cm; thickness: recalled, 0.7 to 0.9, nap included"}},
    {"tweed",
     "Tweed",
     kWardrobeTweed,
     {"woollen Nm 5.2, 20 x 19 to the inch, milled", 320, 1.10,
      "mass: recalled, 470 to 500 g a metre of 150 cm; thickness: recalled, 1.0 to 1.2"}},
    {"tartan",
     "Tartan",
     kWardrobeTartan,
     {"Nm 2/32 x 2/32, 50 x 48 to the inch, kilting", 264, 0.62,
      "mass: by its name, 13 oz a yard of 60 inches; thickness: recalled, 0.55 to 0.65"}},
    {"charmeuse",
     "Charmeuse",
     kWardrobeCharmeuse,
     {"20/22 den: 2 x 134 / 3 crepe x 50 per cm", 82, 0.19,
      "mass: by its name, 19 momme; a momme is 4.34 g/m2 (silk merchants' tables); construction, thickness: recalled, "
      "0.17 to 0.21"}},
    {"crepe_de_chine",
     "Crepe de chine",
     kWardrobeCrepeDeChine,
     {"20/22 den: 2 x 69 / 4 crepe x 42 per cm", 61, 0.18,
      "mass: by its name, 14 momme (merchants: 12 to 16); construction, thickness: recalled, 0.16 to 0.20"}},
    {"georgette",
     "Georgette",
     kWardrobeGeorgette,
     {"20/22 den: 2 crepe x 50 / 2 crepe x 43 per cm", 35, 0.16,
      "mass: by its name, 8 momme (merchants: 8 to 12); construction, thickness: recalled, 0.14 to 0.18", kCrinkles}},
    {"organza",
     "Organza",
     kWardrobeOrganza,
     {"20/22 den raw, 52 x 48 per cm", 24, 0.10,
      "mass: by its name, 5.5 momme (merchants: 4 to 6); construction, thickness: recalled, 0.08 to 0.11"}},
    {"taffeta",
     "Shot taffeta",
     kWardrobeTaffeta,
     {"20/22 den: organzine 2 x 105 / tram 3 x 47 per cm", 65, 0.13,
      "mass: recalled, 15 momme; construction, thickness: recalled, 0.11 to 0.15"}},
    {"lining_twill",
     "Lining twill",
     kWardrobeLiningTwill,
     {"viscose 84 x 133 dtex, 46 x 28 per cm", 80, 0.13,
      "construction, mass: recalled, 70 to 90; thickness: recalled, 0.12 to 0.15"}},
    {"damask",
     "Table damask",
     kWardrobeDamask,
     {"Ne 20 x 20, 38 x 32 per cm, satin 8", 205, 0.42,
      "construction, mass: recalled, 190 to 220; thickness: recalled, 0.36 to 0.45"}},
    {"honeycomb",
     "Honeycomb",
     kWardrobeHoneycomb,
     {"Ne 2/20 x 2/20, 22 x 20 per cm", 250, 1.30,
      "mass: recalled, 230 to 260; thickness: recalled, 1.0 to 1.5, as washed", kDeepens}},
    {"blanket",
     "Wool blanket",
     kWardrobeBlanket,
     {"woollen Nm 3, 7.2 x 6.6 per cm, milled and raised", 500, 3.50,
      "mass: recalled, 450 to 550; thickness: recalled, 3 to 4, nap included", kRaisedBlanket}},
};

}  // namespace

std::span<const WardrobeCloth> wardrobe() {
  return kCloths;
}

Fabric fabricOf(const WardrobeCloth& cloth) {
  return fabricFromJson(cloth.json, cloth.name);
}

Fabric wardrobeFabric(std::string_view file) {
  const auto found = std::ranges::find(kCloths, file, &WardrobeCloth::file);
  assert(found != std::end(kCloths));
  return fabricOf(*found);
}

}  // namespace loomlight
