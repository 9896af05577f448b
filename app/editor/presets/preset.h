#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/fabric/model/fabric.h"
#include "ui/dialogs/preset_browser.h"

namespace loomlight {

/// What is kept at hand, as it is shown: a fabric, of which its kind takes a part.
struct Preset {
  std::string name, about, tags;
  bool own = false;                        ///< the designer's; others came with the program
  std::shared_ptr<const Fabric> fabric;    ///< that it is a part of
  std::shared_ptr<const Fabric> portrait;  ///< what its picture is rendered from
};

/// Without tags, and its picture of a size for `scale` of the screen.
Preset presetOf(PresetKind kind, Fabric fabric, std::string name, bool own, float scale);

/// What came with the program.
std::vector<Preset> givenPresets(PresetKind kind, float scale);

/// What is kept of a fabric as a preset of that kind.
Fabric toKeep(PresetKind kind, const Fabric& now, int yarn, int fibre);

/// The fabric with that preset in it: instead of all of it, of the yarn, of that fibre, or of its colours.
Fabric withPreset(PresetKind kind, const Preset& preset, const Fabric& now, int yarn, int fibre);

}  // namespace loomlight
