#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "app/editor/controllers/rival_render.h"
#include "app/editor/services/tile_size_service.h"
#include "app/editor/services/view_service.h"
#include "ui/dialogs/tile_dialog.h"

namespace loomlight {

/// The dialog of a seamless tile for other programs, and the rendering of it.
class TileController {
 public:
  explicit TileController(std::function<void()> wake) : sizes_(std::move(wake)) {}

  /// Whether a file is to be chosen.
  bool draw(Ui& ui, const Fabric& fabric, ViewService& seen);
  /// At the end of a frame, whether the dialog is drawn or another stands in for it.
  void follow(Ui& ui, ViewService& seen);
  bool isOpen() const { return dialog_.isOpen(); }
  void show(std::string file, const std::shared_ptr<const Fabric>& fabric);
  const std::string& file() const { return dialog_.file(); }
  void setFile(const std::string& file);

 private:
  RivalRender rendering_{ViewService::Rival::tile};
  TileDialog dialog_;
  TileSizeService sizes_;
};

}  // namespace loomlight
