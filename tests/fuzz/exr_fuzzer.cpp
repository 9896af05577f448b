#include "app/export/picture_part.h"
#include "render/film/image.h"
#include "tests/fuzz/finding.h"
#include "tests/fuzz/fuzzers.h"
#include "tests/fuzz/input_file.h"

namespace loomlight::fuzz {

void fuzzExr(std::string_view bytes) {
  static const InputFile input(".exr");
  const std::string& name = input.holding(bytes);
  // How large a picture says it is costs nothing; a run of one that is huge would be all about clearing memory.
  constexpr int64_t kMostValues = 1 << 22;
  PictureExtent extent;
  if (!isRead(name, [&] { extent = readExrExtent(name); })) return;
  expect(extent.width > 0 && extent.height > 0, "a picture without pixels");
  isRead(name, [&] { readExrTexts(name); });
  isRead(name, [&] { readPartInfo(name); });
  if (int64_t{extent.width} * extent.height * extent.channels > kMostValues) return;
  isRead(name, [&] {
    const Image image = readExr(name);
    expect(image.width == extent.width && image.height == extent.height, "a picture has another size");
    for (const Image::Channel& channel : image.channels)
      expect(channel.values.size() == static_cast<size_t>(image.width) * image.height, "a channel has another size");
  });
}

}  // namespace loomlight::fuzz
