#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace loomlight {

/// Words by which a designer finds presets again, also those that came with the program: a file of their own beside the
/// presets.
class PresetTags {
 public:
  /// A file that is missing or makes no sense holds none.
  explicit PresetTags(std::filesystem::path file);

  /// As they were written: "summer, linen". Empty for none.
  std::string of(const std::string& preset) const;
  /// Throws InputError, and has changed nothing then.
  void set(const std::string& preset, const std::string& tags);

 private:
  std::filesystem::path file_;
  std::map<std::string, std::string> tags_;
};

}  // namespace loomlight
