#include "app/editor/display/thumbnails.h"

#include <algorithm>
#include <utility>

#include "app/editor/display/cloth_sketch.h"

namespace loomlight {

Thumbnails::Thumbnails(DisplayDriver& driver, std::function<void()> wake)
    : driver_(driver), worker_(std::move(wake), clothSketch) {}

ImTextureID Thumbnails::of(const std::string& name, const std::shared_ptr<const Fabric>& fabric) {
  wanted_.push_back({name, fabric});
  std::shared_ptr<const Thumbnail> newest = worker_.of(name);
  if (!newest || newest->picture.bytes.empty()) return {};
  Shown& shown = shown_[name];
  if (shown.thumbnail != newest) {
    if (!shown.texture) shown.texture = driver_.makeTexture();
    shown.texture->upload(newest->picture);
    shown.thumbnail = std::move(newest);
  }
  return shown.texture->id();
}

void Thumbnails::follow(bool held) {
  const bool same = std::equal(
      wanted_.begin(), wanted_.end(), requested_.begin(), requested_.end(),
      [](const ThumbnailOrder& a, const ThumbnailOrder& b) { return a.name == b.name && a.fabric == b.fabric; });
  if (!same && !held) {
    requested_ = wanted_;
    worker_.request(requested_);
  }
  wanted_.clear();
}

}  // namespace loomlight
