#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/fabric/model/fabric.h"

namespace loomlight {

/// The cloths that a designer keeps at hand: fabric files in a folder of the user's.
class PresetFolder {
 public:
  explicit PresetFolder(std::filesystem::path folder);

  const std::vector<std::string>& names() const { return names_; }
  /// Throws InputError.
  Fabric load(const std::string& name) const;
  /// Keeps it under its own name, or that name with a number where it is taken. Returns the name. Throws InputError.
  std::string keep(Fabric fabric);
  /// Gives it another name, or that name with a number where it is taken. Returns the name. Throws InputError.
  std::string rename(const std::string& name, const std::string& to);
  struct Removed {
    std::string name;
    std::filesystem::path file;  ///< where it lies since
  };
  /// Takes it out of the list, and puts it back in. Throw InputError.
  Removed remove(const std::string& name);
  void putBack(const Removed& removed);
  /// Tells whether a preset has changed since.
  struct Stamp {
    std::filesystem::file_time_type time{};
    uintmax_t bytes = 0;
    bool operator==(const Stamp&) const = default;
  };
  /// Nothing special where there is no such file.
  Stamp stampOf(const std::string& name) const;
  /// Looks at the folder again.
  void refresh();

 private:
  std::filesystem::path fileOf(const std::string& name) const { return folder_ / (name + ".json"); }
  void write(const Fabric& fabric, const std::string& name);
  void makeFolder(const std::filesystem::path& folder) const;

  std::filesystem::path folder_;
  std::vector<std::string> names_;
};

/// `cloth`'s weave, yarns, fibres and sett, on `scene`'s drape, in its light, before its camera.
Fabric dressed(const Fabric& scene, const Fabric& cloth);

}  // namespace loomlight
