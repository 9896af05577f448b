#include "app/editor/services/side_pictures.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "app/editor/model/yarn_close_up.h"
#include "core/fabric/model/colourways.h"
#include "ui/inspector/yarn_section.h"

namespace loomlight {
namespace {

int pixels(float atScale1, float scale) {
  return std::max(1, static_cast<int>(std::lround(atScale1 * scale)));
}

/// A picture of the cloth as the designer looks at it, but small and soon there.
Fabric smallPicture(Fabric fabric, ImVec2 size) {
  fabric.render.width = pixels(size.x, 1);
  fabric.render.height = pixels(size.y, 1);
  fabric.render.samplesPerPixel = 24;
  fabric.render.resolution = std::min(fabric.render.resolution, 4);
  fabric.render.method = Method::volume;
  fabric.render.estimator = Estimator::loomlight;
  return fabric;
}

}  // namespace

ImTextureID SidePictures::closeUp(const std::shared_ptr<const Fabric>& fabric, int yarn, float scale) {
  if (fabric != closeUpOf_ || yarn != closeUpYarn_) {
    closeUpOf_ = fabric;
    closeUpYarn_ = yarn;
    Fabric alone = yarnCloseUp(*fabric, yarn, pixels(kCloseUpWidth, scale), pixels(kCloseUpHeight, scale));
    // Most edits of a cloth leave its yarns as they are.
    if (!closeUp_ || !(alone == *closeUp_)) closeUp_ = std::make_shared<const Fabric>(std::move(alone));
  }
  return thumbnails_.of("yarn", closeUp_);
}

std::vector<ImTextureID> SidePictures::colourways(const std::shared_ptr<const Fabric>& fabric, ImVec2 size) {
  if (fabric != colourwaysOf_ || size.x != colourwaySize_.x || size.y != colourwaySize_.y) {
    colourwaysOf_ = fabric;
    colourwaySize_ = size;
    colourways_ = {std::make_shared<const Fabric>(smallPicture(*fabric, size))};
    for (const Colourway& colourway : fabric->colourways)
      colourways_.push_back(std::make_shared<const Fabric>(smallPicture(inColourway(*fabric, colourway), size)));
  }
  std::vector<ImTextureID> pictures;
  for (size_t i = 0; i < colourways_.size(); ++i)
    pictures.push_back(thumbnails_.of(fmt::format("colourway {}", i), colourways_[i]));
  return pictures;
}

}  // namespace loomlight
