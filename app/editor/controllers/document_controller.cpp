#include "app/editor/controllers/document_controller.h"

#include <utility>

#include "app/editor/model/user_folders.h"
#include "core/base/error.h"
#include "core/fabric/model/validate.h"

namespace loomlight {

DocumentController::DocumentController(Document document, std::function<void()> wake)
    : document_(std::move(document)), autosave_(stateFolder(), std::move(wake)) {}

void DocumentController::edit(Fabric fabric, const EditPlace& place, uint64_t gesture) {
  try {
    validate(fabric, "this edit");
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
    autosave_.keep(document_.fabric());
  else
    autosave_.forget();
}

}  // namespace loomlight
