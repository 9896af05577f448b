#include <ImfChannelList.h>
#include <ImfChromaticities.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <new>
#include <string_view>

#include "core/base/error.h"
#include "core/base/file.h"
#include "render/film/image.h"
#include "render/film/pixel_rect.h"

// How it works. OpenEXR 3 reads and writes. What a hostile file could make it allocate is checked before it sees the
// file: a HeaderGuard goes through the attributes of every header (OpenEXR file layout) without believing any of
// their numbers, and refuses deep images, attributes of another size than their type has, sides above 16384 pixels,
// more than 1024 channels and more than 2 GB of pixels. Every channel is read as floats of 32 bits. A file is
// written into memory first, compressed without loss (ZIP), because OpenEXR's own files swallow that a disk is full;
// its bytes then take the place of the old file at once. Cost: one pass over the pixels, and twice their memory.

namespace loomlight {
namespace {

constexpr int64_t kMaxChannels = 1024;
constexpr uint64_t kMaxBytes = uint64_t{1} << 31;  ///< of the pixels in memory; a 4K picture with all its sums fits

// Bits of the version field (OpenEXR file layout).
constexpr uint32_t kDeepFlag = 0x800, kMultiPartFlag = 0x1000;

/// How many bytes OpenEXR takes for attributes of these types, whatever size the header says of them.
struct FixedType {
  std::string_view name;
  uint32_t bytes;
};
constexpr FixedType kFixedTypes[] = {{"box2f", 16},
                                     {"box2i", 16},
                                     {"chromaticities", 32},
                                     {"compression", 1},
                                     {"deepImageState", 1},
                                     {"double", 8},
                                     {"envmap", 1},
                                     {"float", 4},
                                     {"int", 4},
                                     {"keycode", 28},
                                     {"lineOrder", 1},
                                     {"m33d", 72},
                                     {"m33f", 36},
                                     {"m44d", 128},
                                     {"m44f", 64},
                                     {"rational", 8},
                                     {"tiledesc", 9},
                                     {"timecode", 8},
                                     {"v2d", 16},
                                     {"v2f", 8},
                                     {"v2i", 8},
                                     {"v3d", 24},
                                     {"v3f", 12},
                                     {"v3i", 12}};

/// Walks the attributes of a header without believing any of its numbers.
class HeaderGuard {
 public:
  explicit HeaderGuard(const std::string& file) : file_(file) {
    std::error_code error;
    if (!std::filesystem::exists(file, error)) throw InputError(fmt::format("{}: no such file", file));
    if (!std::filesystem::is_regular_file(file, error)) throw InputError(fmt::format("{}: not a regular file", file));
    size_ = std::filesystem::file_size(file, error);
    stream_.open(file, std::ios::binary);
    if (!stream_) throw InputError(fmt::format("{}: cannot be read: {}", file, std::strerror(errno)));
  }

  void check() {
    if (integer() != 20000630u) throw InputError(fmt::format("{}: not an EXR file", file_));
    const uint32_t version = integer();
    if (version & kDeepFlag) throw InputError(fmt::format("{}: deep EXR files are not supported", file_));
    do {
      checkPart();
    } while ((version & kMultiPartFlag) && stream_.peek() != 0);
  }

 private:
  [[noreturn]] void damaged() const { throw InputError(fmt::format("{}: damaged EXR header", file_)); }

  uint32_t integer() {
    std::array<unsigned char, 4> b{};
    if (!stream_.read(reinterpret_cast<char*>(b.data()), 4)) damaged();
    return b[0] | b[1] << 8 | b[2] << 16 | static_cast<uint32_t>(b[3]) << 24;
  }

  std::string word() {
    std::string text;
    for (int c = stream_.get(); c != 0; c = stream_.get()) {
      if (c < 0 || text.size() == 255) damaged();
      text += static_cast<char>(c);
    }
    return text;
  }

  /// OpenEXR goes on behind what it takes an attribute for: were that elsewhere, it would see another header than this
  /// does, and allocate as much as that says.
  void checkSize(std::string_view type, uint32_t bytes, std::streampos start) {
    for (const FixedType& fixed : kFixedTypes)
      if (fixed.name == type && fixed.bytes != bytes) damaged();
    stream_.seekg(start);
    if (type == "preview") {
      constexpr uint64_t kSides = 8, kPixel = 4;
      const uint64_t width = integer(), height = integer();
      if (std::max(width, height) > kMaxSide || kSides + kPixel * width * height != bytes) damaged();
    } else if (type == "stringvector") {
      for (uint64_t taken = 0; taken < bytes;) {
        const uint32_t length = integer();
        taken += sizeof(length) + length;
        if (taken > bytes) damaged();
        stream_.seekg(length, std::ios::cur);
      }
    }
  }

