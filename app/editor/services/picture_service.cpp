#include "app/editor/services/picture_service.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "app/export/draft_picture.h"
#include "core/fabric/weave/draft_edit.h"
#include "core/fabric/weave/weave_edit.h"

namespace loomlight {
namespace {

/// Null where it is no longer wanted.
std::shared_ptr<const PictureSource> sourceOf(const std::string& file, const std::stop_token& stop) {
  auto source = std::make_shared<PictureSource>();
  source->name = std::filesystem::path(file).filename().string();
  const Pixels8 pixels = readPng(file);
  if (stop.stop_requested()) return nullptr;
  source->raster = rasterOf(pixels);
  source->colours = coloursOf(source->raster);
  source->small = reducedTo(source->raster, PictureSource::kSmallSide);
  return source;
}

/// The fabric's weave with the picture in it.
Weave weaveWith(const PictureOrder& order, const Fabric& fabric) {
  const Raster crossings = resampled(order.source->raster, order.ends, order.picks);
  Weave weave = weaveOf(reduced(crossings, order.palette), order.structures);
  if (!order.into) return weave;
  return withPart(fabric.weave, order.into->pick, order.into->end, weave);
}

}  // namespace

PictureService::PictureService(std::function<void()> wake)
    : worker_(
          wake, [](const auto& work, const auto& job) { return work(job.stop()); },
          [](const auto&, const std::string& problem) { return Result{nullptr, std::nullopt, problem}; },
          Backlog::hanging),
      previews_(
          std::move(wake), [](const auto& work, const auto&) { return work(); },
          [](const auto&, const std::string&) { return Pixels8{}; }, Backlog::newest, Priority::picture) {}

void PictureService::read(const std::string& file) {
  worker_.ask([file](const std::stop_token& stop) { return Result{sourceOf(file, stop), std::nullopt, ""}; });
}

void PictureService::weave(PictureOrder order, std::shared_ptr<const Fabric> fabric, const LoomLimits& limits) {
  worker_.ask([order = std::move(order), fabric = std::move(fabric), limits](const std::stop_token&) {
    Result result;
    result.fillsSelection = order.into.has_value();
    result.woven = rewoven(*fabric, weaveWith(order, *fabric), limits);
    return result;
  });
}

void PictureService::preview(PictureOrder order, std::shared_ptr<const Fabric> fabric, std::vector<Rgb> yarnColours,
                             int side) {
  previews_.ask([order = std::move(order), fabric = std::move(fabric), colours = std::move(yarnColours), side] {
    constexpr int kMostYarns = 2048;  // several for each pixel
    PictureOrder shown = order;
    if (!order.into) {
      const double fewer = std::min(1.0, static_cast<double>(kMostYarns) / std::max(order.ends, order.picks));
      shown.ends = std::max(1, static_cast<int>(fewer * order.ends));
      shown.picks = std::max(1, static_cast<int>(fewer * order.picks));
    }
    Fabric cloth = *fabric;
    cloth.draft.reset();
    cloth.weave = weaveWith(shown, *fabric);
    return draftPicture(cloth, colours, side, side);
  });
}

std::optional<Pixels8> PictureService::takePreview() {
  auto picture = previews_.take();
  if (picture && picture->bytes.empty()) picture.reset();
  return picture;
}

}  // namespace loomlight
