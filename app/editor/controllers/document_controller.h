#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/editor/model/autosave.h"
#include "app/editor/model/document.h"

namespace loomlight {

/// The document that all panels edit: takes their edits as steps of undo, one a gesture, and keeps unsaved work safe.
class DocumentController {
 public:
  /// `wake` is called when autosave().problem() changes.
  DocumentController(Document document, std::function<void()> wake);

  const Document& document() const { return document_; }
  const std::shared_ptr<const Fabric>& fabric() const { return document_.fabric(); }  ///< as it is looked at
  const std::shared_ptr<const Fabric>& cloth() const { return document_.cloth(); }    ///< as it is kept in files
  const Autosave& autosave() const { return autosave_; }
  const std::string& refusal() const { return refusal_; }  ///< why the last edit was not taken; empty if it was

  /// What the designer holds at the beginning of a frame: a button, or a field that is dragged or typed into.
  struct Hold {
    bool holds = false;
    bool pressedAnew = false;
    uint32_t item = 0;  ///< the number of the field; 0: none
  };
  /// A gesture lasts while one thing is held; what is edited meanwhile is one step of undo. From one field to another
  /// it is another gesture, even if nothing was let go between.
  void beginFrame(const Hold& hold);
  uint64_t gesture() const { return gesture_; }
  /// `place`: where undo goes back to. A fabric that is not valid is refused.
  void edit(Fabric fabric, const EditPlace& place = {});
  /// Belongs to a gesture that may be over.
  void edit(Fabric fabric, const EditPlace& place, uint64_t gesture);
  /// A change of the fabric, as `edit`.
  template <class Change>
  void change(Change&& how) {
    Fabric fabric = *document_.fabric();
    how(fabric);
    edit(std::move(fabric));
  }
  void lookFrom(const Camera& camera) { document_.lookFrom(camera); }
  void judgeUnder(std::optional<StandardIlluminant> lamp) { document_.judgeUnder(lamp); }
  void renderAs(const RenderSettings& settings) { document_.renderAs(settings); }
  EditPlace undo() { return document_.undo(); }
  EditPlace redo() { return document_.redo(); }

  void startOver(Document document);
  void savedAs(const std::string& file, uint64_t state);
  /// Unsaved work that another editor left: it goes once it is kept again, or at once.
  void takeOver(const std::string& left) { autosave_.takeOver(left); }
  void throwAway(const std::string& left) { autosave_.throwAway(left); }
  /// At the end of a frame: unsaved work outlives the program.
  void keepCopy();
  void endWell() { autosave_.endWell(); }

 private:
  Document document_;
  Autosave autosave_;
  std::string refusal_;
  uint64_t gesture_ = 1;
  uint32_t heldItem_ = 0;
  EditPlace::Panel editedPanel_ = EditPlace::Panel::none;
  uint64_t keptRevision_ = 0;  ///< last handed to autosave
};

}  // namespace loomlight
