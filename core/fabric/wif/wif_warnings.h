#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace loomlight {

/// What a warning is about: the crossings, the look of the cloth, or nothing but the file.
enum class WifConcern { weave, look, file };

/// What a tolerant reader put up with in a weaving file.
struct WifWarning {
  std::string sentence;  ///< for a weaver, with its full stop: what was found, and what the cloth has instead
  std::string place;     ///< where to look: "line 12: [WARP] Threads=many"; empty where it is the whole file
  WifConcern concern = WifConcern::weave;
  friend bool operator==(const WifWarning&, const WifWarning&) = default;
};

/// Place and problem in one line: "line 12: [WARP] Threads=many: This is no number.".
std::string inOneLine(const WifWarning& warning);

/// What changes the cloth comes first; else in the order in which they were.
void sortByConcern(std::vector<WifWarning>& warnings);

/// What was found wrong in a weaving file. Like warnings are counted rather than repeated, so a file of a million slips
/// gives a list that a person reads.
class WifWarnings {
 public:
  /// `line` counts from 1, 0 for none; `section` without brackets, empty for none; `got` is the text in question, or
  /// empty. Warnings of one section with the same sentence are of one kind. It concerns what its section is for.
  void add(int line, std::string_view section, std::string_view got, std::string_view sentence);
  void add(int line, std::string_view section, std::string_view got, std::string_view sentence, WifConcern concern);

  /// One for each kind, what changes the cloth first; its place names the first lines, and counts the rest.
  std::vector<WifWarning> list() const;

 private:
  struct Kind {
    WifWarning shown;
    size_t more = 0;  ///< beyond the places that are named
    size_t named = 0;
  };

  std::map<std::string, size_t> index_;
  std::vector<Kind> kinds_;
  size_t beyond_ = 0;  ///< warnings of kinds past the most that are kept
};

}  // namespace loomlight
