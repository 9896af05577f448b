#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/editor/preset_store.h"
#include "app/editor/preset_tags.h"
#include "app/editor/thumbnails.h"
#include "ui/preset_browser.h"

namespace loomlight {

/// What lies behind the browser of presets: folders of the designer's own, what came with the program, and pictures of
/// it all. Each of the designer's is a file with a fabric, of which its kind takes a part.
class PresetDesk {
 public:
  PresetDesk(std::filesystem::path folder, std::function<void()> wake);

  /// With pictures, which are rendered for as long as they are asked for.
  const std::vector<PresetCard>& cards(PresetKind kind, float scale);
  /// At the end of a frame.
  void follow() { thumbnails_.follow(); }

  /// The fabric with that preset in it: instead of all of it, of the yarn, of that fibre, or of its colours. Throws
  /// InputError.
  Fabric used(PresetKind kind, size_t card, const Fabric& now, int yarn, int fibre) const;

  // Changes of what is kept; each can be taken back. They throw InputError, and have changed nothing then.
  void keep(PresetKind kind, const Fabric& now, int yarn, int fibre);
  void duplicate(PresetKind kind, size_t card);
  void rename(PresetKind kind, size_t card, const std::string& name);
  void remove(PresetKind kind, size_t card);
  void tag(PresetKind kind, size_t card, const std::string& tags);
  void undo();  ///< throws InputError where the newest change cannot be taken back; it can be tried again
  const std::string& lastChange() const;  ///< empty: there is none
  std::string problem() const;            ///< what was kept and cannot be read; empty while all is well

 private:
  struct Entry {
    PresetCard card;
    Fabric fabric;  ///< that the preset is a part of
    std::shared_ptr<const Fabric> portrait;
  };
  struct Shelf {
    PresetStore store;
    PresetTags tags;
    std::vector<Entry> entries;
    std::vector<PresetCard> cards;
    bool read = false;
    float scale = 0;
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
  void read(PresetKind kind, float scale);
  void changed(PresetKind kind, std::string said, std::function<TagAgain()> takeBack);
  void tagAnew(PresetKind kind, const std::string& name, const std::string& tags);

  std::array<Shelf, 4> shelves_;
  std::vector<Change> changes_;
  Thumbnails thumbnails_;
};

}  // namespace loomlight
