#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/fabric/weave/picture_weave.h"
#include "core/fabric/weave/structures.h"
#include "core/fabric/weave/weave_edit.h"
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
  std::optional<CellRect> into;   ///< the crossings of the cloth that it fills; where not given, it is the whole weave
};

/// Makes a jacquard of a picture: its size in ends and picks, how many colours, and what is woven in the place of each;
/// or fills a selection with it. Shows the cloth that comes of it. Stays open while others read the picture, and while
/// they weave it.
class PictureDialog {
 public:
  /// Opens it for a picture that is being read.
  void await(std::string name);
  /// `aspect`: ends per cm over picks per cm, for a picture that keeps its proportions in the cloth; `selection`: what
  /// is selected in the draft, which the picture fills unless the designer wants otherwise.
  void show(std::shared_ptr<const PictureSource> source, double aspect, const std::optional<CellRect>& selection);
  void close() { closing_ = true; }
  bool isOpen() const { return open_; }
  /// The order, once. `woven`: a picture of the cloth as it would be; null while there is none.
  std::optional<PictureOrder> draw(Ui& ui, ImTextureID woven);
  /// What the cloth would be woven of now, once after each change.
  std::optional<PictureOrder> takeChanged();
  static constexpr float kPreviewSide = 340;  ///< at scale 1

 private:
  PictureOrder order() const;
  int proportionalPicks() const;
  void reducePalette();
  void merge(size_t colour, size_t into);
  void colourRow(Ui& ui, size_t colour, const std::vector<const char*>& names);
  void drawColours(float size) const;
  void drawPreview(Ui& ui, ImTextureID woven, float size);
  void targetRows(Ui& ui);
  void drawFields(Ui& ui);

  bool open_ = false, opening_ = false, closing_ = false;
  bool weaving_ = false, changed_ = false;
  bool showsColours_ = false;  ///< in the place of the cloth
  std::string name_;
  double aspect_ = 1;
  std::shared_ptr<const PictureSource> source_;  ///< null while it is being read
  int ends_ = 1, picks_ = 1, colours_ = 4;
  std::optional<CellRect> selection_;
  bool fillsSelection_ = false;
  ReducedPicture preview_;             ///< a small one, with the palette
  std::vector<Structure> structures_;  ///< that may be chosen
  std::vector<int> assigned_;          ///< index into them, for each colour
  std::vector<size_t> mergedInto_;     ///< for each colour the one that it goes with: itself, or another
};

}  // namespace loomlight
