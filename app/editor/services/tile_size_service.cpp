#include "app/editor/services/tile_size_service.h"

#include <utility>

#include "app/export/tile.h"

namespace loomlight {
namespace {

TileSize sizeOf(const Fabric& fabric, const TileExtent& extent) {
  TileSize size;
  size.ends = extent.ends;
  size.picks = extent.picks;
  size.repeatsAcross = extent.ends / fabric.weave.ends();
  size.repeatsDown = extent.picks / fabric.weave.picks();
  size.width_mm = extent.ends * fabric.warpPitch_mm();
  size.height_mm = extent.picks * fabric.weftPitch_mm();
  size.yarnsAlongLonger = 1 / pixelsPerYarn(fabric, extent, 1);
  size.usualSide = usualTileSide(fabric, extent);
  return size;
}

}  // namespace

TileSizeService::TileSizeService(std::function<void()> wake)
    : worker_(
          std::move(wake),
          [](const std::shared_ptr<const Fabric>& fabric, const auto&) {
            const TileExtent joined = tileExtent(*fabric), plain = tileExtent(*fabric, false);
            return TileModel{sizeOf(*fabric, joined), sizeOf(*fabric, plain), {}};
          },
          [](const std::shared_ptr<const Fabric>&, const std::string& problem) {
            return TileModel{std::nullopt, std::nullopt, problem};
          }) {}

void TileSizeService::ask(const std::shared_ptr<const Fabric>& fabric) {
  worker_.forget();
  worker_.ask(fabric);
}

}  // namespace loomlight
