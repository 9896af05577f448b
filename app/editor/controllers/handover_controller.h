#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "app/editor/controllers/rival_render.h"
#include "app/editor/services/tile_size_service.h"
#include "app/editor/services/view_service.h"
#include "ui/dialogs/handover_dialog.h"

namespace loomlight {

/// The dialog of a cloth for other programs, and the making of it.
class HandoverController {
 public:
  explicit HandoverController(std::function<void()> wake) : sizes_(std::move(wake)) {}

  /// Whether a folder is to be chosen.
  bool draw(Ui& ui, const Fabric& fabric, ViewService& seen);
  /// At the end of a frame, whether the dialog is drawn or another stands in for it.
  void follow(Ui& ui, ViewService& seen);
  bool isOpen() const { return dialog_.isOpen(); }
  void show(std::string folder, const std::shared_ptr<const Fabric>& fabric);
  const std::string& folder() const { return dialog_.folder(); }
  void setFolder(const std::string& folder);

 private:
  RenderService::Work workOn(const Fabric& fabric) const;

  RivalRender rendering_{ViewService::Rival::handover};
  HandoverDialog dialog_;
  TileSizeService sizes_;
};

}  // namespace loomlight
