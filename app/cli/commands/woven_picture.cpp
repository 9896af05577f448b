#include "app/cli/commands/woven_picture.h"

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/text.h"
#include "render/display/raster.h"

namespace loomlight {

WovenPicture readWovenPicture(const std::string& file, const std::vector<Weave>& structures,
                              const std::optional<PictureSize>& repeat) {
  if (lowerExtension(file) != ".png") throw InputError(file + ": expected a picture (.png), whose colours are woven");
  const Raster raster = rasterOf(readPng(file));
  const PictureSize size = repeat.value_or(PictureSize{raster.width, raster.height});
  if (size.width > Weave::kMaxSide || size.height > Weave::kMaxSide)
    throw InputError(fmt::format("{}: expected at most {} crossings each way, got {} x {}: --repeat says how many",
                                 file, Weave::kMaxSide, size.width, size.height));
  // Of the picture as it was drawn: scaled, it has colours between its own.
  std::vector<Rgb8> palette = paletteOf(coloursOf(raster), static_cast<int>(structures.size()));
  if (palette.size() < structures.size())
    throw InputError(fmt::format("{}: expected {} colours, one for each structure, got {}", file, structures.size(),
                                 palette.size()));
  WovenPicture woven;
  woven.picture = reduced(resampled(raster, size.width, size.height), std::move(palette));
  woven.weave = weaveOf(woven.picture, structures);
  return woven;
}

}  // namespace loomlight
