#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace loomlight {

/// What a tolerant reader found wrong in a weaving file and put up with. Like warnings are counted rather than
/// repeated, so a file of a million slips gives a list that a person reads.
class WifWarnings {
 public:
  /// `line` counts from 1, 0 for none; `section` without brackets, empty for none; `got` is the text in question, or
  /// empty. Reads: "line 12: [WARP] Threads=many: expected <expected>; <done>".
  void add(int line, std::string_view section, std::string_view got, std::string_view expected, std::string_view done);
  /// A sentence of its own about a section, or about the whole file.
  void add(std::string_view section, std::string_view sentence);

  /// In the order in which each kind was met first.
  std::vector<std::string> list() const;

 private:
  struct Kind {
    std::vector<std::string> shown;
    size_t more = 0;
    std::string summary;
  };
  Kind* kindOf(const std::string& key);

  std::map<std::string, size_t> index_;
  std::vector<Kind> kinds_;
  size_t beyond_ = 0;  ///< warnings of kinds past the most that are kept
};

}  // namespace loomlight
