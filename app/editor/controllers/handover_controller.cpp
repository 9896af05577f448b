#include "app/editor/controllers/handover_controller.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/export/handover/cloth_handover.h"
#include "app/export/task_part.h"
#include "render/transport/make_medium.h"
#include "ui/words/dialog_words.h"

namespace loomlight {
namespace {

/// What was written, in words; nothing where it was stopped before any was.
std::optional<std::string> handOverAll(const std::vector<HandoverPart>& parts, const DigitalClothOrder& order,
                                       const Task& task) {
  const auto whole = static_cast<double>(parts.size());
  size_t files = 0;
  double front_percent = 0, back_percent = 0;  // of the colourway that is furthest off
  for (size_t done = 0; done < parts.size(); ++done) {
    const double from = static_cast<double>(done) / whole;
    const auto report = handOver(parts[done], order, defaultMemoryLimit_bytes(), partOf(task, from, from + 1 / whole));
    if (!report && done == 0) return std::nullopt;
    if (!report) return fmt::format(words::handover::cancelled, done, parts.size());
    files += report->files.size();
    front_percent = std::max(front_percent, report->front_percent);
    back_percent = std::max(back_percent, report->back_percent);
  }
  return fmt::format(words::handover::written, files, front_percent, back_percent, parts.front().folder);
}

}  // namespace

void HandoverController::show(std::string folder, const std::shared_ptr<const Fabric>& fabric) {
  rendering_.forget();
  sizes_.ask(fabric);
  dialog_.show(std::move(folder));
}

void HandoverController::setFolder(const std::string& folder) {
  dialog_.setFolder(folder);
  rendering_.forget();
}

RenderService::Work HandoverController::workOn(const Fabric& fabric) const {
  Fabric sampled = fabric;
  sampled.render.samplesPerPixel = dialog_.samplesPerPixel();
  DigitalClothOrder order;
  order.longestSide = dialog_.longestSide();
  order.joinTwist = dialog_.joinsTwist();
  order.measuringSamples = dialog_.measuringSamples();
  return [parts = handoverParts(sampled, dialog_.folder(), dialog_.allColourways()), order](const Task& task) {
    return handOverAll(parts, order, task);
  };
}

void HandoverController::follow(Ui& ui, ViewService& seen) {
  rendering_.follow(ui, seen);
}

bool HandoverController::draw(Ui& ui, const Fabric& fabric, ViewService& seen) {
  if (!dialog_.isOpen()) return false;
  HandoverModel model;
  model.tile = sizes_.newest();
  model.fewestPixels = kFewestPixelsPerYarn;
  model.colourways = static_cast<int>(fabric.colourways.size());
  const std::string before = dialog_.folder();
  if (!before.empty()) model.sidecar = handoverSidecar(fabric, before);
  const HandoverDialog::Result result = dialog_.draw(ui, model, rendering_.progress());
  if (dialog_.folder() != before) rendering_.forget();
  if (result.cancel) rendering_.cancel();
  if (!result.start || rendering_.isRunning()) return result.chooseFolder;
  rendering_.start(workOn(fabric), seen);
  return result.chooseFolder;
}

}  // namespace loomlight
