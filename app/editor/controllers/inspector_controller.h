#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "app/editor/model/document.h"
#include "app/editor/services/cloth_colour_service.h"
#include "app/editor/services/colour_book_service.h"
#include "app/editor/services/colour_difference_service.h"
#include "app/editor/services/side_pictures.h"
#include "app/editor/services/view_service.h"
#include "app/editor/services/yarn_colour_service.h"
#include "core/fabric/palette/palette.h"
#include "core/fabric/swatch/measured_swatch.h"
#include "ui/dialogs/colour_difference_dialog.h"
#include "ui/dialogs/colourways_dialog.h"
#include "ui/inspector/inspector.h"

namespace loomlight {

/// The panel of yarns, fibres, cloth and scene, and the dialogs of the cloth's colourways and colours, with the workers
/// that find dyes and render small pictures beside them.
class InspectorController {
 public:
  InspectorController(DisplayDriver& driver, const std::function<void()>& wake)
      : colours_(wake), differences_(wake), books_(wake), pictures_(driver, wake) {}

  /// What the panel asks for in a frame. `ownLamp`: of a cloth that is judged by another. `inches`: of setts and
  /// lengths.
  InspectorResult draw(Ui& ui, const std::shared_ptr<const Fabric>& fabric, const YarnColourService& yarnColours,
                       const ViewService& seen, const std::optional<StandardIlluminant>& ownLamp, bool inches);
  /// The fabric after an edit.
  std::optional<Fabric> drawColourways(Ui& ui, const std::shared_ptr<const Fabric>& fabric,
                                       const YarnColourService& yarnColours);
  void showColourways() { colourways_.show(); }
  bool colourwaysAreOpen() const { return colourways_.isOpen(); }
  bool takeColourwaysPrint() { return colourways_.takePrint(); }
  void drawColourDifference(Ui& ui, const std::shared_ptr<const Fabric>& fabric, const YarnColourService& yarnColours);
  void showColourDifference() { colourDifference_.show(); }
  bool colourDifferenceIsOpen() const { return colourDifference_.isOpen(); }

  /// A colour that was asked for arrives later than the gesture that asked for it, and is still one step of undo with
  /// it.
  struct Dyed {
    Fabric fabric;
    uint64_t gesture = 0;
  };
  /// At the end of a frame: asks the workers for what was drawn.
  std::optional<Dyed> follow(const std::shared_ptr<const Fabric>& fabric, uint64_t gesture, bool isShown);
  /// The same for the small pictures, of which none is begun while they are `held`.
  void followPictures(bool held) { pictures_.follow(held); }

  /// Opens the page of fibres and wants of the yarn, or without one of what is looked at, that the cloth reflects as
  /// was measured. The yarn is looked at from then on, and dyed alone.
  void dyeLike(const Fabric& fabric, const MeasuredSwatch& swatch, const std::optional<int>& yarn);
  /// The same page, with these colours to choose from, which are those of that file.
  void open(const Palette& palette, const std::string& file);

  // The yarn that bars of colour are painted with is the one that is looked at.
  void stepYarn(int step, size_t yarns);
  /// The one that was looked at before, as a painter swaps two colours.
  void swapYarns(size_t yarns);

  /// Where an edit is made now.
  EditPlace place() const { return {EditPlace::Panel::inspector, 0, 0, 0, static_cast<int>(view_.page), view_.yarn}; }
  void goTo(const EditPlace& place);
  void startOver();
  InspectorView& view() { return view_; }
  const InspectorView& view() const { return view_; }

 private:
  /// What a colour of the cloth is wanted of.
  ClothPart dyed(const Fabric& fabric) const;
  /// A colour that was typed is wanted, or is refused on the page.
  void wantCode(const ClothPart& part, const std::string& code);
  void followBooks();
  void show(ColourBook book, const std::string& file);

  InspectorView view_;
  ClothColourService colours_;
  ColourDifferenceService differences_;
  ColourBookService books_;
  SidePictures pictures_;
  ColourwaysDialog colourways_;
  ColourDifferenceDialog colourDifference_;
  int lookedAt_ = 0, before_ = 1;                ///< yarns
  uint64_t colourWish_ = 0, colourGesture_ = 0;  ///< the newest wish for a colour, and the gesture that made it
};

}  // namespace loomlight
