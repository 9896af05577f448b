#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/editor/display/display_driver.h"
#include "app/live/thumbnail_worker.h"

namespace loomlight {

/// Small pictures of fabrics for panels and dialogs, in a driver's textures. What is asked for in a frame is rendered
/// until another frame asks for something else. All of it in the thread of the window.
class Thumbnails {
 public:
  Thumbnails(DisplayDriver& driver, std::function<void()> wake);

  /// The newest picture of that name, null until there is one, which soon is a sketch; it may be of the fabric before
  /// an edit for a moment.
  ImTextureID of(const std::string& name, const std::shared_ptr<const Fabric>& fabric);
  /// At the end of a frame: hands what it asked for to the worker, unless that is to wait.
  void follow(bool held = false);

 private:
  struct Shown {
    std::shared_ptr<const Thumbnail> thumbnail;
    std::unique_ptr<PictureTexture> texture;
  };
  DisplayDriver& driver_;
  ThumbnailWorker worker_;
  std::map<std::string, Shown> shown_;
  std::vector<ThumbnailOrder> wanted_, requested_;
};

}  // namespace loomlight
