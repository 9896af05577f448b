#include "app/editor/controllers/preset_desk.h"

#include <fmt/core.h>

#include <exception>
#include <new>
#include <utility>

namespace loomlight {

PresetDesk::PresetDesk(std::filesystem::path folder, DisplayDriver& driver, std::function<void()> wake)
    : folder_(std::move(folder)), wake_(std::move(wake)), thumbnails_(driver, wake_) {
  disk_.post([this] {
    cabinet_ = std::make_unique<PresetCabinet>(folder_);
    const std::lock_guard lock(brought_.mutex);
    brought_.state = stateNow();
    wake_();
  });
}

PresetDesk::State PresetDesk::stateNow() const {
  return {cabinet_->names(), cabinet_->lastChange(), cabinet_->problem()};
}

bool PresetDesk::hasBroughtPresets() {
  const std::lock_guard lock(brought_.mutex);
  return brought_.presets.has_value();
}

void PresetDesk::bring(PresetKind kind, uint64_t number) {
  Presets presets = cabinet_->presets(kind);
  State state = stateNow();
  const std::lock_guard lock(brought_.mutex);
  brought_.presets = std::move(presets);
  brought_.state = std::move(state);
  brought_.number = number;
  wake_();
}

/// One file a task: changes go between them.
void PresetDesk::readOn(PresetKind kind, uint64_t number) {
  if (number != wanted_) return;
  if (!cabinet_->readNext(kind)) return bring(kind, number);
  if (!hasBroughtPresets()) bring(kind, number);
  disk_.post([this, kind, number] { readOn(kind, number); });
}

void PresetDesk::look() {
  looked_ = ++wanted_;
  disk_.post([this, kind = kind_, scale = scale_, number = looked_] {
    if (number != wanted_) return;
    cabinet_->look(kind, scale);
    bring(kind, number);
    readOn(kind, number);
  });
}

void PresetDesk::change(std::function<std::string(PresetCabinet&)> edit) {
  disk_.post([this, edit = std::move(edit)] {
    Outcome outcome;
    try {
      outcome.kept = edit(*cabinet_);
    } catch (const std::bad_alloc&) {
      outcome.problem = "It needs more memory than there is.";
    } catch (const std::exception& error) {
      outcome.problem = error.what();
    }
    const std::lock_guard lock(brought_.mutex);
    brought_.state = stateNow();
    brought_.outcomes.push_back(std::move(outcome));
    wake_();
  });
  if (looked_ == wanted_) look();
}

std::vector<PresetCard> PresetDesk::cards(PresetKind kind, float scale) {
  if (kind != kind_) presets_.clear();
  if (kind != kind_ || scale != scale_ || looked_ != wanted_) {
    kind_ = kind;
    scale_ = scale;
    look();
  }
  std::vector<PresetCard> cards;
  for (const Preset& preset : presets_) {
    const std::string picture =
        fmt::format("{} {} {}", static_cast<int>(kind), preset.own ? "own" : "given", preset.name);
    cards.push_back({preset.name, preset.about, preset.tags, preset.own, thumbnails_.of(picture, preset.portrait)});
  }
  return cards;
}

void PresetDesk::take() {
  Presets old;  // dies outside the lock
  const std::lock_guard lock(brought_.mutex);
  if (brought_.state) state_ = *std::exchange(brought_.state, std::nullopt);
  if (!brought_.presets) return;
  old = *std::exchange(brought_.presets, std::nullopt);
  if (brought_.number == looked_) presets_.swap(old);
}

std::optional<PresetDesk::Outcome> PresetDesk::takeOutcome() {
  const std::lock_guard lock(brought_.mutex);
  if (brought_.outcomes.empty()) return std::nullopt;
  Outcome outcome = std::move(brought_.outcomes.front());
  brought_.outcomes.pop_front();
  return outcome;
}

Fabric PresetDesk::used(size_t card, const Fabric& now, int yarn, int fibre) const {
  return withPreset(kind_, presets_[card], now, yarn, fibre);
}

void PresetDesk::keep(PresetKind kind, const Fabric& now, int yarn, int fibre) {
  change(
      [kind, fabric = toKeep(kind, now, yarn, fibre)](PresetCabinet& cabinet) { return cabinet.keep(kind, fabric); });
}

void PresetDesk::duplicate(size_t card) {
  change([kind = kind_, preset = presets_[card]](PresetCabinet& cabinet) {
    Fabric fabric = *preset.fabric;
    fabric.name = preset.name;
    return cabinet.keep(kind, std::move(fabric), preset.tags, "Duplicated as");
  });
}

void PresetDesk::rename(size_t card, const std::string& name) {
  change([kind = kind_, before = presets_[card].name, name](PresetCabinet& cabinet) {
    cabinet.rename(kind, before, name);
    return std::string();
  });
}

/// It is out of sight at once, so that it cannot be removed twice; where it cannot be removed it comes back.
void PresetDesk::remove(size_t card) {
  change([kind = kind_, name = presets_[card].name](PresetCabinet& cabinet) {
    cabinet.remove(kind, name);
    return std::string();
  });
  presets_.erase(presets_.begin() + static_cast<ptrdiff_t>(card));
}

void PresetDesk::tag(size_t card, const std::string& tags) {
  change([kind = kind_, name = presets_[card].name, own = presets_[card].own, tags](PresetCabinet& cabinet) {
    cabinet.tag(kind, name, own, tags);
    return std::string();
  });
  presets_[card].tags = tags;
}

void PresetDesk::undo() {
  change([](PresetCabinet& cabinet) {
    cabinet.undo();
    return std::string();
  });
}

std::string PresetDesk::fileOf(const std::string& name) const {
  return (folder_ / (name + ".json")).string();
}

}  // namespace loomlight
