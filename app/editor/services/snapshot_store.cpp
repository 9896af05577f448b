#include "app/editor/services/snapshot_store.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "render/display/display_picture.h"

namespace loomlight {
namespace {

/// Width over height.
float aspectOf(const Pixels8& picture) {
  return static_cast<float>(picture.width) / static_cast<float>(picture.height);
}

}  // namespace

SnapshotStore::SnapshotStore(std::filesystem::path folder, DisplayDriver& driver, std::function<void()> wake,
                             ViewFolder::Budget budget)
    : budget_(budget),
      folder_(std::move(folder), budget),
      driver_(driver),
      difference_(driver.makeTexture()),
      disk_(
          std::move(wake), [this](const Order& order, const auto&) { return done(folder_, order); },
          [](const Order& order, const std::string& why) { return Done{order.work, order.view.id, {}, {}, why}; },
          Backlog::every) {
  const std::vector<std::string> ids = folder_.ids();
  for (size_t i = ids.size() - std::min(ids.size(), budget.views); i < ids.size(); ++i) {
    ++awaited_;
    disk_.ask({Order::Work::read, {ids[i], {}, {}, {}}});
  }
}

SnapshotStore::Done SnapshotStore::done(const ViewFolder& folder, const Order& order) {
  using Work = Order::Work;
  Done done{order.work, order.view.id, {}, {}, {}};
  if (order.work == Work::read) done.view = folder.read(order.view.id);
  if (order.work == Work::keep || order.work == Work::keepAgain) done.removed = folder.keep(order.view);
  if (order.work == Work::remove) folder.remove(order.view.id);
  return done;
}

/// A view that cannot be read, none of ours or broken by hand, is not offered. Once one finds room, all that found none
/// are tried again; what that brings tries none again, as they would be tried without end.
void SnapshotStore::follow() {
  while (auto done = disk_.take()) {
    if (done->work == Order::Work::read) {
      --awaited_;
      if (done->view) add(std::move(*done->view));
      continue;
    }
    for (const std::string& id : done->removed) drop(id);
    if (find(done->id) == kept_.end()) continue;
    if (!done->problem.empty()) {
      unkept_[done->id] = std::move(done->problem);
      continue;
    }
    unkept_.erase(done->id);
    if (done->work == Order::Work::keep) keepAgain();
  }
}

void SnapshotStore::keepAgain() {
  for (const auto& [id, problem] : unkept_) disk_.ask({Order::Work::keepAgain, view(id)});
}

void SnapshotStore::drop(const std::string& id) {
  unkept_.erase(id);
  if (const auto found = find(id); found != kept_.end()) kept_.erase(found);
}

void SnapshotStore::add(KeptView view) {
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

std::string SnapshotStore::keep(std::shared_ptr<const Fabric> fabric, const ClothView& view, Pixels8 picture) {
  const KeptView kept{ViewFolder::newId(), std::move(fabric), view, std::move(picture)};
  add(kept);
  disk_.ask({Order::Work::keep, kept});
  while (kept_.size() > budget_.views) remove(kept_.front().view.id);
  return kept.id;
}

/// On a texture of its own: what is being compared stays as it is.
void SnapshotStore::renew(const std::string& id, Pixels8 picture) {
  const auto found = std::find_if(kept_.begin(), kept_.end(), [&](const Kept& k) { return k.view.id == id; });
  if (found == kept_.end()) return;
  found->view.picture = std::move(picture);
  found->texture = driver_.makeTexture();
  found->texture->upload(found->view.picture);
  disk_.ask({Order::Work::keep, found->view});
}

void SnapshotStore::remove(const std::string& id) {
  disk_.ask({Order::Work::remove, {id, {}, {}, {}}});
  drop(id);
}

std::vector<SnapshotStore::Kept>::const_iterator SnapshotStore::find(const std::string& id) const {
  return std::find_if(kept_.begin(), kept_.end(), [&](const Kept& k) { return k.view.id == id; });
}

std::vector<SnapshotItem> SnapshotStore::items() const {
  std::vector<SnapshotItem> items;
  for (const Kept& kept : kept_)
    items.push_back({kept.view.id, kept.texture->id(), aspectOf(kept.view.picture), kept.name});
  return items;
}

void SnapshotStore::compare(const std::string& first, const std::string& second) {
  compared_ = {*find(first), *find(second)};
  difference_->upload(differencePicture(compared_[0].view.picture, compared_[1].view.picture));
}

CompareDialog::Model SnapshotStore::comparison() const {
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
