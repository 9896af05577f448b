#include "app/editor/controllers/document_controller.h"

#include <utility>

#include "app/editor/model/user_folders.h"
#include "core/base/error.h"
#include "core/fabric/model/validate.h"
#include "ui/words/error_words.h"

namespace loomlight {

DocumentController::DocumentController(Document document, std::function<void()> wake)
    : document_(std::move(document)), autosave_(stateFolder(), std::move(wake)) {}

void DocumentController::beginFrame(const Hold& hold) {
  const bool another = hold.item != 0 && heldItem_ != 0 && hold.item != heldItem_;
  if (!hold.holds || hold.pressedAnew || another) ++gesture_;
  if (!hold.holds || hold.item != 0) heldItem_ = hold.item;
}

/// A click in one panel takes what was typed in another: two edits in one frame, and not of one gesture.
void DocumentController::edit(Fabric fabric, const EditPlace& place) {
  if (std::exchange(editedPanel_, place.panel) != place.panel) ++gesture_;
  edit(std::move(fabric), place, gesture_);
}

void DocumentController::edit(Fabric fabric, const EditPlace& place, uint64_t gesture) {
  try {
    validate(fabric, words::errors::thisEdit);
    refusal_.clear();
    document_.edit(std::move(fabric), gesture, place);
  } catch (const InputError& error) {
    refusal_ = error.what();
  }
}

void DocumentController::startOver(Document document) {
  document_ = std::move(document);
  keptRevision_ = 0;
  autosave_.forget();
  refusal_.clear();
}

void DocumentController::savedAs(const std::string& file, uint64_t state) {
  document_.savedAs(file, state);
  if (!document_.isDirty()) autosave_.forget();
}

void DocumentController::keepCopy() {
  if (document_.revision() == keptRevision_) return;
  keptRevision_ = document_.revision();
  if (document_.isDirty())
    autosave_.keep(document_.cloth());
  else
    autosave_.forget();
}

}  // namespace loomlight
