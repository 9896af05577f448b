#pragma once

#include <memory>
#include <vector>

#include "app/editor/display/thumbnails.h"

namespace loomlight {

/// The small pictures beside the cloth's: a close-up of the yarn looked at, and every colourway. They follow the
/// fabric for as long as they are asked for, frame by frame.
class SidePictures {
 public:
  SidePictures(DisplayDriver& driver, std::function<void()> wake) : thumbnails_(driver, std::move(wake)) {}

  /// Of a size for `scale` of the screen. Null until there is one.
  ImTextureID closeUp(const std::shared_ptr<const Fabric>& fabric, int yarn, float scale);
  /// Of the fabric as it is, then of each of its colourways; of that size in pixels.
  std::vector<ImTextureID> colourways(const std::shared_ptr<const Fabric>& fabric, ImVec2 size);
  /// At the end of a frame. None are begun while they are `held`.
  void follow(bool held) { thumbnails_.follow(held); }

 private:
  Thumbnails thumbnails_;
  std::shared_ptr<const Fabric> closeUpOf_, closeUp_;
  int closeUpYarn_ = -1;
  std::shared_ptr<const Fabric> colourwaysOf_;
  ImVec2 colourwaySize_;
  std::vector<std::shared_ptr<const Fabric>> colourways_;
};

}  // namespace loomlight
