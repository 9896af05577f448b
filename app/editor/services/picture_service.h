#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "app/live/worker.h"
#include "core/fabric/model/fabric.h"
#include "core/fabric/weave/picture_weave.h"
#include "core/fabric/weave/structure_edit.h"
#include "render/display/raster.h"
#include "render/film/image.h"
#include "ui/dialogs/picture_dialog.h"

namespace loomlight {

/// Reads pictures and weaves them, but not in the thread of the window: a hundred million pixels take seconds. What was
/// asked for last is what counts.
class PictureService {
 public:
  explicit PictureService(std::function<void()> wake);

  void read(const std::string& file);
  /// In the place of the fabric's weave, or of the crossings that the order is for.
  void weave(PictureOrder order, std::shared_ptr<const Fabric> fabric, const LoomLimits& limits);
  /// The cloth that would come of it in the colours of its yarns (linear), as a draft shows it: `side` pixels a side.
  /// One that has more ends or picks than the preview has room for is made with fewer.
  void preview(PictureOrder order, std::shared_ptr<const Fabric> fabric, std::vector<Rgb> yarnColours, int side);
  /// The newest of what was asked for, once.
  std::optional<Pixels8> takePreview();
  /// Whatever comes of it is no longer wanted. A picture that is being decoded is decoded to its end, and nothing else
  /// is done with it.
  void forget() {
    worker_.forget();
    previews_.forget();
  }

  /// What has come, once: one of the three.
  struct Result {
    std::shared_ptr<const PictureSource> source;
    std::optional<Rewoven> woven;
    std::string problem;
    bool fillsSelection = false;  ///< what is woven does, and the weave about it stays
  };
  std::optional<Result> take() { return worker_.take(); }

 private:
  Worker<std::function<Result(const std::stop_token&)>, Result> worker_;
  Worker<std::function<Pixels8()>, Pixels8> previews_;
};

}  // namespace loomlight
