#include "app/editor/controllers/snapshot_controller.h"

#include <fmt/core.h>

#include <utility>

#include "app/editor/model/picture_label.h"
#include "app/export/snapshot.h"
#include "render/display/display_picture.h"
#include "render/scene/camera_rays.h"
#include "ui/words/picture_words.h"

namespace loomlight {
namespace {

/// Scale bar, caption and the size on paper, where they are wanted.
SnapshotPrint printOf(const SnapshotOptions& options, const Fabric& fabric) {
  SnapshotPrint print;
  if (options.inMillimetres) print.dpi = options.dpi;
  const PictureLabel label{options.scaleBar, options.caption};
  if (label.isEmpty()) return print;
  const CameraRays camera(fabric.camera, fabric.render.width, fabric.render.height);
  const double mm_per_pixel = camera.pixelSize_mm(static_cast<float>(fabric.camera.distance_mm));
  print.finish = [label, mm_per_pixel](const Pixels8& picture) { return labelled(picture, label, mm_per_pixel); };
  return print;
}

}  // namespace

void SnapshotController::show(const RenderSettings& settings, std::string file) {
  rendering_.forget();
  dialog_.show(settings, std::move(file));
}

void SnapshotController::setFile(const std::string& file) {
  dialog_.setFile(file);
  rendering_.forget();
}

void SnapshotController::keepView(const std::shared_ptr<const Fabric>& fabric, const Tone& tone,
                                  const ViewService& seen) {
  viewToKeep_ = {fabric, tone, {}, 0};
  followView(fabric, seen);
}

/// An edit that comes before the picture has taken its place.
void SnapshotController::followView(const std::shared_ptr<const Fabric>& fabric, const ViewService& seen) {
  ViewToKeep& view = viewToKeep_;
  if (view.fabric != fabric) view = {};
  if (!view.fabric || !seen.shows(view.fabric)) return;
  const Frame& frame = *seen.frame();
  constexpr int kWorthIt = 2;  // times the samples, to be seen
  if (view.id.empty())
    view.id = shelf_.keep(view.fabric, displayPicture(frame, view.tone));
  else if (frame.samples > 0 && frame.samples >= kWorthIt * view.samples)
    shelf_.renew(view.id, displayPicture(frame, view.tone));
  else
    return;
  view.samples = frame.samples;
}

SnapshotController::Edit SnapshotController::drawDialog(Ui& ui, const std::shared_ptr<const Fabric>& fabric,
                                                        const Tone& tone, ViewService& seen) {
  if (rendering_.isRunning()) ui.wakeWithin(0.1);
  if (const auto written = rendering_.follow()) {
    seen.pause(false);
    if (*written) keepView(fabric, tone, seen);
  }
  const std::string before = dialog_.file();
  const SnapshotDialog::Result result =
      dialog_.draw(ui, heightSeen_mm(seen.asSeen(fabric)->camera), rendering_.progress());
  if (result.settings || dialog_.file() != before) rendering_.forget();
  if (result.cancel) rendering_.cancel();
  if (result.start && !rendering_.isRunning()) {
    const auto edited = std::make_shared<Fabric>(*seen.asSeen(fabric));
    if (result.settings) edited->render = *result.settings;
    const SnapshotOptions& options = dialog_.options();
    constexpr double kMmPerInch = 25.4;
    if (options.actualSize) edited->camera = atScale(edited->camera, edited->render.height, options.dpi / kMmPerInch);
    seen.pause(true);
    rendering_.start([edited, file = dialog_.file(), tone,
                      print = printOf(dialog_.options(), *edited)](const Task& task) -> std::optional<std::string> {
      if (!writeSnapshot(edited, file, tone, print, task)) return std::nullopt;
      return fmt::format(words::snapshot::saved, file);
    });
  }
  return {result.settings, result.chooseFile};
}

std::optional<Fabric> SnapshotController::drawStrip(Ui& ui, const std::shared_ptr<const Fabric>& fabric,
                                                    const Tone& tone, const ViewService& seen) {
  const SnapshotStripEdit result = snapshotStrip(ui, shelf_.items(), strip_);
  if (result.keep) keepView(fabric, tone, seen);
  std::optional<Fabric> restored;
  if (result.restore) {
    restored = shelf_.fabric(static_cast<size_t>(*result.restore));
    restored->render = fabric->render;
  }
  if (result.compare) {
    shelf_.compare(static_cast<size_t>(result.compare->first), static_cast<size_t>(result.compare->second));
    compare_.show();
  }
  if (result.remove) {
    shelf_.remove(static_cast<size_t>(*result.remove));
    strip_.chosen.clear();
  }
  return restored;
}

}  // namespace loomlight
