#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/display/display_driver.h"
#include "app/editor/model/document.h"
#include "app/editor/services/picture_service.h"
#include "app/editor/services/yarn_colour_service.h"
#include "core/fabric/weave/structure_edit.h"
#include "ui/dialogs/picture_dialog.h"
#include "ui/dialogs/structure_dialog.h"
#include "ui/dialogs/wif_dialog.h"
#include "ui/draft/draft_commands.h"
#include "ui/draft/draft_panel.h"

namespace loomlight {

/// The panel of the draft, and the dialogs that put another weave in its place: the library of structures, a picture
/// that is woven, a weaving file's sizes.
class DraftController {
 public:
  /// `wake` is called from the thread that reads pictures.
  DraftController(DisplayDriver& driver, std::function<void()> wake)
      : pictures_(std::move(wake)), woven_(driver.makeTexture()) {}

  /// The fabric after an edit. `yarnColours`: for the display; `brushYarn`: what a click on a bar of colours paints;
  /// `lit`: the crossing under the mouse in the picture; `floats`: the long ones, null while they are counted.
  std::optional<Fabric> draw(Ui& ui, const Fabric& fabric, const std::vector<ImVec4>& yarnColours, int brushYarn,
                             const LongFloats* floats, DraftPreferences& preferences,
                             const std::optional<CrossingIndex>& lit);
  /// What the dialogs ask for in a frame.
  struct Edit {
    std::optional<Fabric> fabric;
    std::string problem;  ///< why a picture cannot be used; else empty
  };
  Edit drawDialogs(Ui& ui, const std::shared_ptr<const Fabric>& fabric, const YarnColourService& colours,
                   const DraftPreferences& preferences);
  bool dialogIsOpen() const { return structures_.isOpen() || picture_.isOpen() || wif_.isOpen(); }

  void showStructures() { structures_.show(); }
  /// Reads the picture and asks how it is to be woven.
  void openPicture(const std::string& file);
  /// Asks whose sizes the cloth of a WIF draft is to have, which has those of the file. `mine`: with the designer's
  /// own.
  void askForSizes(std::shared_ptr<const Fabric> mine, std::vector<WifWarning> warnings, WifNamed named);
  /// An edit that is none of a dialog: a command's.
  std::optional<Fabric> run(DraftCommand command, const Fabric& fabric, const DraftPreferences& preferences) {
    return runDraftCommand(command, fabric, preferences, view_);
  }

  /// Where an edit is made now.
  EditPlace place() const { return {EditPlace::Panel::draft, view_.cell, view_.origin.x, view_.origin.y, 0, 0}; }
  void goTo(const EditPlace& place);
  void fit() { view_.cell = 0; }  ///< at the next frame
  void startOver();
  DraftView& view() { return view_; }
  const DraftView& view() const { return view_; }

 private:
  Edit drawPicture(Ui& ui, const std::shared_ptr<const Fabric>& fabric, const YarnColourService& colours,
                   const LoomLimits& limits);
  std::optional<Fabric> drawStructures(Ui& ui, const Fabric& fabric, const YarnColourService& colours,
                                       const LoomLimits& limits);
  std::optional<Fabric> drawSizes(Ui& ui);
  Fabric taken(Rewoven result);

  DraftView view_;
  StructureDialog structures_;
  PictureDialog picture_;
  PictureService pictures_;
  std::unique_ptr<PictureTexture> woven_;  ///< of the picture as it would be woven
  bool wovenIsNew_ = false;                ///< it is of the picture that the dialog is open for
  WifDialog wif_;
  std::shared_ptr<const Fabric> wifKept_;  ///< the weaving file's cloth with the designer's own sizes
  WifNamed wifNamed_;
};

}  // namespace loomlight
