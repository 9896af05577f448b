#include "app/editor/preset_desk.h"

#include <fmt/core.h>

#include <cmath>

#include "app/editor/sample_fabric.h"
#include "app/editor/yarn_close_up.h"
#include "core/base/error.h"
#include "core/fabric/colour.h"
#include "core/fabric/colourways.h"
#include "core/fabric/presets.h"
#include "core/fabric/yarn_count.h"
#include "core/fabric/yarn_edit.h"

namespace loomlight {
namespace {

constexpr int kWidth = 168, kHeight = 120;

/// A few crossings of a cloth, flat under a sky.
Fabric portraitOf(Fabric fabric, int width, int height) {
  constexpr double kSeen_mm = 6, kSeenPerDistance = 0.3527;  // 2 tan(10 degrees)
  fabric.drape = Drape{};
  fabric.drape.width_mm = 2.4 * kSeen_mm;
  fabric.drape.height_mm = 2 * kSeen_mm;
  fabric.camera = Camera{};
  fabric.camera.elevation_deg = 65;
  fabric.camera.distance_mm = kSeen_mm / kSeenPerDistance;
  fabric.light = Light{};
  fabric.render = RenderSettings{};
  fabric.render.width = width;
  fabric.render.height = height;
  fabric.render.samplesPerPixel = 16;
  fabric.render.resolution = 4;
  return fabric;
}

/// A yarn of the trade, or a fibre in a plain cloth.
Fabric clothOf(const std::string& name, const Yarn& yarn, const Fibre& fibre) {
  Fabric fabric;
  fabric.name = name;
  fabric.yarns = {yarn};
  fabric.yarns[0].fibre = 0;
  fabric.fibres = {fibre};
  return fabric;
}

/// Only what the yarn and its fibre are; a blend is kept as its first fibre.
Fabric aloneWith(const Fabric& fabric, int yarn, int fibre) {
  Yarn alone = fabric.yarns[static_cast<size_t>(yarn)];
  alone.blendFibre.reset();
  alone.blendShare.reset();
  return clothOf(alone.name, alone, fabric.fibres[static_cast<size_t>(fibre)]);
}

std::string aboutCloth(const Fabric& fabric) {
  std::string about = fmt::format("{} ends, {} picks in the repeat; {:.0f} \xC3\x97 {:.0f} per cm", fabric.weave.ends(),
                                  fabric.weave.picks(), fabric.ends_per_cm, fabric.picks_per_cm);
  for (const Fibre& fibre : fabric.fibres) about += "; " + fibre.name;
  return fabric.description.empty() ? about : fabric.description + "\n" + about;
}

std::string aboutYarn(const Yarn& yarn, const Fibre& fibre) {
  std::string folded = fmt::format("{} {}", yarn.plies, yarn.plies == 1 ? "ply" : "plies");
  if (yarn.cords > 1) folded = fmt::format("{} cords of {}", yarn.cords, folded);
  return fmt::format("{:.1f} tex, {}, {}", yarnCount_tex(yarn, fibre), folded, fibre.name);
}

std::string aboutFibre(const Fibre& fibre) {
  return fmt::format("{:.1f} \u00B5m across, {:.2f} dtex", 2 * fibre.radius_um, fibreFineness_dtex(fibre));
}

std::string aboutOf(PresetKind kind, const Fabric& fabric) {
  switch (kind) {
    case PresetKind::fabrics:
      return aboutCloth(fabric);
    case PresetKind::yarns:
      return aboutYarn(fabric.yarns[0], fabric.fibres[0]);
    case PresetKind::fibres:
      return aboutFibre(fabric.fibres[0]);
    case PresetKind::colourways:
      break;
  }
  const size_t fibres = fabric.fibres.size();
  return fibres == 1 ? "colour of one fibre" : fmt::format("colours of {} fibres", fibres);
}

/// What came with the program.
std::vector<Fabric> given(PresetKind kind) {
  std::vector<Fabric> fabrics;
  if (kind == PresetKind::fabrics || kind == PresetKind::colourways)
    for (size_t i = 0; i < sampleNames().size(); ++i) {
      fabrics.push_back(sampleFabric(i));
      fabrics.back().name = sampleNames()[i];
    }
  if (kind == PresetKind::yarns)
    for (const YarnPreset& preset : yarnPresets())
      fabrics.push_back(clothOf(preset.yarn.name, preset.yarn, preset.fibre));
  if (kind == PresetKind::fibres)
    for (const FibrePreset& preset : fibrePresets())
      fabrics.push_back(clothOf(preset.fibre.name, Yarn{}, preset.fibre));
  return fabrics;
}

/// A designer's own preset may have the name of one that came with the program; no name of a file has a slash.
std::string tagKey(const std::string& name, bool own) {
  return own ? name : "given/" + name;
}

}  // namespace

PresetDesk::Shelf PresetDesk::shelfIn(const std::filesystem::path& folder) {
  return {PresetStore(folder), PresetTags(folder / "tags"), {}, {}};
}

PresetDesk::PresetDesk(std::filesystem::path folder, std::function<void()> wake)
    : shelves_{shelfIn(folder), shelfIn(folder / "yarns"), shelfIn(folder / "fibres"), shelfIn(folder / "colours")},
      thumbnails_(std::move(wake)) {}

void PresetDesk::read(PresetKind kind, float scale) {
  Shelf& shelf = of(kind);
  shelf.store.refresh();
  shelf.entries.clear();
  const int width = static_cast<int>(std::lround(kWidth * scale)),
            height = static_cast<int>(std::lround(kHeight * scale));
  const auto add = [&](Fabric fabric, std::string name, bool own) {
    Entry entry;
    const std::string tags = shelf.tags.of(tagKey(name, own));
    entry.card = {std::move(name), aboutOf(kind, fabric), tags, own, nullptr};
    const Fabric portrait =
        kind == PresetKind::yarns ? yarnCloseUp(fabric, 0, width, height) : portraitOf(fabric, width, height);
    entry.portrait = std::make_shared<const Fabric>(portrait);
    entry.fabric = std::move(fabric);
    shelf.entries.push_back(std::move(entry));
  };
  for (const std::string& name : shelf.store.names()) {
    try {
      add(shelf.store.load(name), name, true);
    } catch (const InputError&) {
      continue;  // a file that is none of ours, or was broken by hand: it is not offered
    }
  }
  for (Fabric& fabric : given(kind)) {
    std::string name = fabric.name;
    add(std::move(fabric), std::move(name), false);
  }
  shelf.read = true;
  shelf.scale = scale;
}

const std::vector<PresetCard>& PresetDesk::cards(PresetKind kind, float scale) {
  Shelf& shelf = of(kind);
  if (!shelf.read || shelf.scale != scale) read(kind, scale);
  shelf.cards.clear();
  for (const Entry& entry : shelf.entries) {
    PresetCard card = entry.card;
    card.picture = thumbnails_.of(
        fmt::format("{} {} {}", static_cast<int>(kind), entry.card.own ? "own" : "given", card.name), entry.portrait);
    shelf.cards.push_back(std::move(card));
  }
  return shelf.cards;
}

Fabric PresetDesk::used(PresetKind kind, size_t card, const Fabric& now, int yarn, int fibre) const {
  const Fabric& preset = of(kind).entries[card].fabric;
  const auto colourOf = [](const Fibre& of) {
    return colourFromAbsorption(of.absorption_per_mm, of.azimuthalRoughness, of.radius_um);
  };
  // What came with the program is undyed: the colour stays the designer's.
  const bool own = of(kind).entries[card].card.own;
  const Fibre& old = now.fibres[static_cast<size_t>(fibre)];
  const auto coloured = [&](const Fibre& of) { return own ? of : dyed(of, colourOf(old)); };
  switch (kind) {
    case PresetKind::fabrics:
      return dressed(now, preset);
    case PresetKind::yarns:
      return withYarn(now, yarn, preset.yarns[0], coloured(preset.fibres[0]));
    case PresetKind::fibres: {
      Fabric fabric = now;
      Fibre& changed = fabric.fibres[static_cast<size_t>(fibre)];
      const std::string name = changed.name;
      changed = coloured(preset.fibres[0]);
      changed.name = name;
      return fabric;
    }
    case PresetKind::colourways:
      break;
  }
  return inColourway(now, colourwayOf(preset, preset.name));
}

void PresetDesk::changed(PresetKind kind, std::string said, std::function<TagAgain()> takeBack) {
  of(kind).read = false;
  changes_.push_back({std::move(said), std::move(takeBack)});
}

/// A new preset has these tags, whatever one had that had its name before. Goes with the change of that preset, which
/// is made and can be taken back even where the tags cannot be written.
void PresetDesk::tagAnew(PresetKind kind, const std::string& name, const std::string& tags) {
  if (of(kind).tags.of(name) != tags) of(kind).tags.set(name, tags);
}

void PresetDesk::keep(PresetKind kind, const Fabric& now, int yarn, int fibre) {
  Fabric fabric = now;
  if (kind == PresetKind::yarns) fabric = aloneWith(now, yarn, now.yarns[static_cast<size_t>(yarn)].fibre);
  if (kind == PresetKind::fibres) {
    fabric = aloneWith(now, yarn, fibre);
    fabric.name = fabric.fibres[0].name;
  }
  const std::string name = of(kind).store.keep(std::move(fabric));
  changed(kind, fmt::format("Kept \"{}\".", name), [this, kind, name]() -> TagAgain {
    of(kind).store.remove(name);
    return [] {};
  });
  tagAnew(kind, name, "");
}

void PresetDesk::duplicate(PresetKind kind, size_t card) {
  Fabric fabric = of(kind).entries[card].fabric;
  fabric.name = of(kind).entries[card].card.name;
  const std::string tags = of(kind).entries[card].card.tags;
  const std::string name = of(kind).store.keep(std::move(fabric));
  changed(kind, fmt::format("Duplicated as \"{}\".", name), [this, kind, name]() -> TagAgain {
    of(kind).store.remove(name);
    return [this, kind, name] { tagAnew(kind, name, ""); };
  });
  tagAnew(kind, name, tags);
}

void PresetDesk::rename(PresetKind kind, size_t card, const std::string& name) {
  const std::string before = of(kind).entries[card].card.name;
  const std::string tags = of(kind).entries[card].card.tags;
  const std::string after = of(kind).store.rename(before, name);
  if (after == before) return;
  const auto moveTags = [this, kind, tags](const std::string& from, const std::string& to) {
    tagAnew(kind, to, tags);
    tagAnew(kind, from, "");
  };
  changed(kind, fmt::format("Renamed \"{}\" to \"{}\".", before, after),
          [this, kind, before, after, moveTags]() -> TagAgain {
            const std::string again = of(kind).store.rename(after, before);
            return [moveTags, after, again] { moveTags(after, again); };
          });
  moveTags(before, after);
}

void PresetDesk::remove(PresetKind kind, size_t card) {
  const std::string name = of(kind).entries[card].card.name;
  const std::string tags = of(kind).entries[card].card.tags;
  const PresetStore::Removed removed = of(kind).store.remove(name);
  changed(kind, fmt::format("Removed \"{}\".", name), [this, kind, removed, tags]() -> TagAgain {
    of(kind).store.putBack(removed);
    return [this, kind, removed, tags] { tagAnew(kind, removed.name, tags); };
  });
  tagAnew(kind, name, "");
}

void PresetDesk::tag(PresetKind kind, size_t card, const std::string& tags) {
  const PresetCard& tagged = of(kind).entries[card].card;
  const std::string key = tagKey(tagged.name, tagged.own), before = tagged.tags;
  const std::string said = fmt::format("Tagged \"{}\".", tagged.name);
  of(kind).tags.set(key, tags);
  changed(kind, said, [this, kind, key, before]() -> TagAgain {
    of(kind).tags.set(key, before);
    return [] {};
  });
}

void PresetDesk::undo() {
  if (changes_.empty()) return;
  for (Shelf& shelf : shelves_) shelf.read = false;
  const TagAgain tagAgain = changes_.back().takeBack();
  changes_.pop_back();
  tagAgain();
}

std::string PresetDesk::problem() const {
  for (const Shelf& shelf : shelves_)
    if (!shelf.tags.problem().empty()) return shelf.tags.problem();
  return {};
}

const std::string& PresetDesk::lastChange() const {
  static const std::string kNone;
  return changes_.empty() ? kNone : changes_.back().said;
}

}  // namespace loomlight
