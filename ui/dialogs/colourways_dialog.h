#pragma once

#include <optional>
#include <vector>

#include "core/fabric/model/fabric.h"
#include "ui/widgets/ui.h"

namespace loomlight {

/// Of the fabric as it is, then of each of its colourways.
struct ColourwayLooks {
  std::vector<ImTextureID> pictures;             ///< null where there is none yet
  std::vector<std::vector<ImVec4>> yarnColours;  ///< for the display
};

/// The colours that a construction is offered in, side by side as they look.
class ColourwaysDialog {
 public:
  void show() { open_ = opening_ = true; }
  bool isOpen() const { return open_; }
  /// Returns the fabric after an edit.
  std::optional<Fabric> draw(Ui& ui, const Fabric& fabric, const ColourwayLooks& looks);

 private:
  void cards(Ui& ui, const Fabric& fabric, const ColourwayLooks& looks, ImVec2 size);
  void card(Ui& ui, int index, const char* name, ImTextureID picture, const std::vector<ImVec4>& colours);
  std::optional<Fabric> actions(Ui& ui, const Fabric& fabric);

  bool open_ = false, opening_ = false;
  int chosen_ = 0;  ///< 0: the cloth as it is, then the colourways
};

}  // namespace loomlight
