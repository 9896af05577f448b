#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/fabric/picture_weave.h"
#include "core/fabric/structures.h"
#include "ui/ui.h"

namespace loomlight {

/// Makes a jacquard of a picture: its size in threads, how many colours, and what is woven in the place of each.
class PictureDialog {
 public:
  /// `aspect`: ends per cm over picks per cm, for a picture that keeps its proportions in the cloth.
  void show(Raster raster, std::string name, double aspect);
  bool isOpen() const { return open_; }
  /// The weave, once.
  std::optional<Weave> draw(Ui& ui);

 private:
  void reducePalette();
  void drawPreview(float size) const;
  void drawFields(Ui& ui);

  bool open_ = false, opening_ = false;
  std::string name_;
  double aspect_ = 1;
  Raster raster_;
  int ends_ = 1, picks_ = 1, colours_ = 4;
  ReducedPicture preview_;             ///< a small one, with the palette
  std::vector<Structure> structures_;  ///< that may be chosen
  std::vector<int> assigned_;          ///< index into them, for each colour
};

}  // namespace loomlight
