#include "core/fabric/yarn/presets.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "core/fabric/model/finish.h"
#include "core/fabric/model/validate.h"
#include "core/fabric/model/yarn_count.h"
#include "core/fabric/yarn/colour.h"
#include "core/fabric/yarn/yarn_reflectance.h"

namespace loomlight {
namespace {

/// An undyed fibre; `colour` is linear reflectance of the loose stock.
struct Stock {
  const char* name;
  double fineness_dtex, density_g_cm3, refractiveIndex;
  double longitudinalRoughness, azimuthalRoughness, scaleTilt_deg;
  FibreSection section;
  Rgb colour;
  FibreSources sources;
};

constexpr const char* kGuess = "guess";
constexpr const char* kNoScales = "handbook: the surface has no scales";
constexpr const char* kScales = "handbook, recalled: cuticle scales of hair, 2 to 3 degrees";
constexpr const char* kKeratin = "measured (von Bergen: 1.56 along, 1.55 across)";

const Stock kStocks[] = {
    {"cotton",
     1.7,
     1.52,
     1.547,
     0.30,
     0.45,
     0,
     FibreSection::kidney,
     {0.84f, 0.79f, 0.70f},
     {"handbook (Morton & Hearle: 1.0-3.4 dtex)", "handbook (Morton & Hearle: 1.52 at 65 % rh)",
      "handbook, recalled (1.578 along, 1.532 across)", kGuess, kNoScales, kGuess}},
    {"wool",
     3.7,
     1.31,
     1.553,
     0.25,
     0.30,
     2.5,
     FibreSection::round,
     {0.78f, 0.71f, 0.58f},
     {"handbook (Morton & Hearle: 3.4-4.6 dtex for 18-21 um, fine merino)", "handbook (Morton & Hearle: 1.31)",
      kKeratin, kGuess, kScales, kGuess}},
    {"silk",
     1.3,
     1.34,
     1.556,
     0.12,
     0.25,
     0,
     FibreSection::triangle,
     {0.86f, 0.82f, 0.75f},
     {"handbook (Morton & Hearle: 0.95-1.6 dtex)", "handbook (Morton & Hearle: 1.34)",
      "handbook, recalled (1.591 along, 1.538 across)", kGuess, kNoScales,
      "guess, within the measured bound of 0.64/mm"}},
    {"linen",
     2.4,
     1.50,
     1.547,
     0.25,
     0.40,
     0,
     FibreSection::polygon,
     {0.60f, 0.52f, 0.40f},
     {"handbook (12-17 um)", "handbook (Morton & Hearle: 1.50-1.53)",
      "measured (von Bergen: 1.58-1.60 along, 1.52-1.53 across)", kGuess, kNoScales, kGuess}},
    {"viscose",
     1.7,
     1.49,
     1.527,
     0.18,
     0.35,
     0,
     FibreSection::serrated,
     {0.90f, 0.89f, 0.86f},
     {"handbook, recalled (1.2-3 dtex)", "handbook (Morton & Hearle: 1.49)",
      "handbook, recalled (1.54 along, 1.52 across)", kGuess, kNoScales, kGuess}},
    {"polyester",
     1.7,
     1.39,
     1.597,
     0.15,
     0.20,
     0,
     FibreSection::round,
     {0.92f, 0.92f, 0.91f},
     {"handbook (0.9-3.5 dtex)", "handbook (Morton & Hearle: 1.39)",
      "measured (DuPont X-156: 1.71-1.73 along, 1.53-1.54 across)", kGuess, kNoScales, kGuess}},
    {"nylon",
     1.7,
     1.14,
     1.540,
     0.15,
     0.20,
     0,
     FibreSection::round,
     {0.92f, 0.92f, 0.90f},
     {"handbook, recalled (1-20 dtex)", "handbook (Morton & Hearle: 1.14)",
      "measured (DuPont X-156: 1.57-1.59 along, 1.51-1.53 across)", kGuess, kNoScales, kGuess}},
    {"acrylic",
     2.2,
     1.19,
     1.515,
     0.20,
     0.30,
     0,
     FibreSection::kidney,
     {0.90f, 0.89f, 0.85f},
     {"handbook, recalled (1-8 dtex)", "handbook (Morton & Hearle: 1.19)",
      "measured (DuPont X-156: 1.50-1.53 both ways)", kGuess, kNoScales, kGuess}},
    {"mohair",
     12.6,
     1.31,
     1.553,
     0.15,
     0.25,
     2.0,
     FibreSection::round,
     {0.82f, 0.77f, 0.66f},
     {"measured (UAF: 25-45 um)", "handbook, recalled: as wool", kKeratin, "guess: mohair is lustrous",
      "guess: faint scales", kGuess}},
    {"alpaca",
     6.4,
     1.31,
     1.553,
     0.25,
     0.30,
     2.5,
     FibreSection::round,
     {0.74f, 0.67f, 0.55f},
     {"measured (UAF: 17-35 um)", "handbook, recalled: as wool", "handbook, recalled: as wool", kGuess, kScales,
      kGuess}},
    {"cashmere",
     2.6,
     1.31,
     1.553,
     0.25,
     0.30,
     2.5,
     FibreSection::round,
     {0.80f, 0.74f, 0.64f},
     {"measured (UAF: 14-18.5 um)", "handbook, recalled: as wool", "handbook, recalled: as wool", kGuess, kScales,
      kGuess}},
};

FibrePreset preset(const Stock& stock) {
  Fibre fibre;
  fibre.name = stock.name;
  fibre.density_g_cm3 = stock.density_g_cm3;
  fibre.radius_um = std::round(100.0 * fibreRadius_um(stock.fineness_dtex, stock.density_g_cm3)) / 100.0;
  fibre.refractiveIndex = stock.refractiveIndex;
  fibre.longitudinalRoughness = stock.longitudinalRoughness;
  fibre.azimuthalRoughness = stock.azimuthalRoughness;
  fibre.scaleTilt_deg = stock.scaleTilt_deg;
  fibre.section = stock.section;
  return {dyed(fibre, stock.colour), stock.fineness_dtex, stock.sources};
}

Fibre fibreNamed(const std::string& name) {
  const auto* found =
      std::find_if(std::begin(kStocks), std::end(kStocks), [&](const Stock& s) { return name == s.name; });
  assert(found != std::end(kStocks));
  return preset(*found).fibre;
}

/// A count in any system, rounded to what one would type.
double tex(double value, CountSystem system) {
  return std::round(100.0 * texFromCount(value, system)) / 100.0;
}
double turns(double twistMultiplier, double tex) {
  return std::round(twist_per_m(twistMultiplier, tex));
}

/// Spun of staple fibres on a ring: one single, Z. Its hairs are for hairy() to say.
Yarn ringSpun(const char* name, double count_tex, double twistMultiplier) {
  Yarn yarn;
  yarn.name = name;
  yarn.count_tex = count_tex;
  yarn.plyTwist_per_m = turns(twistMultiplier, count_tex);
  yarn.packing = 0.55;
  yarn.flattening = 1.25;
  yarn.hairLength_mm = 0.5;
  yarn.migration = 0.25;
  yarn.fibreDisorder_deg = 6;
  yarn.evennessCv_percent = 15;
  return yarn;
}

/// Spun in a rotor: bulkier, straying more, with wrapper fibres.
Yarn rotorSpun(const char* name, double count_tex, double twistMultiplier) {
  Yarn yarn = ringSpun(name, count_tex, twistMultiplier);
  yarn.packing = 0.5;
  yarn.fibreDisorder_deg = 11;
  yarn.wrappers_per_cm = 4;
  return yarn;
}

/// Of the long fibres that combing leaves.
Yarn combed(Yarn yarn) {
  yarn.fibreDisorder_deg = 5;
  yarn.evennessCv_percent = 13.5;
  return yarn;
}

/// Spun on a ring from a strand that suction has drawn together, which ties most hairs in.
Yarn compactSpun(const char* name, double count_tex, double twistMultiplier) {
  Yarn yarn = combed(ringSpun(name, count_tex, twistMultiplier));
  yarn.packing = 0.6;
  yarn.fibreDisorder_deg = 4;
  return yarn;
}

/// Of carded wool, condensed and hardly drawn: soft, full, uneven, its fibres lying anyhow.
Yarn woollenSpun(const char* name, double count_tex, double twistMultiplier) {
  Yarn yarn = ringSpun(name, count_tex, twistMultiplier);
  yarn.packing = 0.4;
  yarn.flattening = 1.2;
  yarn.hairLength_mm = 1.2;
  yarn.migration = 0.4;
  yarn.fibreDisorder_deg = 13;
  yarn.evennessCv_percent = 17;
  return yarn;
}

/// Two singles, twisted the other way; 60 to 70 % of their twist makes a yarn that does not kink.
Yarn twoPly(Yarn single, double plyingTwist_per_m) {
  single.count_tex *= 2;
  single.plies = 2;
  single.evennessCv_percent = 10.5;  // of two independent singles, over the square root of two
  single.yarnTwist_per_m = plyingTwist_per_m;
  single.yarnTwistDirection = TwistDirection::s;
  single.flattening = 1.15;
  return single;
}

/// Some plied yarns, twisted back once more: firm, round, closed.
Yarn cable(const char* name, Yarn plied, int cords, double cabling_per_m) {
  plied.name = name;
  plied.count_tex *= cords;
  plied.cords = cords;
  plied.evennessCv_percent = 6;
  plied.cableTwist_per_m = cabling_per_m;
  plied.flattening = 1.05;
  return plied;
}

/// Of a fibre, with as many hairs as make up Uster's H.
YarnPreset hairy(const Yarn& yarn, double hairinessH, const char* fibreName, std::string provenance) {
  Fibre fibre = fibreNamed(fibreName);
  return {withHairinessH(yarn, fibre, hairinessH), std::move(fibre), std::move(provenance)};
}

/// Endless fibres, hardly twisted, no hairs.
Yarn filament(const char* name, double count_tex, double twist_per_m, double packing, double flattening) {
  Yarn yarn;
  yarn.name = name;
  yarn.count_tex = count_tex;
  yarn.plyTwist_per_m = twist_per_m;
  yarn.packing = packing;
  yarn.flattening = flattening;
  yarn.fibreDisorder_deg = 1;
  return yarn;
}

}  // namespace

double twist_per_m(double twistMultiplier, double tex) {
  return 957.0 * twistMultiplier / std::sqrt(tex);
}

double twistMultiplier(double twist_per_m, double tex) {
  return twist_per_m * std::sqrt(tex) / 957.0;
}

Fabric plainCotton() {
  const YarnPreset cotton = yarnPresets().front();
  Fabric fabric;
  fabric.yarns = {cotton.yarn};
  fabric.fibres = {cotton.fibre};
  fabric.ends_per_cm = 28;
  fabric.picks_per_cm = 26;
  fabric.settCv_percent = 4;
  return fabric;
}

Fibre dyed(Fibre fibre, const Rgb& colour) {
  fibre.absorption_per_mm = absorptionFromColour(colour, fibre.azimuthalRoughness, fibre.radius_um);
  return fibre;
}

Fibre dyedLike(Fibre fibre, const Fibre& other) {
  if (!other.absorption_per_mm.isSpectral()) return dyed(std::move(fibre), fibreReflectance(other));
  fibre.absorption_per_mm = other.absorption_per_mm;
  return fibre;
}

std::vector<FibrePreset> fibrePresets() {
  std::vector<FibrePreset> presets;
  for (const Stock& stock : kStocks) presets.push_back(preset(stock));
  return presets;
}

Yarn usuallySpun(const Fibre& fibre) {
  const std::vector<YarnPreset> presets = yarnPresets();
  const auto firstOf = [&](const std::string& name) {
    return std::ranges::find_if(presets, [&](const YarnPreset& of) { return of.fibre.name == name; });
  };
  const auto own = firstOf(fibre.name);
  const YarnPreset& usual = own != presets.end() ? *own : *firstOf("wool");
  Yarn yarn = usual.yarn;
  const Yarn single;  // as heavy, so that two fibres differ in nothing else
  yarn.name = single.name;
  yarn.count_tex = single.count_tex;
  yarn.plies = yarn.cords = 1;
  yarn.yarnTwist_per_m = yarn.cableTwist_per_m = 0;
  const double single_tex = usual.yarn.count_tex / singlesIn(usual.yarn);
  yarn.plyTwist_per_m = turns(twistMultiplier(usual.yarn.plyTwist_per_m, single_tex), yarn.count_tex);
  yarn.evennessCv_percent *= limitCv_percent(yarn, fibre) / limitCv_percent(usual.yarn, usual.fibre);
  return withHairinessH(std::move(yarn), fibre, hairinessH(usual.yarn, usual.fibre));
}

std::vector<YarnPreset> yarnPresets() {
  const char* const spun =
      "count, twist: handbook (TM 3.8-4.5); packing: handbook (0.5-0.6); hairiness, evenness: "
      "handbook, recalled (Uster Statistics); length of hairs, flattening, migration, disorder: guess";
  const char* const flat = "count: handbook; packing: handbook, recalled (0.7-0.8); twist, flattening, disorder: guess";
  Yarn worsted = twoPly(ringSpun("Worsted wool 2/60 Nm", tex(60, CountSystem::metric), 2.8), 430);
  worsted.packing = 0.5;
  worsted.fibreDisorder_deg = 4;
  worsted.evennessCv_percent = 12.5;
  Yarn fine = combed(ringSpun("Cotton Ne 60, combed", tex(60, CountSystem::cotton), 4.0));
  fine.evennessCv_percent = 15.3;  // a tenth above what its few fibres have at random
  Yarn linen = ringSpun("Linen NeL 40", tex(40, CountSystem::linen), 3.0);
  linen.packing = 0.6;
  linen.evennessCv_percent = 22;
  return {
      hairy(ringSpun("Cotton Ne 30", tex(30, CountSystem::cotton), 4.0), 5.5, "cotton", spun),
      hairy(fine, 4.5, "cotton", spun),
      hairy(compactSpun("Cotton Ne 40, compact", tex(40, CountSystem::cotton), 3.8), 3.5, "cotton", spun),
      hairy(ringSpun("Cotton Ne 7, denim warp", tex(7, CountSystem::cotton), 4.4), 7, "cotton", spun),
      hairy(rotorSpun("Cotton Ne 10, rotor", tex(10, CountSystem::cotton), 4.6), 4.5, "cotton",
            "count, twist: handbook (open-end TM 4.5-5); hairiness, evenness: handbook, recalled (Uster Statistics); "
            "packing, length of hairs, flattening, migration, disorder, wrapper fibres: guess"),
      hairy(twoPly(ringSpun("Cotton 8/2", tex(8, CountSystem::cotton), 3.6), 250), 5.5, "cotton", spun),
      hairy(
          cable("Cotton cable 30/2/3", twoPly(ringSpun("", tex(30, CountSystem::cotton), 4.0), 560), 3, 365), 5,
          "cotton",
          "count: handbook (cabled as sewing and crochet threads are); twist: guess (each level takes back 65 % of the "
          "one before); packing: handbook (0.5-0.6); evenness: of six independent singles; hairs, flattening, "
          "migration, disorder: guess"),
      hairy(worsted, 5, "wool",
            "count: handbook; twist: guess (plying at 65 % of the singles' twist); packing: handbook, recalled "
            "(0.45-0.55); evenness: handbook, recalled (Uster Statistics); hairs, flattening, migration, disorder: "
            "guess"),
      hairy(woollenSpun("Woollen Nm 6", tex(6, CountSystem::metric), 3.6), 10, "wool",
            "count: handbook (tweeds of Nm 5 to 8); evenness: handbook, recalled; twist, packing, hairs, flattening, "
            "migration, disorder: guess"),
      hairy(linen, 3, "linen",
            "count: handbook; evenness: handbook, recalled (wet-spun line); twist, packing, hairs, flattening, "
            "migration, disorder: guess"),
      {filament("Silk 20/22 den", tex(21, CountSystem::denier), 150, 0.7, 1.3), fibreNamed("silk"), flat},
      {filament("Silk crepe 20/22 den x 2", tex(42, CountSystem::denier), 2400, 0.75, 1.05), fibreNamed("silk"), flat},
      {filament("Viscose 84 dtex", 8.4, 120, 0.7, 1.4), fibreNamed("viscose"), flat},
      {filament("Polyester 167 dtex", 16.7, 100, 0.65, 1.5), fibreNamed("polyester"), flat},
      {filament("Nylon 78 dtex", 7.8, 100, 0.7, 1.5), fibreNamed("nylon"), flat},
  };
}

}  // namespace loomlight
