#include "app/editor/document.h"

#include "core/fabric/fabric_json.h"

namespace loomlight {
namespace {

constexpr size_t kMostSteps = 1000;

std::shared_ptr<const Fabric> seenFrom(const std::shared_ptr<const Fabric>& fabric, const Camera& camera) {
  if (fabric->camera == camera) return fabric;
  auto moved = std::make_shared<Fabric>(*fabric);
  moved->camera = camera;
  return moved;
}

}  // namespace

Document::Document(Fabric fabric, std::string file) : file_(std::move(file)) {
  steps_.push_back({std::make_shared<const Fabric>(std::move(fabric)), 0, {}});
}

void Document::edit(Fabric fabric, uint64_t gesture, const EditPlace& place) {
  ++revision_;
  auto value = std::make_shared<const Fabric>(std::move(fabric));
  const bool continues = gesture == gesture_ && now_ > 0 && !canRedo();
  gesture_ = gesture;
  if (continues) {
    steps_[now_] = {std::move(value), nextId_++, steps_[now_].place};
    return;
  }
  steps_.resize(now_ + 1);
  steps_.push_back({std::move(value), nextId_++, place});
  if (steps_.size() > kMostSteps) steps_.erase(steps_.begin());
  now_ = steps_.size() - 1;
}

void Document::lookFrom(const Camera& camera) {
  steps_[now_].fabric = seenFrom(fabric(), camera);
}

EditPlace Document::undo() {
  const EditPlace place = steps_[now_].place;
  if (!canUndo()) return {};
  go(now_ - 1);
  return place;
}

EditPlace Document::redo() {
  if (!canRedo()) return {};
  go(now_ + 1);
  return steps_[now_].place;
}

void Document::go(size_t step) {
  // Undo takes back what was done to the cloth, not where one stands to look at it.
  const Camera camera = fabric()->camera;
  now_ = step;
  steps_[now_].fabric = seenFrom(fabric(), camera);
  gesture_ = 0;
  ++revision_;
}

void Document::save(const std::string& file) {
  writeFabric(*fabric(), file);
  file_ = file;
  savedId_ = steps_[now_].id;
  gesture_ = 0;  // the next edit is a step of its own, so that undo returns to what was saved
}

}  // namespace loomlight
