#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/fabric/model/fabric.h"

namespace loomlight {

/// A cloth on a drape under a light, as somebody looks at it in the editor.
struct ClearSetting {
  std::string cloth, drape, light;
  Fabric fabric;
  std::string name() const { return cloth + ", " + drape + ", " + light; }
};

/// Something that somebody does to a picture that is clear; a drag does it many times, one right after the other.
struct ClearEdit {
  std::string name;
  std::function<Fabric(Fabric fabric)> apply;
  int times = 1;
  /// The fabric after each time.
  std::vector<Fabric> steps(const Fabric& fabric) const;
};

/// Which of them are wanted: those of the named cloths, drapes, lights and edits. Of what no name is given, all.
struct ClearChoice {
  std::vector<std::string> names;
  bool operator()(const std::vector<std::string>& all, const std::string& one) const;
};

/// Six cloths x {flat, cylinder, folds, skirt} x {dome, window, sky}, of those chosen. Quick: one setting.
std::vector<ClearSetting> clearSettings(const ClearChoice& choice, bool quick);
/// To open it; then a crossing, twist, a colour, the light, the drape, the camera, one at a time; and a drag that turns
/// the camera.
std::vector<ClearEdit> clearEdits(const ClearChoice& choice);
/// Every name that can be chosen.
std::vector<std::string> clearNames();

}  // namespace loomlight
