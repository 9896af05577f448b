#include <fmt/core.h>

#include "app/editor/model/sample_fabric.h"
#include "app/editor/presets/preset_store.h"
#include "app/editor/session.h"

namespace loomlight {

void Session::drawPresets(Ui& ui) {
  const std::vector<PresetCard> cards = presetDesk_.cards(presetBrowser_.kind(), ui.scale);
  const std::string& problem = presetProblem_.empty() ? presetDesk_.problem() : presetProblem_;
  const PresetBrowserEdit change = presetBrowser_.draw(ui, cards, presetDesk_.lastChange(), problem);
  changePresets(change);
  if (presetBrowser_.isOpen()) return;
  presetDesk_.lookAway();
  views_.pause(false);
}

void Session::changePresets(const PresetBrowserEdit& change) {
  const PresetKind kind = presetBrowser_.kind();
  const Fabric& now = *document_.fabric();
  const int yarn = std::min(inspector_.yarn, static_cast<int>(now.yarns.size()) - 1);
  const int fibre = shownFibre(now, inspector_);
  if (change.use) {
    edit(presetDesk_.used(*change.use, now, yarn, fibre));
    if (kind == PresetKind::fabrics) draft_.cell = 0;
  }
  if (change.keep) presetDesk_.keep(kind, now, yarn, fibre);
  if (change.duplicate) presetDesk_.duplicate(*change.duplicate);
  if (change.rename) presetDesk_.rename(change.rename->first, change.rename->second);
  if (change.tag) presetDesk_.tag(change.tag->first, change.tag->second);
  if (change.remove) presetDesk_.remove(*change.remove);
  if (change.undo) presetDesk_.undo();
}

void Session::applyPreset(const PresetChoice& choice) {
  if (choice.isSample) return dress(sampleFabric(choice.index));
  const std::string file = presetDesk_.fileOf(presetDesk_.names()[choice.index]);
  files_.open(FileDesk::Work::usePreset, file, document_.fabric(), document_.state());
}

void Session::dress(const Fabric& cloth) {
  place_ = placeInDraft();
  edit(dressed(*document_.fabric(), cloth));
  draft_.cell = 0;
}

/// What came of a change: in the browser, or once no dialog is in the way.
void Session::hearOfPresets() {
  if (dialogIsOpen() && !presetBrowser_.isOpen()) return;
  const auto outcome = presetDesk_.takeOutcome();
  if (!outcome) return;
  if (presetBrowser_.isOpen())
    presetProblem_ = outcome->problem;
  else if (!outcome->problem.empty())
    say("The presets could not be changed", outcome->problem);
  else if (!outcome->kept.empty())
    say("Kept as preset", fmt::format("\"{}\" is among the presets now.", outcome->kept));
}

}  // namespace loomlight
