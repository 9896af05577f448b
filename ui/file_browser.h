#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ui/ui.h"

namespace loomlight {

/// A dialog that names a file. Places on the left, the folder in the middle, a path that can be typed below.
class FileBrowser {
 public:
  struct Place {
    std::string name;
    std::filesystem::path path;
  };
  enum class Purpose { open, save };

  /// `extensions` with their dots (".json"); the first is appended to a typed name that has none of them.
  void show(Purpose purpose, std::string title, std::vector<std::string> extensions, std::filesystem::path start,
            std::vector<Place> places);
  bool isOpen() const { return open_; }

  /// Draws it while it is open. Returns the file once, when the choice is made.
  std::optional<std::string> draw(Ui& ui);

 private:
  struct Entry {
    std::string name;
    bool folder = false;
  };
  void enter(const std::filesystem::path& folder);
  bool accepts(const std::filesystem::path& file) const;
  void drawPlaces(Ui& ui, float width, float height);
  /// True when a file was double-clicked.
  bool drawEntries(Ui& ui, float height);
  /// `mayReplace`: by the button, which says so; a key that is pressed twice must not.
  std::optional<std::string> decide(bool mayReplace);

  bool open_ = false;
  bool opening_ = false;
  Purpose purpose_ = Purpose::open;
  std::string title_;
  std::vector<std::string> extensions_;
  std::vector<Place> places_;
  std::filesystem::path folder_;
  std::vector<Entry> entries_;
  std::string typed_;
  std::string problem_;
  std::string toReplace_;  ///< a file that is there already, once the user was asked; empty: none
};

}  // namespace loomlight
