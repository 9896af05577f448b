#include "app/editor/session.h"

#include "app/editor/model/sample_fabric.h"
#include "app/editor/model/user_folders.h"

namespace loomlight {

Session::Session(Document document, Settings settings, DisplayDriver& driver, std::function<void()> wake, int threads)
    : settings_(std::move(settings)),
      document_(std::move(document)),
      wake_(std::move(wake)),
      sampleNames_(sampleNames()),
      autosave_(stateFolder(), wake_),
      colours_(wake_),
      sidePictures_(driver, wake_),
      shelf_(viewFolder(), driver, wake_),
      presetDesk_(presetFolder(), driver, wake_),
      views_(driver, wake_, threads),
      files_(wake_),
      previews_(driver, wake_),
      pictures_(wake_) {
  hints_.wanted = !settings_.hintsSeen;
  const ViewSettings& view = settings_.view;
  viewport_.denoised = view.denoised;
  viewport_.filmic = view.filmic;
  viewport_.exposure_stops = view.exposure_stops;
  draft_.inColour = view.draftInColour;
  draft_.back = view.draftBack;
  draft_.marksFloats = view.marksFloats;
  snapshotDialog_.setOptions(settings_.snapshot);
  if (!document_.file().empty()) remember(document_.file());
}

void Session::keepSettings() {
  settings_.hintsSeen = !hints_.wanted;
  settings_.view = {viewport_.denoised, viewport_.filmic, viewport_.exposure_stops,
                    draft_.inColour,    draft_.back,      draft_.marksFloats};
  settings_.snapshot = snapshotDialog_.options();
}

std::string Session::title() const {
  return document_.fabric()->name + (document_.isDirty() ? " (edited)" : "") + " - Loomlight";
}

Tone Session::tone() const {
  Tone tone;
  tone.exposure_stops = static_cast<float>(viewport_.exposure_stops);
  tone.filmic = viewport_.filmic;
  return tone;
}

bool Session::dialogIsOpen() const {
  return files_.busy() || browser_.isOpen() || message_.isOpen() || snapshotDialog_.isOpen() || preferences_.isOpen() ||
         keys_.isOpen() || wifDialog_.isOpen() || structures_.isOpen() || pictureDialog_.isOpen() ||
         tileDialog_.isOpen() || colourways_.isOpen() || compare_.isOpen() || presetBrowser_.isOpen();
}

}  // namespace loomlight
