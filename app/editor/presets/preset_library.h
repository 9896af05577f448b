#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/presets/preset.h"
#include "app/editor/presets/preset_folder.h"
#include "app/editor/presets/preset_tags.h"
#include "ui/words/preset_words.h"

namespace loomlight {

/// All presets: folders of the designer's own, each of them a file, and what came with the program. Reads and writes
/// where it is called, which may take long: see PresetService.
class PresetLibrary {
 public:
  explicit PresetLibrary(const std::filesystem::path& folder);

  /// Looks at the folder anew. What was read of it and has not changed stays.
  void look(PresetKind kind, float scale);
  /// Reads one more; false once all have been.
  bool readNext(PresetKind kind);
  /// What has been read by now, by names, and what came with the program. A file that is no preset is not among them.
  std::vector<Preset> presets(PresetKind kind) const;
  /// Of the designer's own cloths, read or not.
  const std::vector<std::string>& names() const { return of(PresetKind::fabrics).store.names(); }

  // Changes of what is kept; each can be taken back. They throw InputError, and have changed nothing then, or all but
  // the tags.
  /// `done`: what it is called. Returns the name that it got.
  std::string keep(PresetKind kind, Fabric fabric, const std::string& tags = "",
                   const char* done = words::presets::kept);
  /// Returns the name that it got.
  std::string rename(PresetKind kind, const std::string& before, const std::string& name);
  void remove(PresetKind kind, const std::string& name);
  void tag(PresetKind kind, const std::string& name, bool own, const std::string& tags);
  void undo();  ///< throws InputError where the newest change cannot be taken back; it can be tried again
  const std::string& lastChange() const;  ///< empty: there is none
  std::string problem() const;            ///< what was kept and cannot be read; empty while all is well

 private:
  struct Read {
    PresetFolder::Stamp stamp;
    std::optional<Preset> preset;  ///< none where the file is not one
    bool tooMany = false;
  };
  struct Shelf {
    PresetFolder store;
    PresetTags tags;
    std::map<std::string, Read> read;
    std::vector<Preset> given;
    float scale = 0;  ///< that the pictures are for
  };
  /// What is left to be done with the tags once a change of presets is taken back: it may fail for itself.
  using TagAgain = std::function<void()>;
  struct Change {
    std::string said;
    std::function<TagAgain()> takeBack;
  };
  static Shelf shelfIn(const std::filesystem::path& folder);
  Shelf& of(PresetKind kind) { return shelves_[static_cast<size_t>(kind)]; }
  const Shelf& of(PresetKind kind) const { return shelves_[static_cast<size_t>(kind)]; }
  void changed(std::string said, std::function<TagAgain()> takeBack);
  void tagAnew(PresetKind kind, const std::string& name, const std::string& tags);

  std::array<Shelf, 4> shelves_;
  std::vector<Change> changes_;
};

}  // namespace loomlight
