#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/editor/controllers/rival_render.h"
#include "app/editor/services/snapshot_store.h"
#include "app/editor/services/view_service.h"
#include "ui/dialogs/dialogs.h"

namespace loomlight {

/// Pictures that are rendered to a file, and views that are kept: their dialogs and the strip of kept views.
class SnapshotController {
 public:
  SnapshotController(std::filesystem::path folder, DisplayDriver& driver, std::function<void()> wake)
      : shelf_(std::move(folder), driver, std::move(wake)) {}

  /// What is looked at now.
  struct Sight {
    std::shared_ptr<const Fabric> fabric, cloth;  ///< under the lamp that it is judged by; under its own
    ClothView view;
    Tone tone;
    bool isOf(const Sight& other) const { return fabric == other.fabric && view == other.view; }
  };
  /// What the dialog asks for in a frame.
  struct Edit {
    std::optional<RenderSettings> settings;
    bool chooseFile = false;
  };
  Edit drawDialog(Ui& ui, const Sight& now, ViewService& seen);
  /// Two kept views against each other.
  void drawComparison(Ui& ui) { compare_.draw(ui, shelf_.comparison()); }
  /// The view that is wanted back.
  struct Restored {
    Fabric fabric;
    ClothView view;
  };
  std::optional<Restored> drawStrip(Ui& ui, const Sight& now, const ViewService& seen);
  bool dialogIsOpen() const { return dialog_.isOpen(); }
  bool comparisonIsOpen() const { return compare_.isOpen(); }
  bool stripIsShown() const { return !shelf_.empty(); }

  /// Asks for a picture of these settings.
  void show(const RenderSettings& settings, std::string file);
  const std::string& file() const { return dialog_.file(); }
  void setFile(const std::string& file);
  const SnapshotOptions& options() const { return dialog_.options(); }
  void setOptions(SnapshotOptions options) { dialog_.setOptions(std::move(options)); }

  /// Keeps the view: once there is a picture of the cloth itself, and as long as it is seen, better and better.
  void keepView(const Sight& now, const ViewService& seen);
  /// When the picture is another one.
  void followView(const Sight& now, const ViewService& seen);
  /// At the end of a frame, whether the dialog is drawn or another stands in for it.
  void follow(Ui& ui, const Sight& now, ViewService& seen);
  /// Why a kept view will not last; empty while all do.
  std::string problem() const { return shelf_.problem(); }

 private:
  /// Of which a picture joins the strip as soon as there is one, and is renewed while it gets better.
  struct ViewToKeep {
    Sight sight;      ///< as it was seen; its fabric is usually null
    std::string id;   ///< on the shelf; empty until it is there
    int samples = 0;  ///< of the picture there
  };

  SnapshotStore shelf_;
  RivalRender rendering_{ViewService::Rival::snapshot};
  SnapshotDialog dialog_;
  CompareDialog compare_;
  SnapshotStripView strip_;
  ViewToKeep viewToKeep_;
};

}  // namespace loomlight
