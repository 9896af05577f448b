#include <zlib.h>

#include "render/film/image.h"
#include "tests/fuzz/finding.h"
#include "tests/fuzz/fuzzers.h"
#include "tests/fuzz/input_file.h"

namespace loomlight::fuzz {
namespace {

uint32_t bigEndian(std::string_view bytes) {
  uint32_t number = 0;
  for (const char byte : bytes.substr(0, 4)) number = number << 8 | static_cast<uint8_t>(byte);
  return number;
}

/// Every chunk has a sum of its bytes, which turns away all that is changed by chance: here it is made good.
std::string withSums(std::string_view bytes) {
  constexpr size_t kSignature = 8, kBeside = 12;  // its length and its name before a chunk, its sum behind it
  std::string png(bytes);
  for (size_t at = kSignature; at + kBeside <= png.size();) {
    const size_t length = bigEndian(std::string_view(png).substr(at));
    if (length > png.size() - at - kBeside) break;
    const uLong sum = crc32(0, reinterpret_cast<const Bytef*>(png.data() + at + 4), static_cast<uInt>(length + 4));
    for (size_t i = 0; i < 4; ++i) png[at + 8 + length + i] = static_cast<char>(sum >> (24 - 8 * i));
    at += length + kBeside;
  }
  return png;
}

}  // namespace

void fuzzPng(std::string_view bytes) {
  static const InputFile input(".png");
  const std::string& name = input.holding(withSums(bytes));
  constexpr int64_t kMostPixels = 1 << 20;
  PictureExtent extent;
  if (!isRead(name, [&] { extent = readPngExtent(name); })) return;
  expect(extent.width > 0 && extent.height > 0, "a picture without pixels");
  if (int64_t{extent.width} * extent.height > kMostPixels) return;
  isRead(name, [&] {
    std::map<std::string, std::string> texts;
    const Pixels8 pixels = readPng(name, &texts);
    expect(pixels.bytes.size() == static_cast<size_t>(pixels.width) * pixels.height * pixels.channels,
           "a picture has another size");
  });
}

}  // namespace loomlight::fuzz
