#include "app/editor/model/document.h"

#include <algorithm>
#include <tuple>
#include <vector>

#include "core/fabric/model/booth_lamps.h"

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

/// Where one stands to look at it, and in which picture, is no part of the cloth.
std::shared_ptr<const Fabric> seenFrom(const std::shared_ptr<const Fabric>& fabric, const Camera& camera,
                                       const RenderSettings& picture) {
  RenderSettings render = fabric->render;
  render.width = picture.width;
  render.height = picture.height;
  render.samplesPerPixel = picture.samplesPerPixel;
  if (fabric->camera == camera && fabric->render == render) return fabric;
  auto seen = std::make_shared<Fabric>(*fabric);
  seen->camera = camera;
  seen->render = std::move(render);
  return seen;
}

/// What of a light is its lamp.
template <class AnyLight>
auto lampOf(AnyLight& light) {
  return std::tie(light.illuminant, light.temperature_K, light.illuminantFile);
}

}  // namespace

size_t Document::memoryForUndo_bytes(uint64_t physical_bytes) {
  constexpr uint64_t kShare = 8, kMost = uint64_t{1} << 30;
  return static_cast<size_t>(std::min(physical_bytes / kShare, kMost));
}

Document::Document(Fabric fabric, std::string file, size_t mostBytes) : mostBytes_(mostBytes), file_(std::move(file)) {
  push({std::make_shared<const Fabric>(std::move(fabric)), 0, {}, 0});
  look();
}

Document Document::unsaved(Fabric fabric) {
  Document document(std::move(fabric));
  document.savedState_ = document.nextId_++;  // which no state will ever have
  document.revision_ = 1;                     // as after an edit: a copy of it is to be kept
  return document;
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
  if (judgedUnder_) {
    const auto own = lampOf(cloth()->light);
    if (lampOf(fabric.light) == lampOf(seen_->light)) {
      lampOf(fabric.light) = own;
    } else if (lampOf(fabric.light) != own) {
      judgedUnder_.reset();
    } else if (fabric == *cloth()) {  // its own lamp was wanted, and nothing else
      return judgeUnder(std::nullopt);
    }
  }
  ++revision_;
  const bool continues = gesture == gesture_ && now_ > 0 && !canRedo();
  gesture_ = gesture;
  const EditPlace first = continues ? steps_[now_].place : place;
  for (const size_t kept = continues ? now_ : now_ + 1; steps_.size() > kept; steps_.pop_back())
    bytes_ -= steps_.back().bytes;
  push({std::make_shared<const Fabric>(std::move(fabric)), nextId_++, first, 0});
  look();
}

/// The cloth under the lamp that it is judged by.
void Document::look() {
  seen_ = cloth();
  if (!judgedUnder_) return;
  auto lit = std::make_shared<Fabric>(*seen_);
  lit->light = underLamp(lit->light, *judgedUnder_);
  seen_ = std::move(lit);
}

void Document::lookFrom(const Camera& camera) {
  keepAsLookedAt(seenFrom(cloth(), camera, cloth()->render));
}

void Document::judgeUnder(std::optional<StandardIlluminant> lamp) {
  if (judgedUnder_ == lamp) return;
  judgedUnder_ = lamp;
  look();
}

void Document::renderAs(const RenderSettings& settings) {
  if (cloth()->render == settings) return;
  auto sized = std::make_shared<Fabric>(*cloth());
  sized->render = settings;
  keepAsLookedAt(std::move(sized));
}

void Document::keepAsLookedAt(std::shared_ptr<const Fabric> fabric) {
  if (fabric == cloth()) return;
  steps_[now_].fabric = std::move(fabric);
  look();
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
  // Undo takes back what was done to the cloth, not how one looks at it: from where, by which lamp, in which picture.
  const std::shared_ptr<const Fabric> before = cloth();
  now_ = step;
  steps_[now_].fabric = seenFrom(cloth(), before->camera, before->render);
  look();
  gesture_ = 0;
  ++revision_;
}

void Document::savedAs(const std::string& file, uint64_t state) {
  file_ = file;
  savedState_ = state;
  gesture_ = 0;  // the next edit is a step of its own, so that undo returns to what was saved
}

}  // namespace loomlight
