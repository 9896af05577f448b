#include "app/editor/presets/preset_library.h"

#include <fmt/core.h>

#include <algorithm>
#include <new>
#include <utility>

#include "core/base/error.h"
#include "ui/words/preset_words.h"

namespace loomlight {
namespace fs = std::filesystem;
namespace {

/// Of the files of one kind: what is in memory of them is about as much.
constexpr uintmax_t kMostBytes = 1'000'000'000;

/// A designer's own preset may have the name of one that came with the program; no name of a file has a slash.
std::string tagKey(const std::string& name, bool own) {
  return own ? name : "given/" + name;
}

}  // namespace

PresetLibrary::Shelf PresetLibrary::shelfIn(const fs::path& folder) {
  return {PresetFolder(folder), PresetTags(folder / "tags"), {}, {}, 0};
}

PresetLibrary::PresetLibrary(const fs::path& folder)
    : shelves_{shelfIn(folder), shelfIn(folder / "yarns"), shelfIn(folder / "fibres"), shelfIn(folder / "colours")} {}

void PresetLibrary::look(PresetKind kind, float scale) {
  Shelf& shelf = of(kind);
  shelf.store.refresh();
  if (shelf.scale != scale) {
    shelf.scale = scale;
    shelf.read.clear();
    shelf.given = givenPresets(kind, scale);
  }
  const std::vector<std::string>& names = shelf.store.names();
  std::erase_if(shelf.read, [&](const auto& one) {
    return !std::binary_search(names.begin(), names.end(), one.first) ||
           shelf.store.stampOf(one.first) != one.second.stamp;
  });
}

bool PresetLibrary::readNext(PresetKind kind) {
  Shelf& shelf = of(kind);
  for (const std::string& name : shelf.store.names()) {
    if (shelf.read.count(name)) continue;
    Read& read = shelf.read[name];
    read.stamp = shelf.store.stampOf(name);
    uintmax_t bytes = 0;
    for (const auto& [other, one] : shelf.read) bytes += one.stamp.bytes;
    if (read.tooMany = bytes > kMostBytes; read.tooMany) return true;
    try {
      read.preset = presetOf(kind, shelf.store.load(name), name, true, shelf.scale);
    } catch (const InputError&) {
      read.preset.reset();  // none of ours, or broken by hand: it is not offered
    } catch (const std::bad_alloc&) {
      read.tooMany = true;
    }
    return true;
  }
  return false;
}

std::vector<Preset> PresetLibrary::presets(PresetKind kind) const {
  const Shelf& shelf = of(kind);
  std::vector<Preset> presets;
  const auto add = [&](const Preset& preset) {
    presets.push_back(preset);
    presets.back().tags = shelf.tags.of(tagKey(preset.name, preset.own));
  };
  for (const auto& [name, read] : shelf.read)
    if (read.preset) add(*read.preset);
  for (const Preset& preset : shelf.given) add(preset);
  return presets;
}

std::string PresetLibrary::problem() const {
  for (const Shelf& shelf : shelves_) {
    if (!shelf.tags.problem().empty()) return shelf.tags.problem();
    for (const auto& [name, read] : shelf.read)
      if (read.tooMany) return fmt::format(words::presets::tooMany, name);
  }
  return {};
}

void PresetLibrary::changed(std::string said, std::function<TagAgain()> takeBack) {
  changes_.push_back({std::move(said), std::move(takeBack)});
}

/// A new preset has these tags, whatever one had that had its name before. Goes with the change of that preset, which
/// is made and can be taken back even where the tags cannot be written.
void PresetLibrary::tagAnew(PresetKind kind, const std::string& name, const std::string& tags) {
  if (of(kind).tags.of(name) != tags) of(kind).tags.set(name, tags);
}

std::string PresetLibrary::keep(PresetKind kind, Fabric fabric, const std::string& tags, const char* done) {
  const std::string name = of(kind).store.keep(std::move(fabric));
  changed(fmt::format(words::presets::done, done, name), [this, kind, name]() -> TagAgain {
    of(kind).store.remove(name);
    return [this, kind, name] { tagAnew(kind, name, ""); };
  });
  tagAnew(kind, name, tags);
  return name;
}

std::string PresetLibrary::rename(PresetKind kind, const std::string& before, const std::string& name) {
  const std::string tags = of(kind).tags.of(before);
  const std::string after = of(kind).store.rename(before, name);
  if (after == before) return after;
  const auto moveTags = [this, kind, tags](const std::string& from, const std::string& to) {
    tagAnew(kind, to, tags);
    tagAnew(kind, from, "");
  };
  changed(fmt::format(words::presets::renamed, before, after), [this, kind, before, after, moveTags]() -> TagAgain {
    const std::string again = of(kind).store.rename(after, before);
    return [moveTags, after, again] { moveTags(after, again); };
  });
  moveTags(before, after);
  return after;
}

void PresetLibrary::remove(PresetKind kind, const std::string& name) {
  const std::string tags = of(kind).tags.of(name);
  const PresetFolder::Removed removed = of(kind).store.remove(name);
  changed(fmt::format(words::presets::removed, name), [this, kind, removed, tags]() -> TagAgain {
    of(kind).store.putBack(removed);
    return [this, kind, removed, tags] { tagAnew(kind, removed.name, tags); };
  });
  tagAnew(kind, name, "");
}

void PresetLibrary::tag(PresetKind kind, const std::string& name, bool own, const std::string& tags) {
  const std::string key = tagKey(name, own), before = of(kind).tags.of(key);
  of(kind).tags.set(key, tags);
  changed(fmt::format(words::presets::tagged, name), [this, kind, key, before]() -> TagAgain {
    of(kind).tags.set(key, before);
    return [] {};
  });
}

void PresetLibrary::undo() {
  if (changes_.empty()) return;
  const TagAgain tagAgain = changes_.back().takeBack();
  changes_.pop_back();
  tagAgain();
}

const std::string& PresetLibrary::lastChange() const {
  static const std::string kNone;
  return changes_.empty() ? kNone : changes_.back().said;
}

}  // namespace loomlight
