#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/fabric/weave/picture_weave.h"
#include "core/fabric/weave/structures.h"
#include "ui/widgets/ui.h"

namespace loomlight {

/// A picture, and what is known of it beforehand, because every pixel must be looked at for it.
struct PictureSource {
  static constexpr int kSmallSide = 200;
  std::string name;
  Raster raster;
  ColourCounts colours;
  Raster small;  ///< the same with at most kSmallSide pixels a side
};

/// What is to be woven of it.
struct PictureOrder {
  std::shared_ptr<const PictureSource> source;
  int ends = 1, picks = 1;
  std::vector<Rgb8> palette;
  std::vector<Weave> structures;  ///< for each of its colours
};

/// Makes a jacquard of a picture: its size in threads, how many colours, and what is woven in the place of each. Stays
/// open while others read the picture, and while they weave it.
class PictureDialog {
 public:
  /// Opens it for a picture that is being read.
  void await(std::string name);
  /// `aspect`: ends per cm over picks per cm, for a picture that keeps its proportions in the cloth.
  void show(std::shared_ptr<const PictureSource> source, double aspect);
  void close() { closing_ = true; }
  bool isOpen() const { return open_; }
  /// The order, once.
  std::optional<PictureOrder> draw(Ui& ui);

 private:
  PictureOrder order() const;
  int proportionalPicks() const;
  void reducePalette();
  void merge(size_t colour, size_t into);
  void colourRow(Ui& ui, size_t colour, const std::vector<const char*>& names);
  void drawPreview(float size) const;
  void drawFields(Ui& ui);

  bool open_ = false, opening_ = false, closing_ = false;
  bool weaving_ = false;
  std::string name_;
  double aspect_ = 1;
  std::shared_ptr<const PictureSource> source_;  ///< null while it is being read
  int ends_ = 1, picks_ = 1, colours_ = 4;
  ReducedPicture preview_;             ///< a small one, with the palette
  std::vector<Structure> structures_;  ///< that may be chosen
  std::vector<int> assigned_;          ///< index into them, for each colour
  std::vector<size_t> mergedInto_;     ///< for each colour the one that it goes with: itself, or another
};

}  // namespace loomlight