  void checkPart() {
    int64_t width = 0, height = 0, tileWidth = 0, tileHeight = 0, channels = 0;
    for (std::string name = word(); !name.empty(); name = word()) {
      const std::string type = word();
      const uint32_t bytes = integer();
      const auto start = stream_.tellg();
      if (start < 0 || bytes > size_ - static_cast<uint64_t>(start)) damaged();
      if (name == "dataWindow" && type == "box2i") {
        const auto coordinate = [&] { return static_cast<int64_t>(static_cast<int32_t>(integer())); };
        const int64_t minX = coordinate(), minY = coordinate();
        width = coordinate() - minX + 1;
        height = coordinate() - minY + 1;
      } else if (name == "tiles" && type == "tiledesc") {
        tileWidth = integer();
        tileHeight = integer();
      } else if (type == "chlist") {
        while (!word().empty()) {
          stream_.seekg(16, std::ios::cur);  // type, linearity, sampling
          ++channels;
        }
        if (stream_.tellg() != start + static_cast<std::streamoff>(bytes)) damaged();
      }
      checkSize(type, bytes, start);
      stream_.seekg(start + static_cast<std::streamoff>(bytes));
    }
    if (width < 1 || height < 1) damaged();
    if (width > kMaxSide || height > kMaxSide || tileWidth > kMaxSide || tileHeight > kMaxSide)
      throw InputError(fmt::format("{}: {} x {} pixels is too large, expected at most {} x {}", file_,
                                   std::max(width, tileWidth), std::max(height, tileHeight), kMaxSide, kMaxSide));
    if (channels > kMaxChannels)
      throw InputError(fmt::format("{}: too many channels, expected at most {}", file_, kMaxChannels));
    const uint64_t pixels = static_cast<uint64_t>(std::max(width * height, tileWidth * tileHeight));
    if (pixels * static_cast<uint64_t>(channels) * sizeof(float) > kMaxBytes)
      throw InputError(fmt::format("{}: too large: {} channels of {} x {} pixels are more than 2 GB", file_, channels,
                                   width, height));
  }

  std::string file_;
  std::ifstream stream_;
  uint64_t size_ = 0;
};

/// Takes what OpenEXR writes: its own files swallow, in their destructors, that the disk is full.
class MemoryStream : public Imf::OStream {
 public:
  explicit MemoryStream(const std::string& name) : OStream(name.c_str()) {}
  const std::string& bytes() const { return bytes_; }

  void write(const char bytes[], int count) override {
    const size_t end = position_ + static_cast<size_t>(count);
    if (end > bytes_.size()) bytes_.resize(end);
    std::copy_n(bytes, count, bytes_.data() + position_);
    position_ = end;
  }
  uint64_t tellp() override { return position_; }
  void seekp(uint64_t position) override { position_ = position; }

 private:
  std::string bytes_;
  size_t position_ = 0;
};

std::map<std::string, std::string> textsOf(const Imf::Header& header) {
  std::map<std::string, std::string> texts;
  for (auto a = header.begin(); a != header.end(); ++a) {
    if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&a.attribute())) texts[a.name()] = text->value();
  }
  return texts;
}

/// What OpenEXR says, in which it quotes the file's own bytes, as one line that can be shown. It names the file, as we
/// do before it.
std::string plainLine(std::string text, const std::string& file) {
  if (const size_t at = text.find(" \"" + file + "\""); at != std::string::npos) text.erase(at, file.size() + 3);
  for (char& c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte >= 0x7F) c = byte == '\n' ? ' ' : '?';
  }
  return text;
}

