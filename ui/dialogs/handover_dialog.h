#pragma once

#include <string>
#include <utility>

#include "ui/dialogs/render_dialog.h"
#include "ui/dialogs/tile_size_rows.h"
#include "ui/widgets/ui.h"

namespace loomlight {

/// What the dialog says of the cloth.
struct HandoverModel {
  TileModel tile;
  double fewestPixels = 0;  ///< for a yarn, below which it is said that there are few
  int colourways = 0;       ///< that the cloth keeps, beside the colours it has
  std::string sidecar;      ///< the file in the folder that is replaced where it is there; empty: no folder is named
};

/// A cloth for other programs, in all of their formats: how finely, in which colours, where it goes; then its progress.
class HandoverDialog {
 public:
  struct Result {
    bool chooseFolder = false, start = false, cancel = false;
  };
  HandoverDialog();
  void show(std::string folder);
  bool isOpen() const { return dialog_.isOpen(); }
  void setFolder(std::string folder) { dialog_.setFile(std::move(folder)); }
  const std::string& folder() const { return dialog_.file(); }
  int longestSide() const { return size_.longestSide(); }
  bool joinsTwist() const { return size_.joinsTwist(); }
  int samplesPerPixel() const { return samplesPerPixel_; }
  int measuringSamples() const { return measuringSamples_; }
  bool allColourways() const { return allColourways_; }
  Result draw(Ui& ui, const HandoverModel& model, const RenderJob& job);

 private:
  void rows(Ui& ui, const HandoverModel& model);

  RenderDialog dialog_;
  TileSizeRows size_;
  int samplesPerPixel_ = 32;    ///< for each of four pictures: either side, in light from either side
  int measuringSamples_ = 512;  ///< paths for each camera that the surface is fitted to
  bool allColourways_ = false;
};

}  // namespace loomlight
