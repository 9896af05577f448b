#pragma once

#include <functional>
#include <memory>

#include "core/fabric/weave/weave_edit.h"

namespace loomlight {

class ClothVolume;

/// What somebody who looks at a cloth wants of its volume before all of it is there.
struct PreviewSink {
  CellRect inView;  ///< the crossings that are looked at, within the piece
  /// Asked where a sketch could be shown, having so much of all bricks. Both are called from the thread that builds.
  std::function<bool(double fraction)> wanted;
  std::function<void(std::shared_ptr<const ClothVolume> sketch)> show;
};

}  // namespace loomlight
