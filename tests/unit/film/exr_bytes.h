#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <vector>

namespace loomlight::test {

inline std::string littleEndian(uint64_t value, int bytes) {
  std::string out;
  for (int i = 0; i < bytes; ++i) out += static_cast<char>(value >> (8 * i));
  return out;
}
inline std::string int32(int64_t value) {
  return littleEndian(static_cast<uint64_t>(value), 4);
}

/// An uncompressed EXR written byte by byte from the published file layout, so that the tests can lie wherever they
/// like, and reading is not tested by what writes.
struct ExrBytes {
  enum Type { uint = 0, half = 1, floating = 2 };
  struct Channel {
    std::string name;
    Type type = floating;
    std::string row;  ///< one row of values; the same for all rows
    int sampling = 1;
  };

  int minX = 0, minY = 0, width = 4, height = 2;
  std::vector<Channel> channels;  ///< in alphabetical order
  bool tiled = false;             ///< one tile that covers all
  std::string extraAttributes;
  uint32_t versionFlags = 0;

  static std::string attribute(const std::string& name, const std::string& type, const std::string& value,
                               int64_t claimedSize = -1) {
    return name + '\0' + type + '\0' + int32(claimedSize < 0 ? static_cast<int64_t>(value.size()) : claimedSize) +
           value;
  }

  std::string header() const {
    std::string list;
    for (const Channel& c : channels)
      list += c.name + '\0' + int32(c.type) + std::string(4, '\0') + int32(c.sampling) + int32(c.sampling);
    list += '\0';
    const std::string window =
        int32(minX) + int32(minY) + int32(minX + int64_t{width} - 1) + int32(minY + int64_t{height} - 1);
    const std::string one = int32(std::bit_cast<int32_t>(1.0f));
    std::string h = int32(20000630) + int32(2u | versionFlags | (tiled ? 0x200u : 0u));
    h += attribute("channels", "chlist", list) + attribute("compression", "compression", std::string(1, '\0'));
    h += attribute("dataWindow", "box2i", window) + attribute("displayWindow", "box2i", window);
    h += attribute("lineOrder", "lineOrder", std::string(1, '\0')) + attribute("pixelAspectRatio", "float", one);
    h += attribute("screenWindowCenter", "v2f", std::string(8, '\0')) + attribute("screenWindowWidth", "float", one);
    if (tiled) h += attribute("tiles", "tiledesc", int32(width) + int32(height) + std::string(1, '\0'));
    return h + extraAttributes + '\0';
  }

  std::string all() const {
    std::string row;
    for (const Channel& c : channels) row += c.row;
    std::string out = header();
    if (tiled) {
      out += littleEndian(out.size() + 8, 8) + std::string(16, '\0') + int32(static_cast<int64_t>(row.size()) * height);
      for (int y = 0; y < height; ++y) out += row;
      return out;
    }
    const size_t first = out.size() + 8 * static_cast<size_t>(height);
    for (int y = 0; y < height; ++y) out += littleEndian(first + static_cast<size_t>(y) * (8 + row.size()), 8);
    for (int y = 0; y < height; ++y) out += int32(minY + y) + int32(static_cast<int64_t>(row.size())) + row;
    return out;
  }
};

}  // namespace loomlight::test
