#include "app/editor/controllers/snapshot_shelf.h"

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "render/display/display_picture.h"

namespace loomlight {
namespace {

/// Width over height.
float aspectOf(const Pixels8& picture) {
  return static_cast<float>(picture.width) / static_cast<float>(picture.height);
}

}  // namespace

SnapshotShelf::SnapshotShelf(std::filesystem::path folder, DisplayDriver& driver, std::function<void()> wake)
    : folder_(std::move(folder), kBudget), driver_(driver), wake_(std::move(wake)), difference_(driver.makeTexture()) {
  const std::vector<std::string> ids = folder_.ids();
  for (size_t i = ids.size() - std::min(ids.size(), kBudget.views); i < ids.size(); ++i) {
    ++awaited_;
    readLater(ids[i]);
  }
}

void SnapshotShelf::readLater(const std::string& id) {
  disk_.post([this, id] {
    std::optional<KeptView> view;
    try {
      view = folder_.read(id);
    } catch (const std::exception&) {
      // A file that is none of ours, or was broken by hand: it is not offered.
    }
    {
      const std::lock_guard lock(brought_.mutex);
      if (view)
        brought_.views.push_back(std::move(*view));
      else
        ++brought_.unreadable;
    }
    wake_();
  });
}

void SnapshotShelf::follow() {
  std::vector<KeptView> views;
  {
    const std::lock_guard lock(brought_.mutex);
    awaited_ -= brought_.views.size() + std::exchange(brought_.unreadable, 0);
    views.swap(brought_.views);
  }
  for (KeptView& view : views) add(std::move(view));
}

void SnapshotShelf::add(KeptView view) {
  Kept kept;
  kept.name = fmt::format("{}. {}", ++count_, view.fabric->name);
  kept.view = std::move(view);
  kept.texture = driver_.makeTexture();
  kept.texture->upload(kept.view.picture);
  // Those of former sessions may come after one that was kept meanwhile.
  const auto place = std::upper_bound(kept_.begin(), kept_.end(), kept.view.id,
                                      [](const std::string& id, const Kept& k) { return id < k.view.id; });
  kept_.insert(place, std::move(kept));
}

std::string SnapshotShelf::keep(std::shared_ptr<const Fabric> fabric, Pixels8 picture) {
  const KeptView kept{ViewFolder::newId(), std::move(fabric), std::move(picture)};
  add(kept);
  writeLater(kept);
  while (kept_.size() > kBudget.views) remove(0);
  return kept.id;
}

/// On a texture of its own: what is being compared stays as it is.
void SnapshotShelf::renew(const std::string& id, Pixels8 picture) {
  const auto found = std::find_if(kept_.begin(), kept_.end(), [&](const Kept& k) { return k.view.id == id; });
  if (found == kept_.end()) return;
  found->view.picture = std::move(picture);
  found->texture = driver_.makeTexture();
  found->texture->upload(found->view.picture);
  writeLater(found->view);
}

void SnapshotShelf::writeLater(KeptView kept) {
  disk_.post([this, view = std::move(kept)] {
    std::string problem;
    try {
      folder_.keep(view);
    } catch (const std::exception& error) {
      problem = error.what();
    }
    {
      const std::lock_guard lock(brought_.mutex);
      brought_.problem = std::move(problem);
    }
    wake_();
  });
}

void SnapshotShelf::remove(size_t index) {
  disk_.post([this, id = kept_[index].view.id] { folder_.remove(id); });
  kept_.erase(kept_.begin() + static_cast<ptrdiff_t>(index));
}

std::string SnapshotShelf::problem() const {
  const std::lock_guard lock(brought_.mutex);
  return brought_.problem;
}

std::vector<SnapshotItem> SnapshotShelf::items() const {
  std::vector<SnapshotItem> items;
  for (const Kept& kept : kept_) items.push_back({kept.texture->id(), aspectOf(kept.view.picture), kept.name});
  return items;
}

void SnapshotShelf::compare(size_t first, size_t second) {
  compared_ = {kept_[first], kept_[second]};
  difference_->upload(differencePicture(compared_[0].view.picture, compared_[1].view.picture));
}

CompareDialog::Model SnapshotShelf::comparison() const {
  CompareDialog::Model model;
  if (compared_.size() < 2) return model;
  model.first = compared_[0].texture->id();
  model.second = compared_[1].texture->id();
  model.difference = difference_->id();
  model.firstAspect = aspectOf(compared_[0].view.picture);
  model.secondAspect = aspectOf(compared_[1].view.picture);
  model.firstName = compared_[0].name;
  model.secondName = compared_[1].name;
  return model;
}

}  // namespace loomlight
