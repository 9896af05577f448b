#include "app/bench/clear_settings.h"

#include <algorithm>
#include <string_view>

#include "bench_cloth_text.h"
#include "core/fabric/json/fabric_json.h"

namespace loomlight {
namespace {

using Names = std::vector<std::string>;

struct NamedCloth {
  const char* name;
  std::string_view json;
  double side_mm;  ///< of a flat piece, such that one sees how it is woven
};
const std::vector<NamedCloth>& cloths() {
  static const std::vector<NamedCloth> all = {{"denim", kBenchDenim, 18},
                                              {"blue_cloth", kBenchBlueCloth, 18},
                                              {"sheer_silk", kBenchSheerSilk, 10},
                                              {"wool_suiting", kBenchWoolSuiting, 20},
                                              {"colourful_cloth", kBenchColourfulCloth, 18},
                                              {"jacquard", kBenchJacquard, 40}};
  return all;
}

/// A drape, and how it is looked at; lengths over the side of the cloth's flat piece.
struct NamedDrape {
  const char* name;
  DrapeKind kind;
  double width, height, radius;  ///< 0: as Drape has it by default
  double elevation_deg, distance;
};
constexpr NamedDrape kDrapes[] = {{"flat", DrapeKind::flat, 1, 1, 0, 58, 1.42},
                                  {"cylinder", DrapeKind::cylinder, 1.4, 1.6, 1.0 / 3, 32, 2.1},
                                  {"folds", DrapeKind::folds, 4, 2, 1.0 / 8, 20, 5},
                                  {"skirt", DrapeKind::skirt, 0, 2, 1.0 / 2, 20, 8}};

struct ClearLight {
  const char* name;
  LightKind kind;
};
constexpr ClearLight kClearLights[] = {
    {"dome", LightKind::dome}, {"window", LightKind::window}, {"sky", LightKind::sky}};

Fabric posed(const NamedCloth& cloth, const NamedDrape& drape, LightKind light) {
  Fabric fabric = fabricFromJson(std::string(cloth.json), cloth.name);
  const double side_mm = cloth.side_mm;
  fabric.drape = Drape{};
  fabric.drape.kind = drape.kind;
  if (drape.width > 0) fabric.drape.width_mm = drape.width * side_mm;
  fabric.drape.height_mm = drape.height * side_mm;
  if (drape.radius > 0) fabric.drape.radius_mm = drape.radius * side_mm;
  fabric.camera = Camera{};
  fabric.camera.azimuth_deg = -90;
  fabric.camera.elevation_deg = drape.elevation_deg;
  fabric.camera.fov_deg = 20;
  fabric.camera.distance_mm = drape.distance * side_mm;
  fabric.light = Light{};
  fabric.light.kind = light;
  return fabric;
}

Fabric drapedOtherwise(Fabric fabric) {
  if (fabric.drape.kind == DrapeKind::flat) {
    fabric.drape.kind = DrapeKind::cylinder;
    fabric.drape.radius_mm = fabric.drape.width_mm / 2;
  } else {
    fabric.drape.radius_mm *= 1.15;
  }
  return fabric;
}

const std::vector<ClearEdit>& allEdits() {
  static const std::vector<ClearEdit> edits = {
      {"open", [](Fabric f) { return f; }},
      {"crossing",
       [](Fabric f) {
         const int pick = f.weave.picks() / 2, end = f.weave.ends() / 2;
         f.weave = f.weave.with(pick, end, !f.weave.at(pick, end));
         f.draft.reset();
         return f;
       }},
      {"twist",
       [](Fabric f) {
         f.yarns[0].plyTwist_per_m *= 1.1;
         return f;
       }},
      {"colour",
       [](Fabric f) {
         f.fibres[0].absorption_per_mm.primaries += Rgb(1, 8, 16);
         return f;
       }},
      {"light",
       [](Fabric f) {
         if (f.light.kind == LightKind::dome) f.light.kind = LightKind::overcast;
         f.light.azimuth_deg += 40;
         return f;
       }},
      {"drape", drapedOtherwise},
      {"camera",
       [](Fabric f) {
         f.camera.azimuth_deg += 15;
         return f;
       }},
      {"drag",
       [](Fabric f) {
         f.camera.azimuth_deg += 2;
         return f;
       },
       20},
  };
  return edits;
}

template <class List>
Names namesOf(const List& list) {
  Names names;
  for (const auto& one : list) names.push_back(one.name);
  return names;
}

}  // namespace

std::vector<Fabric> ClearEdit::steps(const Fabric& fabric) const {
  std::vector<Fabric> all{apply(fabric)};
  while (all.size() < static_cast<size_t>(times)) all.push_back(apply(all.back()));
  return all;
}

bool ClearChoice::operator()(const Names& all, const std::string& one) const {
  const auto named = [&](const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  return named(one) || std::none_of(all.begin(), all.end(), named);
}

std::vector<std::string> clearNames() {
  Names names = namesOf(cloths());
  for (const Names& more : {namesOf(kDrapes), namesOf(kClearLights), namesOf(allEdits())})
    names.insert(names.end(), more.begin(), more.end());
  return names;
}

std::vector<ClearSetting> clearSettings(const ClearChoice& choice, bool quick) {
  std::vector<ClearSetting> settings;
  for (const NamedCloth& cloth : cloths())
    for (const NamedDrape& drape : kDrapes)
      for (const ClearLight& light : kClearLights)
        if (choice(namesOf(cloths()), cloth.name) && choice(namesOf(kDrapes), drape.name) &&
            choice(namesOf(kClearLights), light.name))
          settings.push_back({cloth.name, drape.name, light.name, posed(cloth, drape, light.kind)});
  if (quick && !settings.empty()) settings.erase(settings.begin() + 1, settings.end());
  return settings;
}

std::vector<ClearEdit> clearEdits(const ClearChoice& choice) {
  std::vector<ClearEdit> edits;
  for (const ClearEdit& edit : allEdits())
    if (choice(namesOf(allEdits()), edit.name)) edits.push_back(edit);
  return edits;
}

}  // namespace loomlight
