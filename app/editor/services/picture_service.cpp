#include "app/editor/services/picture_service.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "core/fabric/weave/draft_edit.h"

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

}  // namespace

PictureService::PictureService(std::function<void()> wake)
    : worker_(
          std::move(wake), [](const auto& work, const auto& turn) { return work(turn.stop()); },
          [](const auto&, const std::string& problem) { return Result{nullptr, std::nullopt, problem}; },
          Backlog::hanging) {}

void PictureService::read(const std::string& file) {
  worker_.ask([file](const std::stop_token& stop) { return Result{sourceOf(file, stop), std::nullopt, ""}; });
}

void PictureService::weave(PictureOrder order, std::shared_ptr<const Fabric> fabric, const LoomLimits& limits) {
  worker_.ask([order = std::move(order), fabric = std::move(fabric), limits](const std::stop_token&) {
    const Raster threads = resampled(order.source->raster, order.ends, order.picks);
    Result result;
    result.woven = rewoven(*fabric, weaveOf(reduced(threads, order.palette), order.structures), limits);
    return result;
  });
}

}  // namespace loomlight
