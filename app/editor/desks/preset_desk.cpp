#include "app/editor/desks/preset_desk.h"

#include <fmt/core.h>

#include <utility>

namespace loomlight {

PresetDesk::PresetDesk(std::filesystem::path folder, DisplayDriver& driver, std::function<void()> wake)
    : folder_(std::move(folder)),
      thumbnails_(driver, wake),
      disk_(
          wake, [this](const Job& job, const auto&) { return done(job); },
          [this](const Job&, const std::string& problem) {
            return Brought{cabinet_ ? stateOf(*cabinet_) : State{}, {}, 0, Outcome{"", problem}};
          },
          Backlog::every) {
  disk_.ask([](PresetCabinet& cabinet) { return Brought{stateOf(cabinet), {}, 0, {}}; });
}

PresetDesk::State PresetDesk::stateOf(const PresetCabinet& cabinet) {
  return {cabinet.names(), cabinet.lastChange(), cabinet.problem()};
}

std::optional<PresetDesk::Brought> PresetDesk::done(const Job& job) {
  if (!cabinet_) cabinet_ = std::make_unique<PresetCabinet>(folder_);
  return job(*cabinet_);
}

/// One file a turn: changes go between them.
std::optional<PresetDesk::Brought> PresetDesk::readOn(PresetCabinet& cabinet, PresetKind kind, uint64_t number) {
  if (number != wanted_) return std::nullopt;
  const bool more = cabinet.readNext(kind);
  if (more) disk_.ask([this, kind, number](PresetCabinet& next) { return readOn(next, kind, number); });
  if (more && !disk_.isTaken()) return std::nullopt;
  return Brought{stateOf(cabinet), cabinet.presets(kind), number, {}};
}

void PresetDesk::look() {
  looked_ = ++wanted_;
  disk_.ask([this, kind = kind_, scale = scale_, number = looked_](PresetCabinet& cabinet) -> std::optional<Brought> {
    if (number != wanted_) return std::nullopt;
    cabinet.look(kind, scale);
    disk_.ask([this, kind, number](PresetCabinet& next) { return readOn(next, kind, number); });
    return Brought{stateOf(cabinet), cabinet.presets(kind), number, {}};
  });
}

void PresetDesk::change(std::function<std::string(PresetCabinet&)> edit) {
  disk_.ask([edit = std::move(edit)](PresetCabinet& cabinet) {
    Outcome outcome{edit(cabinet), ""};
    return Brought{stateOf(cabinet), {}, 0, std::move(outcome)};
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
  while (auto come = disk_.take()) {
    state_ = std::move(come->state);
    if (come->presets && come->number == looked_) presets_ = std::move(*come->presets);
    if (come->outcome) outcomes_.push_back(std::move(*come->outcome));
  }
}

std::optional<PresetDesk::Outcome> PresetDesk::takeOutcome() {
  if (outcomes_.empty()) return std::nullopt;
  Outcome outcome = std::move(outcomes_.front());
  outcomes_.pop_front();
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
