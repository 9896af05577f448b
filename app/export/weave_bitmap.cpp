#include "app/export/weave_bitmap.h"

#include <fmt/format.h>

#include "app/export/loom_bitmap.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "render/film/image.h"

namespace loomlight {

Weave readWeaveBitmap(const std::string& file) {
  const Pixels8 pixels = readPng(file);
  if (pixels.width < 1 || pixels.height < 1 || pixels.width > Weave::kMaxSide || pixels.height > Weave::kMaxSide)
    throw InputError(
        fmt::format("{}: expected a weave of 1 to {} crossings each way, one pixel a crossing, got {} x {}", file,
                    Weave::kMaxSide, pixels.width, pixels.height));
  const int colours = std::min(3, pixels.channels);  // without alpha
  std::vector<std::vector<uint8_t>> rows(pixels.height, std::vector<uint8_t>(pixels.width));
  for (int y = 0; y < pixels.height; ++y)
    for (int x = 0; x < pixels.width; ++x) {
      const uint8_t* pixel = &pixels.bytes[(static_cast<size_t>(y) * pixels.width + x) * pixels.channels];
      int sum = 0;
      for (int c = 0; c < colours; ++c) sum += pixel[c];
      rows[pixels.height - 1 - y][x] = sum < 128 * colours;
    }
  return Weave(rows);
}

namespace {

Pixels8 pixelsOf(const Weave& weave) {
  Pixels8 pixels;
  pixels.width = weave.ends();
  pixels.height = weave.picks();
  pixels.channels = 3;
  pixels.bytes.reserve(static_cast<size_t>(pixels.width) * pixels.height * 3);
  for (int pick = weave.picks() - 1; pick >= 0; --pick)
    for (const uint8_t over : weave.row(pick)) pixels.bytes.insert(pixels.bytes.end(), 3, over ? 0 : 255);
  return pixels;
}

}  // namespace

void writeWeaveBitmap(const std::string& file, const Fabric& fabric) {
  const std::string extension = lowerExtension(file);
  if (extension == ".png")
    writePng(file, pixelsOf(fabric.weave));
  else if (extension == ".tif" || extension == ".tiff")
    writeFileAtomically(file, tiffOf(fabric));
  else if (extension == ".bmp")
    writeFileAtomically(file, bmpOf(fabric));
  else
    throw InputError(file + ": expected the name of a weave bitmap that ends in .png, .tif, .tiff or .bmp");
}

}  // namespace loomlight
