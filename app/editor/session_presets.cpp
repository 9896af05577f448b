#include "app/editor/session.h"
#include "core/base/error.h"

namespace loomlight {

void Session::drawPresets(Ui& ui) {
  const std::vector<PresetCard>& cards = presetDesk_.cards(presetBrowser_.kind(), ui.scale);
  const PresetBrowserEdit change = presetBrowser_.draw(ui, cards, presetDesk_.lastChange(), presetProblem_);
  const bool any =
      change.use || change.keep || change.duplicate || change.rename || change.remove || change.tag || change.undo;
  if (any) changePresets(change);
  if (!presetBrowser_.isOpen()) views_.pause(false);
}

void Session::changePresets(const PresetBrowserEdit& change) {
  const PresetKind kind = presetBrowser_.kind();
  const Fabric& now = *document_.fabric();
  const int yarn = std::min(inspector_.yarn, static_cast<int>(now.yarns.size()) - 1);
  const int fibre = shownFibre(now, inspector_);
  try {
    if (change.use) edit(presetDesk_.used(kind, *change.use, now, yarn, fibre));
    if (change.keep) presetDesk_.keep(kind, now, yarn, fibre);
    if (change.duplicate) presetDesk_.duplicate(kind, *change.duplicate);
    if (change.rename) presetDesk_.rename(kind, change.rename->first, change.rename->second);
    if (change.remove) presetDesk_.remove(kind, *change.remove);
    if (change.tag) presetDesk_.tag(kind, change.tag->first, change.tag->second);
    if (change.undo) presetDesk_.undo();
    presetProblem_.clear();
  } catch (const InputError& error) {
    presetProblem_ = error.what();
  }
  presets_.refresh();
  if (change.use && kind == PresetKind::fabrics) draft_.cell = 0;
}

}  // namespace loomlight
