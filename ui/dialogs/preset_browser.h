#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ui/widgets/ui.h"

namespace loomlight {

/// What is kept apart: whole cloths, yarns with their fibre, fibres, and the colours of a cloth's fibres.
enum class PresetKind { fabrics, yarns, fibres, colourways };

struct PresetCard {
  std::string name;
  std::string about;      ///< what it is, in words that can be searched for
  std::string tags;       ///< words of the designer's own, to search for
  bool own = false;       ///< the designer's; others came with the program
  ImTextureID picture{};  ///< null until there is one
};

/// Indices are of the list of cards.
struct PresetBrowserEdit {
  std::optional<size_t> use, duplicate, remove;
  std::optional<std::pair<size_t, std::string>> rename, tag;
  bool keep = false;  ///< what the cloth has now
  bool undo = false;
};

/// All that is kept at hand, by pictures.
class PresetBrowser {
 public:
  void show() { open_ = opening_ = true; }
  bool isOpen() const { return open_; }
  PresetKind kind() const { return kind_; }
  /// The preset that was to be renamed got this name: it is looked at again.
  void renamed(const std::string& name);
  /// `cards`: none while they are still looked for. `lastChange`: what undo would take back, empty for nothing;
  /// `problem`: why the last change was not made.
  PresetBrowserEdit draw(Ui& ui, const std::vector<PresetCard>& cards, const std::string& lastChange,
                         const std::string& problem);

 private:
  void head(Ui& ui);
  void grid(Ui& ui, const std::vector<PresetCard>& cards, PresetBrowserEdit& edit);
  void card(Ui& ui, const PresetCard& card);
  void actions(Ui& ui, const std::vector<PresetCard>& cards, const std::string& lastChange, PresetBrowserEdit& edit);

  bool open_ = false, opening_ = false;
  PresetKind kind_ = PresetKind::fabrics;
  std::string search_;
  /// By these, as the list changes under it: a designer's own may be called as one is that came with the program.
  struct Chosen {
    bool own = false;
    std::string name;
    bool is(const PresetCard& card) const { return own == card.own && name == card.name; }
  };
  std::optional<Chosen> chosen_;
  std::string newName_, newTags_;
};

/// Whether every word that is searched for begins a word of the text; case does not count.
bool matchesSearch(const std::string& text, const std::string& search);

}  // namespace loomlight
