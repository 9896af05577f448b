#include <algorithm>
#include <utility>

#include "app/editor/model/picture_label.h"
#include "app/editor/session.h"
#include "render/display/display_picture.h"
#include "render/scene/camera_rays.h"

namespace loomlight {

/// Kept once there is a picture of the cloth itself, and as long as it is seen, better and better.
void Session::keepView() {
  viewToKeep_ = {document_.fabric(), tone(), {}, 0};
  followViewToKeep();
}

/// An edit that comes before the picture has taken its place.
void Session::followViewToKeep() {
  ViewToKeep& view = viewToKeep_;
  if (view.fabric != document_.fabric()) view = {};
  if (!view.fabric || !views_.shows(view.fabric)) return;
  const Frame& frame = *views_.frame();
  constexpr int kWorthIt = 2;  // times the samples, to be seen
  if (view.id.empty())
    view.id = shelf_.keep(view.fabric, displayPicture(frame, view.tone));
  else if (frame.samples > 0 && frame.samples >= kWorthIt * view.samples)
    shelf_.renew(view.id, displayPicture(frame, view.tone));
  else
    return;
  view.samples = frame.samples;
}

/// Scale bar, caption and the size on paper, where they are wanted.
SnapshotPrint Session::printOfSnapshot() const {
  const SnapshotOptions& options = snapshotDialog_.options();
  SnapshotPrint print;
  if (options.inMillimetres) print.dpi = options.dpi;
  const PictureLabel label{options.scaleBar, options.caption};
  if (label.isEmpty()) return print;
  const Fabric& fabric = *document_.fabric();
  const CameraRays camera(fabric.camera, fabric.render.width, fabric.render.height);
  const double mm_per_pixel = camera.pixelSize_mm(static_cast<float>(fabric.camera.distance_mm));
  print.finish = [label, mm_per_pixel](const Pixels8& picture) { return labelled(picture, label, mm_per_pixel); };
  return print;
}

void Session::drawSnapshot(Ui& ui) {
  if (snapshot_.isRunning()) ui.wakeWithin(0.1);
  if (const auto written = snapshot_.follow()) {
    views_.pause(false);
    if (*written) keepView();
  }
  const std::string before = snapshotDialog_.file();
  const SnapshotDialog::Result result = snapshotDialog_.draw(ui, snapshot_.progress());
  if (result.settings || snapshotDialog_.file() != before) snapshot_.forget();
  if (result.settings) {
    Fabric fabric = *document_.fabric();
    fabric.render = *result.settings;
    edit(std::move(fabric));
  }
  if (result.chooseFile) browse(FileTask::snapshot);
  if (result.cancel) snapshot_.cancel();
  if (!result.start || snapshot_.isRunning()) return;
  views_.pause(true);
  snapshot_.start([fabric = document_.fabric(), file = snapshotDialog_.file(), tone = tone(),
                   print = printOfSnapshot()](const Task& task) -> std::optional<std::string> {
    if (!writeSnapshot(fabric, file, tone, print, task)) return std::nullopt;
    return "Saved " + file;
  });
}

void Session::restoreView(size_t index) {
  Fabric fabric = shelf_.fabric(index);
  fabric.render = document_.fabric()->render;
  edit(std::move(fabric));
  draft_.cell = 0;
}

void Session::drawStrip(Ui& ui) {
  const SnapshotStripEdit result = snapshotStrip(ui, shelf_.items(), strip_);
  if (result.keep) keepView();
  if (result.restore) restoreView(static_cast<size_t>(*result.restore));
  if (result.compare) {
    shelf_.compare(static_cast<size_t>(result.compare->first), static_cast<size_t>(result.compare->second));
    compare_.show();
  }
  if (!result.remove) return;
  shelf_.remove(static_cast<size_t>(*result.remove));
  strip_.chosen.clear();
}

}  // namespace loomlight
