// PNG by stb, whose two implementations live here and nowhere else. Texts and the size on paper are chunks that we add
// ourselves: stb cannot.
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_NO_FAILURE_STRINGS
#define STBI_NO_HDR
#define STBI_NO_LINEAR
#define STBI_MAX_DIMENSIONS 16384
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#include <stb/stb_image.h>
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <climits>
#include <cmath>
#include <fstream>
#include <memory>
#include <string_view>

#include "core/base/error.h"
#include "core/base/file.h"
#include "render/film/image.h"

namespace loomlight {
namespace {

constexpr int kMaxSide = STBI_MAX_DIMENSIONS;
constexpr size_t kMaxFileBytes = size_t{1} << 30;
constexpr size_t kHeaderBytes = 8 + 25;  ///< the signature and the IHDR chunk, which comes first

/// CRC-32 of ISO 3309, as in the PNG specification, annex D.
uint32_t crc(const std::string& bytes) {
  static constexpr auto table = [] {
    std::array<uint32_t, 256> t{};
    for (uint32_t n = 0; n < 256; ++n) {
      t[n] = n;
      for (int k = 0; k < 8; ++k) t[n] = t[n] & 1 ? 0xEDB88320u ^ (t[n] >> 1) : t[n] >> 1;
    }
    return t;
  }();
  uint32_t c = ~0u;
  for (const char byte : bytes) c = table[(c ^ static_cast<uint8_t>(byte)) & 255] ^ (c >> 8);
  return ~c;
}

std::string bigEndian(uint32_t n) {
  return {static_cast<char>(n >> 24), static_cast<char>(n >> 16), static_cast<char>(n >> 8), static_cast<char>(n)};
}

uint32_t number(const std::string& bytes, size_t at) {
  uint32_t n = 0;
  for (size_t i = 0; i < 4; ++i) n = n << 8 | static_cast<uint8_t>(bytes[at + i]);
  return n;
}

std::string chunk(const std::string& type, const std::string& data) {
  return bigEndian(static_cast<uint32_t>(data.size())) + type + data + bigEndian(crc(type + data));
}

/// An iTXt chunk: UTF-8, uncompressed, no language.
std::string textChunk(const std::string& file, const std::string& key, const std::string& value) {
  if (key.empty() || key.size() > 79 || key.find('\0') != std::string::npos || value.size() > INT_MAX / 2)
    throw InputError(fmt::format("{}: '{}' cannot be the name of a text in a PNG", file, key));
  return chunk("iTXt", key + std::string(5, '\0') + value);
}

/// A pHYs chunk: whole pixels per metre, the same both ways.
std::string sizeChunk(double dpi) {
  constexpr double kInchesPerMetre = 1 / 0.0254;
  const auto perMetre = static_cast<uint32_t>(std::lround(std::clamp(dpi * kInchesPerMetre, 1.0, 1e9)));
  return chunk("pHYs", bigEndian(perMetre) + bigEndian(perMetre) + '\1');
}

/// The text of an iTXt chunk as textChunk() makes them; other forms are left out.
void addText(std::string_view data, std::map<std::string, std::string>& texts) {
  const size_t end = data.find('\0');
  if (end == std::string_view::npos || data.substr(end, 5) != std::string_view("\0\0\0\0\0", 5)) return;
  texts[std::string(data.substr(0, end))] = std::string(data.substr(end + 5));
}

}  // namespace

void writePng(const std::string& file, const Pixels8& pixels, const std::map<std::string, std::string>& text,
              double dpi) {
  assert(pixels.channels == 3 || pixels.channels == 4);
  if (pixels.width < 1 || pixels.height < 1 || pixels.width > kMaxSide || pixels.height > kMaxSide)
    throw InputError(fmt::format("{}: cannot be written with {} x {} pixels, expected 1 to {} a side", file,
                                 pixels.width, pixels.height, kMaxSide));
  std::string png;
  const auto append = [](void* to, void* bytes, int count) {
    static_cast<std::string*>(to)->append(static_cast<const char*>(bytes), static_cast<size_t>(count));
  };
  if (!stbi_write_png_to_func(append, &png, pixels.width, pixels.height, pixels.channels, pixels.bytes.data(),
                              pixels.width * pixels.channels))
    throw InputError(fmt::format("{}: needs more memory than there is", file));

  std::string extra = chunk("sRGB", std::string(1, '\0'));  // perceptual intent
  if (dpi > 0) extra += sizeChunk(dpi);
  for (const auto& [key, value] : text) extra += textChunk(file, key, value);
  png.insert(kHeaderBytes, extra);
  writeFileAtomically(file, png);
}

Pixels8 readPng(const std::string& file) {
  const std::string bytes = readFile(file, kMaxFileBytes);
  const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
  const int size = static_cast<int>(bytes.size());
  Pixels8 pixels;
  int channelsInFile = 0;
  if (!stbi_info_from_memory(data, size, &pixels.width, &pixels.height, &channelsInFile))
    throw InputError(fmt::format("{}: not a PNG file, or one of more than {} x {} pixels", file, kMaxSide, kMaxSide));
  const bool hasAlpha = channelsInFile == 2 || channelsInFile == 4;
  pixels.channels = hasAlpha ? 4 : 3;
  const std::unique_ptr<stbi_uc, void (*)(void*)> decoded(
      stbi_load_from_memory(data, size, &pixels.width, &pixels.height, &channelsInFile, pixels.channels),
      stbi_image_free);
  if (!decoded) throw InputError(fmt::format("{}: damaged PNG file", file));
  const size_t count =
      static_cast<size_t>(pixels.width) * static_cast<size_t>(pixels.height) * static_cast<size_t>(pixels.channels);
  pixels.bytes.assign(decoded.get(), decoded.get() + count);
  return pixels;
}

PictureExtent readPngExtent(const std::string& file) {
  // Read here, not by the decoder: some versions of it ask for more of the file than its header.
  std::string header(kHeaderBytes, '\0');
  std::ifstream stream(file, std::ios::binary);
  const bool isPng = stream.read(header.data(), static_cast<std::streamsize>(header.size())) &&
                     header.compare(0, 8, "\x89PNG\r\n\x1a\n") == 0 && header.compare(12, 4, "IHDR") == 0;
  const auto bigEndian = [&](size_t at) {
    uint32_t value = 0;
    for (size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<uint8_t>(header[at + i]);
    return value;
  };
  const uint32_t width = bigEndian(16), height = bigEndian(20);
  if (!isPng || width < 1 || width > kMaxSide || height < 1 || height > kMaxSide)
    throw InputError(fmt::format("{}: not a PNG file, or one of more than {} x {} pixels", file, kMaxSide, kMaxSide));
  PictureExtent extent;
  extent.width = static_cast<int>(width);
  extent.height = static_cast<int>(height);
  const int colourType = header[25];  // PNG 1.2, section 4.1.1: grey, RGB, palette, grey and alpha, RGB and alpha
  extent.channels = colourType == 0 ? 1 : colourType == 4 ? 2 : colourType == 6 ? 4 : 3;
  return extent;
}

std::map<std::string, std::string> readPngTexts(const std::string& file) {
  constexpr size_t kSignature = 8, kAround = 12;  // length and type before a chunk's data, checksum behind it
  const std::string bytes = readFile(file, kMaxFileBytes);
  if (bytes.compare(0, kSignature, "\x89PNG\r\n\x1a\n") != 0) throw InputError(fmt::format("{}: not a PNG file", file));
  std::map<std::string, std::string> texts;
  for (size_t at = kSignature; at < bytes.size();) {
    const size_t left = bytes.size() - at;
    const size_t length = left < kAround ? left : number(bytes, at);
    if (left < kAround || length > left - kAround) throw InputError(fmt::format("{}: damaged PNG file", file));
    if (bytes.compare(at + 4, 4, "iTXt") == 0) addText(std::string_view(bytes).substr(at + 8, length), texts);
    at += kAround + length;
  }
  return texts;
}

}  // namespace loomlight