Image readImage(const std::string& file) {
  Imf::InputFile input(file.c_str());
  const Imf::Header& header = input.header();
  const Imath::Box2i window = header.dataWindow();
  Image image;
  image.width = window.max.x - window.min.x + 1;
  image.height = window.max.y - window.min.y + 1;
  for (auto c = header.channels().begin(); c != header.channels().end(); ++c) {
    if (c.channel().xSampling != 1 || c.channel().ySampling != 1)
      throw InputError(
          fmt::format("{}: channel {} is subsampled, expected one value a pixel", file, plainLine(c.name(), file)));
  }
  if (!input.isComplete()) throw InputError(fmt::format("{}: incomplete, some of its pixels are missing", file));

  Imf::FrameBuffer buffer;
  for (auto c = header.channels().begin(); c != header.channels().end(); ++c) {
    float* values = image.add(c.name()).data();
    buffer.insert(c.name(), Imf::Slice::Make(Imf::FLOAT, values, window));
  }
  input.setFrameBuffer(buffer);
  input.readPixels(window.min.y, window.max.y);
  image.metadata = textsOf(header);
  if (const Imath::Box2i& whole = header.displayWindow(); whole != window && whole.min == Imath::V2i(0)) {
    image.left = window.min.x;
    image.top = window.min.y;
    image.wholeWidth = whole.max.x + 1;
    image.wholeHeight = whole.max.y + 1;
  }
  return image;
}

/// Runs read(file) on a file whose header makes no outrageous claims; what OpenEXR throws becomes an InputError.
template <class Read>
auto guarded(const std::string& file, Read&& read) {
  HeaderGuard(file).check();
  try {
    return read(file);
  } catch (const InputError&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw InputError(fmt::format("{}: needs more memory than there is", file));
  } catch (const std::exception& e) {
    throw InputError(fmt::format("{}: damaged or unsupported EXR file: {}", file, plainLine(e.what(), file)));
  }
}

bool isColour(const Image& image) {
  return image.find("R") && image.find("G") && image.find("B");
}

Imf::Header headerOf(const std::string& file, const Image& image) {
  const bool whole = image.wholeWidth == 0;
  Imf::Header header(
      whole ? image.width : image.wholeWidth, whole ? image.height : image.wholeHeight,
      Imath::Box2i({image.left, image.top}, {image.left + image.width - 1, image.top + image.height - 1}));
  header.compression() = Imf::ZIP_COMPRESSION;
  for (const Image::Channel& channel : image.channels) header.channels().insert(channel.name, Imf::Channel(Imf::FLOAT));
  if (isColour(image)) Imf::addChromaticities(header, Imf::Chromaticities());  // by default those of Rec. 709 and D65
  for (const auto& [name, value] : image.metadata) {
    if (name.empty() || name.size() > 255 || header.find(name) != header.end())
      throw InputError(fmt::format("{}: '{}' cannot be the name of a text in an EXR", file, name));
    header.insert(name, Imf::StringAttribute(value));
  }
  return header;
}

}  // namespace

Image readExr(const std::string& file) {
  return guarded(file, readImage);
}

PictureExtent readExrExtent(const std::string& file) {
  return guarded(file, [](const std::string& name) {
    const Imf::InputFile input(name.c_str());
    const Imath::Box2i& window = input.header().dataWindow();
    PictureExtent extent{window.max.x - window.min.x + 1, window.max.y - window.min.y + 1, 0};
    for (auto c = input.header().channels().begin(); c != input.header().channels().end(); ++c) ++extent.channels;
    return extent;
  });
}

std::map<std::string, std::string> readExrTexts(const std::string& file) {
  return guarded(file, [](const std::string& name) { return textsOf(Imf::InputFile(name.c_str()).header()); });
}

void writeExr(const std::string& file, const Image& image, double dpi) {
  if (image.width < 1 || image.height < 1 || image.width > kMaxSide || image.height > kMaxSide)
    throw InputError(fmt::format("{}: cannot be written with {} x {} pixels, expected 1 to {} a side", file,
                                 image.width, image.height, kMaxSide));
  Imf::Header header = headerOf(file, image);
  if (dpi > 0) Imf::addXDensity(header, static_cast<float>(dpi));
  Imf::FrameBuffer buffer;
  for (const Image::Channel& channel : image.channels) {
    assert(channel.values.size() == pixelCount(image.width, image.height));
    // OpenEXR shares one slice type between reading and writing; when writing it only reads.
    buffer.insert(channel.name, Imf::Slice::Make(Imf::FLOAT, channel.values.data(), header.dataWindow()));
  }
  MemoryStream stream(file);
  try {
    Imf::OutputFile output(stream, header);
    output.setFrameBuffer(buffer);
    output.writePixels(image.height);
  } catch (const std::exception& e) {
    throw InputError(fmt::format("{}: cannot be written: {}", file, e.what()));
  }
  writeFileAtomically(file, stream.bytes());
}

}  // namespace loomlight
