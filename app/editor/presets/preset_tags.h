#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace loomlight {

/// Words by which a designer finds presets again, also those that came with the program: a file of their own beside the
/// presets.
class PresetTags {
 public:
  /// A file that is missing holds none; nor does one that makes no sense, which is not lost: see problem().
  explicit PresetTags(std::filesystem::path file);

  /// As they were written: "summer, linen". Empty for none.
  std::string of(const std::string& preset) const;
  /// Puts aside first what could not be read, be it a file, a folder or a link. Throws InputError; the tags are as they
  /// were then.
  void set(const std::string& preset, const std::string& tags);
  /// What is wrong with the file, and what becomes of it; empty while all is well.
  const std::string& problem() const { return problem_; }

 private:
  void putAside();

  std::filesystem::path file_;
  std::map<std::string, std::string> tags_;
  std::string problem_;
};

}  // namespace loomlight
