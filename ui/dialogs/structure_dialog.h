#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/fabric/weave/structure_library.h"
#include "ui/draft/draft_view.h"
#include "ui/widgets/ui.h"

namespace loomlight {

/// The library of structures: chosen from thumbnails, varied by their numbers, applied again and again.
class StructureDialog {
 public:
  StructureDialog() { choose(4); }  // a twill
  void show() { open_ = opening_ = true; }
  bool isOpen() const { return open_; }
  /// The structure to apply, once. `darkLight`: display colours of yarns A and B, for effects of colour.
  std::optional<MadeStructure> draw(Ui& ui, const std::optional<CellRect>& selection, const ImVec4 (&darkLight)[2]);

 private:
  void drawKinds(Ui& ui, const ImVec4 (&darkLight)[2], float width, float height, bool& apply);
  void drawChosen(Ui& ui, const std::optional<CellRect>& selection, const ImVec4 (&darkLight)[2], bool alike);
  void choose(size_t kind);
  void make();

  bool open_ = false, opening_ = false;
  size_t kind_ = 0;
  std::vector<int> values_;
  MadeStructure made_;
  std::string facts_;                      ///< of it
  std::vector<MadeStructure> thumbnails_;  ///< one a kind, with its first numbers
};

}  // namespace loomlight
