#include "app/live/recent_cloths.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/shell/drape_surface.h"
#include "render/scene/fibre_bricks.h"

namespace loomlight {

RecentCloths::Base RecentCloths::baseFor(const Fabric& fabric) const {
  std::optional<Base> newest;
  for (const Entry& entry : entries_) {
    Base base{entry.cloth, changes(*entry.cloth.traceable.scene->fabric, fabric)};
    if (!base.edit.cloth()) return base;
    if (!newest) newest = std::move(base);
  }
  return newest.value_or(Base{});
}

void RecentCloths::keep(BuiltCloth cloth) {
  const auto& volume = cloth.traceable.scene->cloth->volume;
  const auto known = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) {
    return entry.cloth.traceable.scene->cloth->volume == volume;
  });
  if (known != entries_.end()) {
    const auto place = static_cast<size_t>(known - entries_.begin());
    bytes_ -= known->bytes;
    entries_.erase(known);
    if (place > 0) count(place);
  }
  if (!entries_.empty()) {
    Traceable& before = entries_.front().cloth.traceable;
    if (before.scene->fabric->render.method == Method::fibres) before.medium.reset();
  }
  entries_.push_front({std::move(cloth), 0});
  count(1);
  while (bytes_ > budget_bytes_ || entries_.size() > kMost) {
    bytes_ -= entries_.back().bytes;
    entries_.pop_back();
  }
}

/// Counts the bytes of an entry, if there is one of this number, beside the one before it.
void RecentCloths::count(size_t i) {
  if (i >= entries_.size()) return;
  bytes_ -= entries_[i].bytes;
  const TraceData &own = entries_[i].data(), &newer = entries_[i - 1].data();
  entries_[i].bytes = own.volume->bytesBeside(*newer.volume);
  if (own.fibres && own.fibres != newer.fibres) entries_[i].bytes += own.fibres->bytes();
  if (own.shell != newer.shell) entries_[i].bytes += own.shell->bytes();
  if (own.drape && own.drape != newer.drape) entries_[i].bytes += own.drape->bytes();
  bytes_ += entries_[i].bytes;
}

}  // namespace loomlight
