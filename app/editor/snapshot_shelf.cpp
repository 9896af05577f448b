#include "app/editor/snapshot_shelf.h"

#include <fmt/core.h>

#include "app/workers/display_picture.h"

namespace loomlight {

void SnapshotShelf::keep(std::shared_ptr<const Fabric> fabric, Pixels8 picture) {
  Kept kept;
  kept.name = fmt::format("{}. {}", ++count_, fabric->name);
  kept.fabric = std::move(fabric);
  kept.picture = std::move(picture);
  kept.texture = std::make_shared<PictureTexture>();
  kept.texture->upload(kept.picture);
  kept_.push_back(std::move(kept));
  if (kept_.size() > kMost) kept_.erase(kept_.begin());
}

void SnapshotShelf::remove(size_t index) {
  kept_.erase(kept_.begin() + static_cast<ptrdiff_t>(index));
}

std::vector<SnapshotItem> SnapshotShelf::items() const {
  std::vector<SnapshotItem> items;
  for (const Kept& kept : kept_)
    items.push_back({kept.texture->id(),
                     static_cast<float>(kept.picture.width) / static_cast<float>(kept.picture.height), kept.name});
  return items;
}

void SnapshotShelf::compare(size_t first, size_t second) {
  compared_ = {kept_[first], kept_[second]};
  difference_.upload(differencePicture(compared_[0].picture, compared_[1].picture));
}

CompareDialog::Model SnapshotShelf::comparison() const {
  CompareDialog::Model model;
  if (compared_.size() < 2) return model;
  model.first = compared_[0].texture->id();
  model.second = compared_[1].texture->id();
  model.difference = difference_.id();
  model.aspect = static_cast<float>(compared_[0].picture.width) / static_cast<float>(compared_[0].picture.height);
  model.firstName = compared_[0].name;
  model.secondName = compared_[1].name;
  return model;
}

}  // namespace loomlight
