#pragma once

#include <functional>
#include <memory>
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
  const std::shared_ptr<const Fabric>& fabric() const { return document_.fabric(); }
  const Autosave& autosave() const { return autosave_; }
  const std::string& refusal() const { return refusal_; }  ///< why the last edit was not taken; empty if it was

  /// A gesture lasts while a button is down or a text is open; what is edited meanwhile is one step of undo.
  void beginFrame(bool gestureLasts) { gesture_ += gestureLasts ? 0 : 1; }
  uint64_t gesture() const { return gesture_; }
  /// `place`: where undo goes back to. A fabric that is not valid is refused.
  void edit(Fabric fabric, const EditPlace& place = {}) { edit(std::move(fabric), place, gesture_); }
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
  uint64_t keptRevision_ = 0;  ///< last handed to autosave
};

}  // namespace loomlight
