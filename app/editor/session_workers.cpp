#include <utility>

#include "app/editor/session.h"

namespace loomlight {

void Session::takePictures() {
  if (std::shared_ptr<const Frame> newest = renderer_.frame(); newest && newest != shownFrame_) {
    picture_.upload(newest->width, newest->height, newest->shown(), newest->hits);
    shownFrame_ = std::move(newest);
    followViewToKeep();
  }
  lensFrame_ = renderer_.lensFrame();
  if (lensFrame_) {
    const Difference* difference = viewport_.lens.showsDifference ? lensFrame_->difference.get() : nullptr;
    const void* wanted = difference ? static_cast<const void*>(difference) : lensFrame_->fibres.get();
    if (wanted != lensUpload_ && difference)
      lensPicture_.upload(difference->width, difference->height, difference->map, {});
    else if (wanted != lensUpload_)
      lensPicture_.upload(lensFrame_->fibres->width, lensFrame_->fibres->height, lensFrame_->fibres->rgba, {});
    lensUpload_ = wanted;
  }
  if (auto newest = visibility_.newest(); newest && newest != shownVisibility_) {
    visibilityPicture_.upload(newest->picture);
    shownVisibility_ = std::move(newest);
  }
}

void Session::follow() {
  shelf_.follow();
  sidePictures_.follow();
  presetDesk_.follow();
  followColour();
  followVisibility();
  followDocument();
  followLens();
}

void Session::followDocument() {
  const std::shared_ptr<const Fabric>& fabric = document_.fabric();
  // Early tables are good enough to begin with; the picture goes over to better ones as they come.
  const RenderSettings& render = fabric->render;
  const std::shared_ptr<const BakedVisibility> baked = visibility_.newest();
  const bool reports = render.method == Method::volume && render.estimator == Estimator::report;
  const bool better = reports && baked && (!usedVisibility_ || worthTaking(*baked, *usedVisibility_));
  const bool another =
      fabric != requested_ || viewport_.width != requestedWidth_ || viewport_.height != requestedHeight_;
  if (another || better) {
    requested_ = fabric;
    requestedWidth_ = viewport_.width;
    requestedHeight_ = viewport_.height;
    if (better) usedVisibility_ = baked;
    if (another) ++generation_;
    renderer_.request(
        {fabric, requestedWidth_, requestedHeight_, generation_, usedVisibility_ ? usedVisibility_->tables : nullptr});
  }
  if (viewport_.denoised != denoisedWanted_) {
    denoisedWanted_ = viewport_.denoised;
    renderer_.denoise(denoisedWanted_);
  }
  if (fabric != insightFabric_ || inspector_.yarn != insightYarn_) {
    insightFabric_ = fabric;
    insightYarn_ = inspector_.yarn;
    insightWorker_.request(fabric, inspector_.yarn);
  }
  if (document_.revision() == keptRevision_) return;
  keptRevision_ = document_.revision();
  if (document_.isDirty()) {
    autosave_.keep(fabric);
  } else {
    autosave_.forget();
  }
}

void Session::followLens() {
  std::optional<LensRequest> wanted;
  const LensView& lens = viewport_.lens;
  if (lens.on && lens.placed)
    wanted = LensRequest{{lens.rect.x, lens.rect.y, lens.rect.width, lens.rect.height}, 1e9 * settings_.fibreMemory_GB};
  if (wanted == requestedLens_) return;
  requestedLens_ = wanted;
  renderer_.lens(wanted);
}

/// Tables are baked while somebody looks at them or the picture needs them.
void Session::followVisibility() {
  const std::shared_ptr<const Fabric>& fabric = document_.fabric();
  const RenderSettings& render = fabric->render;
  const bool needed = render.method == Method::volume && render.estimator == Estimator::report;
  const bool seen = inspector_.visibilityShown && settings_.desk.panelsShown;
  const std::shared_ptr<const Fabric> wanted = needed || seen ? fabric : nullptr;
  if (wanted == visibilityFabric_ && (!wanted || inspector_.yarn == visibilityYarn_)) return;
  visibilityFabric_ = wanted;
  visibilityYarn_ = inspector_.yarn;
  visibility_.request(wanted, inspector_.yarn);
}

/// A colour that was asked for arrives later than the gesture that asked for it, and is still one step of undo with it.
void Session::followColour() {
  if (inspector_.page != InspectorView::Page::fibre || !settings_.desk.panelsShown) return;
  const std::shared_ptr<const Fabric>& fabric = document_.fabric();
  if (colourWish_ != inspector_.clothColour.wish) colourGesture_ = gesture_;
  colourWish_ = inspector_.clothColour.wish;
  auto dyed = colours_.follow(fabric, shownFibre(*fabric, inspector_), inspector_.clothColour);
  if (!dyed) return;
  const uint64_t now = std::exchange(gesture_, colourGesture_);
  edit(std::move(*dyed));
  gesture_ = now;
}

}  // namespace loomlight
