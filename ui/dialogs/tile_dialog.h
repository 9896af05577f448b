#pragma once

#include <string>
#include <utility>

#include "ui/dialogs/render_dialog.h"
#include "ui/dialogs/tile_size_rows.h"
#include "ui/widgets/ui.h"

namespace loomlight {

/// A seamless tile for other programs: its size, where it goes, then its progress.
class TileDialog {
 public:
  using Result = RenderDialog::Answer;
  TileDialog();
  void show(std::string file);
  bool isOpen() const { return dialog_.isOpen(); }
  void setFile(std::string file) { dialog_.setFile(std::move(file)); }
  /// The sidecar's name, which the maps are named after.
  const std::string& file() const { return dialog_.file(); }
  int longestSide() const { return size_.longestSide(); }
  bool joinsTwist() const { return size_.joinsTwist(); }
  int samplesPerPixel() const { return samplesPerPixel_; }
  /// `fewestPixels`: for a yarn, below which it is said that there are few.
  Result draw(Ui& ui, const TileModel& model, double fewestPixels, const RenderJob& job);

 private:
  RenderDialog dialog_;
  TileSizeRows size_;
  int samplesPerPixel_ = 128;
};

}  // namespace loomlight
