#include "app/export/loom_bitmap.h"

#include <cmath>
#include <cstdint>

#include "core/base/little_endian.h"

namespace loomlight {
namespace {

size_t bytesOfRow(const Weave& weave, size_t multiple) {
  const size_t bytes = (static_cast<size_t>(weave.ends()) + 7) / 8;
  return (bytes + multiple - 1) / multiple * multiple;
}

/// The ends of a pick from the left, the first in the highest bit; set where they are raised.
std::string bitsOf(const Weave& weave, int pick, size_t length) {
  std::string bits(length, '\0');
  for (size_t end = 0; const uint8_t over : weave.row(pick)) {
    if (over) bits[end / 8] = static_cast<char>(static_cast<uint8_t>(bits[end / 8]) | 0x80u >> (end % 8));
    ++end;
  }
  return bits;
}

}  // namespace

std::string tiffOf(const Fabric& fabric) {
  const Weave& weave = fabric.weave;
  const size_t length = bytesOfRow(weave, 1);
  constexpr unsigned kShort = 3, kLong = 4, kRational = 5, kEntries = 12;
  constexpr size_t kHeader = 8, kDirectory = 2 + kEntries * 12 + 4, kAcross = kHeader + kDirectory;
  constexpr size_t kDown = kAcross + 8, kPixels = kDown + 8;
  LittleEndian file;
  file.text("II").u16(42).u32(kHeader).u16(kEntries);
  const auto entry = [&](unsigned tag, unsigned type, size_t value) { file.u16(tag).u16(type).u32(1).u32(value); };
  entry(256, kLong, static_cast<size_t>(weave.ends()));            // ImageWidth
  entry(257, kLong, static_cast<size_t>(weave.picks()));           // ImageLength
  entry(258, kShort, 1);                                           // BitsPerSample
  entry(259, kShort, 1);                                           // Compression: none
  entry(262, kShort, 0);                                           // PhotometricInterpretation: 0 is white
  entry(273, kLong, kPixels);                                      // StripOffsets
  entry(274, kShort, 1);                                           // Orientation: from the top left
  entry(278, kLong, static_cast<size_t>(weave.picks()));           // RowsPerStrip
  entry(279, kLong, length * static_cast<size_t>(weave.picks()));  // StripByteCounts
  entry(282, kRational, kAcross);                                  // XResolution
  entry(283, kRational, kDown);                                    // YResolution
  entry(296, kShort, 3);                                           // ResolutionUnit: centimetre
  file.u32(0);
  for (const double per_cm : {fabric.ends_per_cm, fabric.picks_per_cm})
    file.u32(static_cast<size_t>(std::lround(1000 * per_cm))).u32(1000);
  for (int pick = weave.picks() - 1; pick >= 0; --pick) file.text(bitsOf(weave, pick, length));
  return file.bytes();
}

std::string bmpOf(const Fabric& fabric) {
  const Weave& weave = fabric.weave;
  const size_t length = bytesOfRow(weave, 4), pixels = length * static_cast<size_t>(weave.picks());
  constexpr size_t kFileHeader = 14, kInfoHeader = 40, kPalette = 8, kBefore = kFileHeader + kInfoHeader + kPalette;
  LittleEndian file;
  file.text("BM").u32(kBefore + pixels).u32(0).u32(kBefore);
  file.u32(kInfoHeader).u32(static_cast<size_t>(weave.ends())).u32(static_cast<size_t>(weave.picks()));
  file.u16(1).u16(1).u32(0).u32(pixels);  // planes, bits a pixel, no compression
  for (const double per_cm : {fabric.ends_per_cm, fabric.picks_per_cm})
    file.u32(static_cast<size_t>(std::lround(100 * per_cm)));  // pixels to the metre
  file.u32(2).u32(2).u32(0x00FFFFFF).u32(0);                   // two colours: white, black
  for (int pick = 0; pick < weave.picks(); ++pick) file.text(bitsOf(weave, pick, length));
  return file.bytes();
}

}  // namespace loomlight
