#include "app/editor/controllers/preset_controller.h"

#include <fmt/core.h>

namespace loomlight {

void PresetController::showBrowser() {
  problem_.clear();
  browser_.show();
}

std::optional<PresetController::Used> PresetController::drawBrowser(Ui& ui, const Fabric& now, int yarn, int fibre) {
  const PresetKind kind = browser_.kind();
  const PresetBrowserEdit change =
      browser_.draw(ui, desk_.cards(kind, ui.scale), desk_.lastChange(), problem_.empty() ? desk_.problem() : problem_);
  std::optional<Used> used;
  if (change.use) used = {desk_.used(*change.use, now, yarn, fibre), kind == PresetKind::fabrics};
  if (change.keep) desk_.keep(kind, now, yarn, fibre);
  if (change.duplicate) desk_.duplicate(*change.duplicate);
  if (change.rename) desk_.rename(change.rename->first, change.rename->second);
  if (change.tag) desk_.tag(change.tag->first, change.tag->second);
  if (change.remove) desk_.remove(*change.remove);
  if (change.undo) desk_.undo();
  if (!browser_.isOpen()) desk_.lookAway();
  return used;
}

std::optional<PresetController::Message> PresetController::follow(bool mayTell) {
  desk_.follow();
  desk_.take();
  if (!mayTell && !browser_.isOpen()) return std::nullopt;
  const auto outcome = desk_.takeOutcome();
  if (!outcome) return std::nullopt;
  if (browser_.isOpen()) {
    problem_ = outcome->problem;
    return std::nullopt;
  }
  if (!outcome->problem.empty()) return Message{"The presets could not be changed", outcome->problem};
  if (outcome->kept.empty()) return std::nullopt;
  return Message{"Kept as preset", fmt::format("\"{}\" is among the presets now.", outcome->kept)};
}

}  // namespace loomlight
