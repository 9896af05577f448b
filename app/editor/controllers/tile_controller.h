#pragma once

#include <functional>
#include <memory>
#include <string>

#include "app/editor/services/render_service.h"
#include "app/editor/services/view_service.h"
#include "app/live/worker.h"
#include "ui/dialogs/tile_dialog.h"

namespace loomlight {

/// The dialog of a seamless tile for other programs, and the rendering of it.
class TileController {
 public:
  explicit TileController(std::function<void()> wake);

  /// Whether a file is to be chosen.
  bool draw(Ui& ui, const Fabric& fabric, ViewService& seen);
  bool isOpen() const { return dialog_.isOpen(); }
  void show(std::string file, const std::shared_ptr<const Fabric>& fabric);
  const std::string& file() const { return dialog_.file(); }
  void setFile(const std::string& file);

 private:
  RenderService rendering_;
  TileDialog dialog_;
  Worker<std::shared_ptr<const Fabric>, TileModel>
      sizes_;  ///< a large repeat takes longer than a frame to look through
};

}  // namespace loomlight
