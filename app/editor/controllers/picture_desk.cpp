#include "app/editor/controllers/picture_desk.h"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <new>
#include <utility>

#include "core/fabric/weave/draft_edit.h"

namespace loomlight {

namespace {

/// Null where it is no longer wanted.
std::shared_ptr<const PictureSource> sourceOf(const std::string& file, const std::function<bool()>& stillWanted) {
  auto source = std::make_shared<PictureSource>();
  source->name = std::filesystem::path(file).filename().string();
  const Pixels8 pixels = readPng(file);
  if (!stillWanted()) return nullptr;
  source->raster = rasterOf(pixels);
  source->colours = coloursOf(source->raster);
  source->small = reducedTo(source->raster, PictureSource::kSmallSide);
  return source;
}

}  // namespace

PictureDesk::PictureDesk(std::function<void()> wake) : fetcher_(std::move(wake)) {}

void PictureDesk::ask(std::function<Result(const StillWanted&)> work) {
  fetcher_.ask([work = std::move(work)](const StillWanted& stillWanted) {
    Result result;
    try {
      result = work(stillWanted);
    } catch (const std::bad_alloc&) {
      result.problem = "It needs more memory than there is.";
    } catch (const std::exception& error) {
      result.problem = error.what();
    }
    return result;
  });
}

void PictureDesk::read(const std::string& file) {
  ask([file](const StillWanted& stillWanted) {
    Result result;
    result.source = sourceOf(file, stillWanted);
    return result;
  });
}

void PictureDesk::weave(PictureOrder order, std::shared_ptr<const Fabric> fabric, const LoomLimits& limits) {
  ask([order = std::move(order), fabric = std::move(fabric), limits](const StillWanted&) {
    const Raster threads = resampled(order.source->raster, order.ends, order.picks);
    Result result;
    result.woven = rewoven(*fabric, weaveOf(reduced(threads, order.palette), order.structures), limits);
    return result;
  });
}

}  // namespace loomlight
