#pragma once

#include <optional>
#include <utility>
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
  /// Of a picture as it is shown, in pixels: as large as there is room for all of them.
  ImVec2 pictureSize() const { return pictureSize_; }
  /// Whether they are to be printed, once; the dialog is closed then.
  bool takePrint() { return std::exchange(printWanted_, false); }
  /// Returns the fabric after an edit.
  std::optional<Fabric> draw(Ui& ui, const Fabric& fabric, const ColourwayLooks& looks);

 private:
  void cards(Ui& ui, const Fabric& fabric, const ColourwayLooks& looks, ImVec2 size);
  void fitPictures(const Ui& ui, ImVec2 room, int count);
  void card(Ui& ui, int index, const char* name, ImTextureID picture, const std::vector<ImVec4>& colours);
  std::optional<Fabric> actions(Ui& ui, const Fabric& fabric);

  bool open_ = false, opening_ = false;
  bool printWanted_ = false;
  ImVec2 pictureSize_{232, 168};
  int perLine_ = 1;
  int chosen_ = 0;  ///< 0: the cloth as it is, then the colourways
};

}  // namespace loomlight
