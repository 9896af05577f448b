#include "app/editor/controllers/preset_controller.h"

#include <fmt/core.h>

#include "ui/words/message_words.h"

namespace loomlight {

void PresetController::showBrowser() {
  problem_.clear();
  browser_.show();
}

std::optional<PresetController::Used> PresetController::drawBrowser(Ui& ui, const Fabric& now, int yarn, int fibre) {
  const PresetKind kind = browser_.kind();
  const PresetBrowserEdit change = browser_.draw(ui, service_.cards(kind, ui.scale), service_.lastChange(),
                                                 problem_.empty() ? service_.problem() : problem_);
  std::optional<Used> used;
  if (change.use) used = {service_.used(*change.use, now, yarn, fibre), kind == PresetKind::fabrics};
  if (change.keep) service_.keep(kind, now, yarn, fibre);
  if (change.duplicate) service_.duplicate(*change.duplicate);
  if (change.rename) service_.rename(change.rename->first, change.rename->second);
  if (change.tag) service_.tag(change.tag->first, change.tag->second);
  if (change.remove) service_.remove(*change.remove);
  if (change.undo) service_.undo();
  if (!browser_.isOpen()) service_.lookAway();
  return used;
}

std::optional<PresetController::Message> PresetController::follow(bool mayTell) {
  service_.follow();
  service_.take();
  if (!mayTell && !browser_.isOpen()) return std::nullopt;
  const auto outcome = service_.takeOutcome();
  if (!outcome) return std::nullopt;
  if (browser_.isOpen()) {
    problem_ = outcome->problem;
    if (!outcome->renamed.empty()) browser_.renamed(outcome->renamed);
    return std::nullopt;
  }
  if (!outcome->problem.empty()) return Message{words::messages::presetsUnchanged, outcome->problem};
  if (outcome->kept.empty()) return std::nullopt;
  return Message{words::messages::presetKeptTitle, fmt::format(words::messages::presetKept, outcome->kept)};
}

}  // namespace loomlight
