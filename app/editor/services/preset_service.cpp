#include "app/editor/services/preset_service.h"

#include <fmt/core.h>

#include <utility>

#include "ui/words/preset_words.h"

namespace loomlight {

PresetService::PresetService(std::filesystem::path folder, DisplayDriver& driver, std::function<void()> wake)
    : folder_(std::move(folder)),
      thumbnails_(driver, wake),
      disk_(
          std::move(wake), [this](const Job& job, const auto&) { return done(job); },
          [this](const Job&, const std::string& problem) {
            return Brought{cabinet_ ? stateOf(*cabinet_) : State{}, {}, 0, Outcome{"", "", problem}};
          },
          Backlog::every) {
  disk_.ask([](PresetLibrary& cabinet) { return Brought{stateOf(cabinet), {}, 0, {}}; });
}

PresetService::State PresetService::stateOf(const PresetLibrary& cabinet) {
  return {cabinet.names(), cabinet.lastChange(), cabinet.problem()};
}

std::optional<PresetService::Brought> PresetService::done(const Job& job) {
  if (!cabinet_) cabinet_ = std::make_unique<PresetLibrary>(folder_);
  return job(*cabinet_);
}

/// One file a job: changes go between them.
std::optional<PresetService::Brought> PresetService::readOn(PresetLibrary& cabinet, PresetKind kind, uint64_t number) {
  if (number != wanted_) return std::nullopt;
  const bool more = cabinet.readNext(kind);
  if (more) disk_.ask([this, kind, number](PresetLibrary& next) { return readOn(next, kind, number); });
  if (more && !disk_.isTaken()) return std::nullopt;
  return Brought{stateOf(cabinet), cabinet.presets(kind), number, {}};
}

void PresetService::look() {
  looked_ = ++wanted_;
  disk_.ask([this, kind = kind_, scale = scale_, number = looked_](PresetLibrary& cabinet) -> std::optional<Brought> {
    if (number != wanted_) return std::nullopt;
    cabinet.look(kind, scale);
    disk_.ask([this, kind, number](PresetLibrary& next) { return readOn(next, kind, number); });
    return Brought{stateOf(cabinet), cabinet.presets(kind), number, {}};
  });
}

void PresetService::change(std::function<Outcome(PresetLibrary&)> edit) {
  disk_.ask([edit = std::move(edit)](PresetLibrary& cabinet) {
    Outcome outcome = edit(cabinet);
    return Brought{stateOf(cabinet), {}, 0, std::move(outcome)};
  });
  if (looked_ == wanted_) look();
}

std::vector<PresetCard> PresetService::cards(PresetKind kind, float scale) {
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

void PresetService::take() {
  while (auto come = disk_.take()) {
    state_ = std::move(come->state);
    if (come->presets && come->number == looked_) presets_ = std::move(*come->presets);
    if (come->outcome) outcomes_.push_back(std::move(*come->outcome));
  }
}

std::optional<PresetService::Outcome> PresetService::takeOutcome() {
  if (outcomes_.empty()) return std::nullopt;
  Outcome outcome = std::move(outcomes_.front());
  outcomes_.pop_front();
  return outcome;
}

Fabric PresetService::used(size_t card, const Fabric& now, int yarn, int fibre) const {
  return withPreset(kind_, presets_[card], now, yarn, fibre);
}

void PresetService::keep(PresetKind kind, const Fabric& now, int yarn, int fibre) {
  change([kind, fabric = toKeep(kind, now, yarn, fibre)](PresetLibrary& cabinet) {
    return Outcome{cabinet.keep(kind, fabric), "", ""};
  });
}

void PresetService::duplicate(size_t card) {
  change([kind = kind_, preset = presets_[card]](PresetLibrary& cabinet) {
    Fabric fabric = *preset.fabric;
    fabric.name = preset.name;
    return Outcome{cabinet.keep(kind, std::move(fabric), preset.tags, words::presets::duplicated), "", ""};
  });
}

void PresetService::rename(size_t card, const std::string& name) {
  change([kind = kind_, before = presets_[card].name, name](PresetLibrary& cabinet) {
    return Outcome{"", cabinet.rename(kind, before, name), ""};
  });
}

/// It is out of sight at once, so that it cannot be removed twice; where it cannot be removed it comes back.
void PresetService::remove(size_t card) {
  change([kind = kind_, name = presets_[card].name](PresetLibrary& cabinet) {
    cabinet.remove(kind, name);
    return Outcome{};
  });
  presets_.erase(presets_.begin() + static_cast<ptrdiff_t>(card));
}

void PresetService::tag(size_t card, const std::string& tags) {
  change([kind = kind_, name = presets_[card].name, own = presets_[card].own, tags](PresetLibrary& cabinet) {
    cabinet.tag(kind, name, own, tags);
    return Outcome{};
  });
  presets_[card].tags = tags;
}

void PresetService::undo() {
  change([](PresetLibrary& cabinet) {
    cabinet.undo();
    return Outcome{};
  });
}

std::string PresetService::fileOf(const std::string& name) const {
  return (folder_ / (name + ".json")).string();
}

}  // namespace loomlight
