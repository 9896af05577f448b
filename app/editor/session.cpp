#include "app/editor/session.h"

#include "app/editor/sample_fabric.h"
#include "app/editor/user_folders.h"

namespace loomlight {

Session::Session(Document document, Settings settings, std::function<void()> wake, int threads)
    : settings_(std::move(settings)),
      document_(std::move(document)),
      wake_(std::move(wake)),
      presets_(presetFolder()),
      sampleNames_(sampleNames()),
      autosave_(stateFolder()),
      insightWorker_(wake_),
      renderer_(wake_, threads) {}

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
  return browser_.isOpen() || message_.isOpen() || snapshotDialog_.isOpen() || keys_.isOpen();
}

void Session::followDocument() {
  const std::shared_ptr<const Fabric>& fabric = document_.fabric();
  if (fabric != requested_ || viewport_.width != requestedWidth_ || viewport_.height != requestedHeight_) {
    requested_ = fabric;
    requestedWidth_ = viewport_.width;
    requestedHeight_ = viewport_.height;
    renderer_.request({fabric, requestedWidth_, requestedHeight_, ++generation_});
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

}  // namespace loomlight
