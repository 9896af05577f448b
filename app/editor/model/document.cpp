#include "app/editor/model/document.h"

#include <algorithm>
#include <vector>

namespace loomlight {
namespace {

size_t textBytes(const Fabric& fabric) {
  size_t bytes = fabric.name.capacity() + fabric.description.capacity() + fabric.drape.file.capacity() +
                 fabric.light.file.capacity() + fabric.light.illuminantFile.capacity();
  for (const Yarn& yarn : fabric.yarns) bytes += yarn.name.capacity();
  for (const Fibre& fibre : fabric.fibres) bytes += fibre.name.capacity();
  for (const Colourway& colourway : fabric.colourways) bytes += colourway.name.capacity();
  return bytes;
}

/// About what a fabric takes that shares nothing but rows of its weave with the one before. Null: there is none.
size_t ownBytes(const Fabric& fabric, const Fabric* before) {
  const Weave& weave = fabric.weave;
  size_t bytes = sizeof(Fabric) + sizeof(Weave::SharedRow) * static_cast<size_t>(weave.picks()) + textBytes(fabric) +
                 fabric.yarns.capacity() * sizeof(Yarn) + fabric.fibres.capacity() * sizeof(Fibre) +
                 (fabric.warpSequence.capacity() + fabric.weftSequence.capacity()) * sizeof(int) +
                 fabric.colourways.capacity() * sizeof(Colourway);
  for (const Colourway& colourway : fabric.colourways)
    bytes += colourway.absorption_per_mm.capacity() * sizeof(Absorption);
  for (const Fibre& fibre : fabric.fibres) bytes += fibre.absorption_per_mm.dyes.capacity() * sizeof(Dyestuff);
  const int both = before ? std::min(weave.picks(), before->weave.picks()) : 0;
  for (int pick = 0; pick < weave.picks(); ++pick)
    if (pick >= both || weave.sharedRow(pick) != before->weave.sharedRow(pick)) bytes += weave.row(pick).size();
  if (!fabric.draft) return bytes;
  for (const auto* lists :
       {&fabric.draft->threading, &fabric.draft->tieUp, &fabric.draft->treadling, &fabric.draft->liftplan})
    for (const std::vector<int>& list : *lists) bytes += sizeof(std::vector<int>) + list.capacity() * sizeof(int);
  return bytes;
}

std::shared_ptr<const Fabric> seenFrom(const std::shared_ptr<const Fabric>& fabric, const Camera& camera) {
  if (fabric->camera == camera) return fabric;
  auto moved = std::make_shared<Fabric>(*fabric);
  moved->camera = camera;
  return moved;
}

}  // namespace

size_t Document::memoryForUndo_bytes(uint64_t physical_bytes) {
  constexpr uint64_t kShare = 8, kMost = uint64_t{1} << 30;
  return static_cast<size_t>(std::min(physical_bytes / kShare, kMost));
}

Document::Document(Fabric fabric, std::string file, size_t mostBytes) : mostBytes_(mostBytes), file_(std::move(file)) {
  push({std::make_shared<const Fabric>(std::move(fabric)), 0, {}, 0});
}

void Document::push(Step step) {
  step.bytes = ownBytes(*step.fabric, steps_.empty() ? nullptr : steps_.back().fabric.get());
  bytes_ += step.bytes;
  steps_.push_back(std::move(step));
  while (steps_.size() > 1 && bytes_ > mostBytes_) {
    bytes_ -= steps_.front().bytes;
    steps_.pop_front();
  }
  now_ = steps_.size() - 1;
}

void Document::edit(Fabric fabric, uint64_t gesture, const EditPlace& place) {
  ++revision_;
  const bool continues = gesture == gesture_ && now_ > 0 && !canRedo();
  gesture_ = gesture;
  const EditPlace first = continues ? steps_[now_].place : place;
  for (const size_t kept = continues ? now_ : now_ + 1; steps_.size() > kept; steps_.pop_back())
    bytes_ -= steps_.back().bytes;
  push({std::make_shared<const Fabric>(std::move(fabric)), nextId_++, first, 0});
}

void Document::lookFrom(const Camera& camera) {
  steps_[now_].fabric = seenFrom(fabric(), camera);
}

void Document::renderAs(const RenderSettings& settings) {
  if (fabric()->render == settings) return;
  auto sized = std::make_shared<Fabric>(*fabric());
  sized->render = settings;
  steps_[now_].fabric = std::move(sized);
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

void Document::savedAs(const std::string& file, uint64_t state) {
  file_ = file;
  savedState_ = state;
  gesture_ = 0;  // the next edit is a step of its own, so that undo returns to what was saved
}

}  // namespace loomlight
