#include <utility>

#include "app/editor/session.h"

namespace loomlight {

void Session::follow() {
  shelf_.follow();
  sidePictures_.follow();
  presetDesk_.follow();
  presetDesk_.take();
  hearOfPresets();
  followColour();
  views_.follow(sight());
  keepCopy();
}

Sight Session::sight() const {
  Sight sight;
  sight.fabric = document_.fabric();
  sight.width = viewport_.width;
  sight.height = viewport_.height;
  sight.denoised = viewport_.denoised;
  const LensView& lens = viewport_.lens;
  if (lens.on && lens.placed)
    sight.lens = {{lens.rect.x, lens.rect.y, lens.rect.width, lens.rect.height}, 1e9 * settings_.fibreMemory_GB};
  sight.yarn = inspector_.yarn;
  sight.visibilityShown = inspector_.visibilityShown && settings_.desk.panelsShown;
  return sight;
}

/// Unsaved work outlives the program.
void Session::keepCopy() {
  if (document_.revision() == keptRevision_) return;
  keptRevision_ = document_.revision();
  if (document_.isDirty())
    autosave_.keep(document_.fabric());
  else
    autosave_.forget();
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
