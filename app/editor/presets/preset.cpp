#include "app/editor/presets/preset.h"

#include <fmt/core.h>

#include <cmath>
#include <utility>

#include "app/editor/model/sample_fabric.h"
#include "app/editor/model/yarn_close_up.h"
#include "app/editor/presets/preset_folder.h"
#include "core/fabric/model/colourways.h"
#include "core/fabric/model/height_seen.h"
#include "core/fabric/model/yarn_count.h"
#include "core/fabric/yarn/presets.h"
#include "core/fabric/yarn/yarn_edit.h"
#include "ui/words/preset_words.h"

namespace loomlight {
namespace {

constexpr int kWidth = 168, kHeight = 120;

/// A few crossings of a cloth, flat under a sky.
Fabric portraitOf(Fabric fabric, int width, int height) {
  constexpr double kSeen_mm = 6;
  fabric.drape = Drape{};
  fabric.drape.width_mm = 2.4 * kSeen_mm;
  fabric.drape.height_mm = 2 * kSeen_mm;
  fabric.camera = Camera{};
  fabric.camera.elevation_deg = 65;
  fabric.camera.distance_mm = kSeen_mm / heightSeenPerDistance(fabric.camera);
  fabric.light = Light{};
  fabric.render = RenderSettings{};
  fabric.render.width = width;
  fabric.render.height = height;
  fabric.render.samplesPerPixel = 16;
  fabric.render.resolution = 4;
  return fabric;
}

/// A yarn of the trade, or a fibre in a plain cloth.
Fabric clothOf(const std::string& name, const Yarn& yarn, const Fibre& fibre) {
  Fabric fabric;
  fabric.name = name;
  fabric.yarns = {yarn};
  fabric.yarns[0].fibre = 0;
  fabric.fibres = {fibre};
  return fabric;
}

std::string aboutCloth(const Fabric& fabric) {
  std::string about = fmt::format(words::presets::cloth, fabric.weave.ends(), fabric.weave.picks(), fabric.ends_per_cm,
                                  fabric.picks_per_cm);
  for (const Fibre& fibre : fabric.fibres) about += "; " + fibre.name;
  return fabric.description.empty() ? about : fabric.description + "\n" + about;
}

std::string aboutYarn(const Yarn& yarn, const Fibre& fibre) {
  std::string folded =
      yarn.plies == 1 ? fmt::format(words::presets::ply, yarn.plies) : fmt::format(words::presets::plies, yarn.plies);
  if (yarn.cords > 1) folded = fmt::format(words::presets::cabled, yarn.cords, folded);
  return fmt::format("{:.1f} tex, {}, {}", yarnCount_tex(yarn, fibre), folded, fibre.name);
}

std::string aboutFibre(const Fibre& fibre) {
  return fmt::format(words::presets::fibre, 2 * fibre.radius_um, fibreFineness_dtex(fibre));
}

std::string aboutOf(PresetKind kind, const Fabric& fabric) {
  switch (kind) {
    case PresetKind::fabrics:
      return aboutCloth(fabric);
    case PresetKind::yarns:
      return aboutYarn(fabric.yarns[0], fabric.fibres[0]);
    case PresetKind::fibres:
      return aboutFibre(fabric.fibres[0]);
    case PresetKind::colourways:
      break;
  }
  const size_t fibres = fabric.fibres.size();
  return fibres == 1 ? words::presets::colour : fmt::format(words::presets::colours, fibres);
}

/// What came with the program.
std::vector<Fabric> givenFabrics(PresetKind kind) {
  std::vector<Fabric> fabrics;
  if (kind == PresetKind::fabrics || kind == PresetKind::colourways)
    for (size_t i = 0; i < sampleNames().size(); ++i) {
      fabrics.push_back(sampleFabric(i));
      fabrics.back().name = sampleNames()[i];
    }
  if (kind == PresetKind::yarns)
    for (const YarnPreset& preset : yarnPresets())
      fabrics.push_back(clothOf(preset.yarn.name, preset.yarn, preset.fibre));
  if (kind == PresetKind::fibres)
    for (const FibrePreset& preset : fibrePresets())
      fabrics.push_back(clothOf(preset.fibre.name, usuallySpun(preset.fibre), preset.fibre));
  return fabrics;
}

/// Only what the yarn and its fibre are; a blend is kept as its first fibre.
Fabric aloneWith(const Fabric& fabric, int yarn, int fibre) {
  Yarn alone = fabric.yarns[static_cast<size_t>(yarn)];
  alone.blendFibre.reset();
  alone.blendShare.reset();
  return clothOf(alone.name, alone, fabric.fibres[static_cast<size_t>(fibre)]);
}

}  // namespace

Preset presetOf(PresetKind kind, Fabric fabric, std::string name, bool own, float scale) {
  const int width = static_cast<int>(std::lround(kWidth * scale)),
            height = static_cast<int>(std::lround(kHeight * scale));
  Preset preset;
  preset.name = std::move(name);
  preset.about = aboutOf(kind, fabric);
  preset.own = own;
  preset.portrait = std::make_shared<const Fabric>(kind == PresetKind::yarns ? yarnCloseUp(fabric, 0, width, height)
                                                                             : portraitOf(fabric, width, height));
  preset.fabric = std::make_shared<const Fabric>(std::move(fabric));
  return preset;
}

std::vector<Preset> givenPresets(PresetKind kind, float scale) {
  std::vector<Preset> presets;
  for (Fabric& fabric : givenFabrics(kind)) {
    std::string name = fabric.name;
    presets.push_back(presetOf(kind, std::move(fabric), std::move(name), false, scale));
  }
  return presets;
}

Fabric toKeep(PresetKind kind, const Fabric& now, int yarn, int fibre) {
  if (kind == PresetKind::yarns) return aloneWith(now, yarn, now.yarns[static_cast<size_t>(yarn)].fibre);
  if (kind != PresetKind::fibres) return now;
  Fabric fabric = aloneWith(now, yarn, fibre);
  fabric.name = fabric.fibres[0].name;
  return fabric;
}

Fabric withPreset(PresetKind kind, const Preset& from, const Fabric& now, int yarn, int fibre) {
  const Fabric& preset = *from.fabric;
  // What came with the program is undyed: the colour stays the designer's.
  const Fibre& old = now.fibres[static_cast<size_t>(fibre)];
  const auto coloured = [&](const Fibre& of) { return from.own ? of : dyedLike(of, old); };
  switch (kind) {
    case PresetKind::fabrics:
      return dressed(now, preset);
    case PresetKind::yarns:
      return withYarn(now, yarn, preset.yarns[0], coloured(preset.fibres[0]));
    case PresetKind::fibres: {
      Fabric fabric = now;
      Fibre& changed = fabric.fibres[static_cast<size_t>(fibre)];
      const std::string name = changed.name;
      changed = coloured(preset.fibres[0]);
      changed.name = name;
      return fabric;
    }
    case PresetKind::colourways:
      break;
  }
  return inColourway(now, colourwayOf(preset, preset.name));
}

}  // namespace loomlight
