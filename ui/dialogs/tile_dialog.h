#pragma once

#include <optional>
#include <string>

#include "ui/dialogs/render_job.h"
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

/// A seamless tile for other programs: its size, where it goes, then its progress.
class TileDialog {
 public:
  struct Result {
    bool chooseFile = false, start = false, cancel = false;
  };
  void show(std::string file);
  bool isOpen() const { return open_; }
  void setFile(std::string file) { file_ = std::move(file); }
  /// The sidecar's name, which the maps are named after.
  const std::string& file() const { return file_; }
  int longestSide() const { return longestSide_; }
  bool joinsTwist() const { return joinsTwist_; }
  int samplesPerPixel() const { return samplesPerPixel_; }
  /// `fewestPixels`: for a yarn, below which it is said that there are few.
  Result draw(Ui& ui, const TileModel& model, double fewestPixels, const RenderJob& job);

 private:
  void sizeRows(Ui& ui, const TileModel& model, double fewestPixels);

  bool open_ = false, opening_ = false;
  std::string file_;
  bool joinsTwist_ = true;
  std::optional<int> ownSide_;  ///< that was set; else the usual one of the tile
  int longestSide_ = 1024, samplesPerPixel_ = 128;
};

}  // namespace loomlight
