#include "app/editor/controllers/snapshot_controller.h"

#include <fmt/core.h>

#include <utility>

#include "app/editor/model/picture_label.h"
#include "app/export/snapshot.h"
#include "core/base/units.h"
#include "core/fabric/model/height_seen.h"
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

/// Where it looks from, for as much cloth as is wanted.
Camera cameraOf(const Fabric& seen, const SnapshotOptions& options, const std::optional<glm::dvec2>& piece_mm) {
  const int width = seen.render.width, height = seen.render.height;
  if (options.scale == SnapshotScale::actualSize) return atScale(seen.camera, height, options.dpi / kMmPerInch);
  if (options.scale == SnapshotScale::wholePiece && piece_mm)
    return aboveFlat(seen.camera, piece_mm->x, piece_mm->y, static_cast<double>(width) / height);
  return seen.camera;
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

void SnapshotController::keepView(const Sight& now, const ViewService& seen) {
  viewToKeep_ = {now, {}, 0};
  followView(now, seen);
}

/// What is looked at may be another cloth, or the same from elsewhere, before the picture has taken its place.
void SnapshotController::followView(const Sight& now, const ViewService& seen) {
  ViewToKeep& view = viewToKeep_;
  if (!view.sight.isOf(now)) view = {};
  if (!view.sight.fabric || !seen.shows(view.sight.fabric, view.sight.view)) return;
  const Frame& frame = *seen.frame();
  constexpr int kWorthIt = 2;  // times the samples, to be seen
  if (view.id.empty())
    view.id = shelf_.keep(view.sight.cloth, view.sight.view, displayPicture(frame, view.sight.tone));
  else if (frame.samples > 0 && frame.samples >= kWorthIt * view.samples)
    shelf_.renew(view.id, displayPicture(frame, view.sight.tone));
  else
    return;
  view.samples = frame.samples;
}

void SnapshotController::follow(Ui& ui, const Sight& now, ViewService& seen) {
  shelf_.follow();
  if (rendering_.follow(ui, seen) == true) keepView(now, seen);
}

SnapshotController::Edit SnapshotController::drawDialog(Ui& ui, const Sight& now, ViewService& seen) {
  const std::string before = dialog_.file();
  ClothInView inView{heightSeen_mm(seen.asSeen(now.fabric)->camera)};
  if (now.view.flat) inView.piece_mm = now.view.flat->sight.piece_mm;
  const SnapshotDialog::Result result = dialog_.draw(ui, inView, rendering_.progress());
  if (result.settings || dialog_.file() != before) rendering_.forget();
  if (result.cancel) rendering_.cancel();
  if (result.start && !rendering_.isRunning()) {
    const auto edited = std::make_shared<Fabric>(*seen.asSeen(now.fabric));
    if (result.settings) edited->render = *result.settings;
    const SnapshotOptions& options = dialog_.options();
    edited->camera = cameraOf(*edited, options, inView.piece_mm);
    rendering_.start(
        [edited, file = dialog_.file(), tone = now.tone,
         print = printOf(dialog_.options(), *edited)](const Task& task) -> std::optional<std::string> {
          if (!writeSnapshot(edited, file, tone, print, task)) return std::nullopt;
          return fmt::format(words::snapshot::saved, file);
        },
        seen);
  }
  return {result.settings, result.chooseFile};
}

std::optional<SnapshotController::Restored> SnapshotController::drawStrip(Ui& ui, const Sight& now,
                                                                          const ViewService& seen) {
  const SnapshotStripEdit result = snapshotStrip(ui, shelf_.items(), strip_);
  if (result.keep) keepView(now, seen);
  std::optional<Restored> restored;
  if (result.restore) {
    const KeptView& kept = shelf_.view(*result.restore);
    restored = Restored{*kept.fabric, kept.lookedAt};
    restored->fabric.render = now.fabric->render;
  }
  if (result.compare) {
    shelf_.compare(result.compare->first, result.compare->second);
    compare_.show();
  }
  if (result.remove) shelf_.remove(*result.remove);
  return restored;
}

}  // namespace loomlight
