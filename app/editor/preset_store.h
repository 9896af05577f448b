#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/fabric/fabric.h"

namespace loomlight {

/// The cloths that a designer keeps at hand: fabric files in a folder of the user's.
class PresetStore {
 public:
  explicit PresetStore(std::filesystem::path folder);

  const std::vector<std::string>& names() const { return names_; }
  /// Throws InputError.
  Fabric load(const std::string& name) const;
  /// Keeps it under its own name; one of the same name is replaced. Returns the name. Throws InputError.
  std::string keep(const Fabric& fabric);

 private:
  void refresh();

  std::filesystem::path folder_;
  std::vector<std::string> names_;
};

/// `cloth`'s weave, yarns, fibres and sett, on `scene`'s drape, in its light, before its camera.
Fabric dressed(const Fabric& scene, const Fabric& cloth);

}  // namespace loomlight
