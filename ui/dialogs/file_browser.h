#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ui/dialogs/file_preview.h"

namespace loomlight {

/// A dialog that names a file, or a folder. Places on the left, the folder in the middle, a look at what is chosen on
/// the right, a path that can be typed below.
class FileBrowser {
 public:
  struct Bookmark {
    std::string name;
    std::filesystem::path path;
  };
  enum class Purpose { open, save, folder };

  /// `extensions` with their dots (".json"); the first is appended to a typed name that has none of them. A folder has
  /// none: it is the one that is entered, or a new one in it where a name is typed.
  void show(Purpose purpose, std::string title, std::vector<std::string> extensions, const std::filesystem::path& start,
            std::vector<Bookmark> bookmarks);
  bool isOpen() const { return open_; }

  /// What is to be previewed: the file that is named now, which may be none, or not there.
  std::string chosen() const { return typed_.empty() ? std::string() : named().string(); }

  /// Draws it while it is open. Returns the file once, when the choice is made.
  std::optional<std::string> draw(Ui& ui, const FilePreview& preview);

 private:
  struct Entry {
    std::string name;
    std::string lower;  ///< the same in lower case, by which it is filtered
    bool folder = false;
    bool passes(const std::string& lowerFilter) const { return lower.find(lowerFilter) != std::string::npos; }
  };
  void enter(const std::filesystem::path& folder);
  /// The folder, or what is there still: the nearest above it, or else the first of the bookmarks.
  void enterNearest(std::filesystem::path folder);
  bool accepts(const std::filesystem::path& file) const;
  /// What is typed, from the folder that is shown.
  std::filesystem::path named() const;
  /// Names the next file of the list in that direction, as long as there is one.
  void step(int direction);
  void drawHead(Ui& ui);
  void drawName(Ui& ui, bool begin, bool& decided);
  void drawBookmarks(Ui& ui, float width, float height);
  /// True when a file was double-clicked.
  bool drawEntries(Ui& ui, float width, float height);
  /// `mayReplace`: by the button, which says so; a key that is pressed twice must not.
  std::optional<std::string> decide(bool mayReplace);
  std::optional<std::string> decideFolder();

  bool open_ = false;
  bool opening_ = false;
  bool reveals_ = false;  ///< the list moves to the file that is named
  Purpose purpose_ = Purpose::open;
  std::string title_;
  std::vector<std::string> extensions_;
  std::vector<Bookmark> bookmarks_;
  std::filesystem::path folder_;
  std::vector<Entry> entries_;
  bool isCut_ = false;  ///< the folder has more than was looked at
  std::string filter_;
  std::string typed_;
  std::string problem_;
  std::string toReplace_;  ///< a file that is there already, once the user was asked; empty: none
};

}  // namespace loomlight
