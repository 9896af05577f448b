#pragma once

#include <optional>
#include <string>

#include "ui/widgets/ui.h"

namespace loomlight {

/// How large a tile is, with the twist of all yarns coming round or without.
struct TileSize {
  int ends = 1, picks = 1;
  int repeatsAcross = 1, repeatsDown = 1;  ///< of the weave
  double width_mm = 1, height_mm = 1;
  double yarnsAlongLonger = 1;  ///< its longer side, over the pitch of the finer yarns
  int usualSide = 1024;         ///< pixels of the longer side that show its yarns well
};

/// What is known of them; nothing while it is worked out.
struct TileModel {
  std::optional<TileSize> joined, plain;
  std::string problem;  ///< why there can be no tile; else empty
};

/// How much cloth a seamless tile is, and how finely it is shown: rows of the dialogs that write one.
class TileSizeRows {
 public:
  /// The longer side is the usual one of the tile again.
  void reset() { ownSide_.reset(); }
  int longestSide() const { return longestSide_; }
  bool joinsTwist() const { return joinsTwist_; }
  /// All rows are there from the beginning: what comes to be known moves nothing. Widgets are named after the dialog.
  /// `fewestPixels`: for a yarn, below which it is said that there are few.
  void draw(Ui& ui, const std::string& dialog, const TileModel& model, double fewestPixels);

 private:
  std::optional<bool> ownTwist_;  ///< that was chosen; else joined where that takes a few repeats
  bool joinsTwist_ = true;
  std::optional<int> ownSide_;  ///< that was set; else the usual one of the tile
  int longestSide_ = 1024;
};

}  // namespace loomlight
