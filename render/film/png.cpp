#include <fmt/core.h>
#include <png.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <new>
#include <string_view>

#include "core/base/error.h"
#include "core/base/file.h"
#include "render/film/image.h"
#include "render/film/srgb_profile.h"

// How it works. libpng reads and writes (ISO/IEC 15948). It leaves where it fails by a jump, so what it calls and
// what lies between is free of destructors: attempt() is the only place that is jumped to. What a hostile file could
// make it allocate is refused before: a chunk that is longer than the file, and more pixels than deflate can pack
// into the file's bytes. Pixels are read as 8 bits a channel in colour, whatever the file has; they are written in 8
// bits as sRGB, which their profile says (a file that has one has no chunk for sRGB beside it), or in 16 bits as plain
// numbers, the density as pixels per metre. Cost: one pass over the pixels.

namespace loomlight {
namespace {

constexpr size_t kMaxFileBytes = size_t{1} << 30;

/// What libpng says is wrong, in a place that no jump leaves unfreed.
using Complaint = std::array<char, 256>;

[[noreturn]] void complain(png_structp png, png_const_charp text) {
  auto* const complaint = static_cast<Complaint*>(png_get_error_ptr(png));
  std::snprintf(complaint->data(), complaint->size(), "%s", text);
  png_longjmp(png, 1);
}

void ignore(png_structp, png_const_charp) {}

/// Runs calls of libpng; false where one has failed. `calls` must own nothing.
template <class Calls>
bool attempt(png_structp png, const Calls& calls) {
  if (setjmp(png_jmpbuf(png))) return false;
  calls();
  return true;
}

/// A PNG that is being read, from bytes that outlive it.
class Reader {
 public:
  explicit Reader(std::string_view bytes)
      : rest_(bytes),
        png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, &complaint_, complain, ignore)),
        info_(png_ ? png_create_info_struct(png_) : nullptr) {
    if (!info_) {
      png_destroy_read_struct(&png_, nullptr, nullptr);
      throw std::bad_alloc();
    }
    png_set_read_fn(png_, &rest_, [](png_structp png, png_bytep to, size_t count) {
      auto& rest = *static_cast<std::string_view*>(png_get_io_ptr(png));
      if (count > rest.size()) png_error(png, "it breaks off");
      std::memcpy(to, rest.data(), count);
      rest.remove_prefix(count);
    });
    png_set_user_limits(png_, kMaxSide, kMaxSide);
    // No chunk is unpacked larger than its file, or the fabric of a huge jacquard.
    constexpr size_t kMostUnpacked = size_t{64} << 20;
    png_set_chunk_malloc_max(png_, std::max(bytes.size(), kMostUnpacked));
  }
  ~Reader() { png_destroy_read_struct(&png_, &info_, nullptr); }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  /// What stands before the pixels. False where it is damaged: the extent is known all the same if knowsExtent().
  bool readInfo() {
    return attempt(png_, [&] { png_read_info(png_, info_); });
  }
  bool knowsExtent() const { return png_get_rowbytes(png_, info_) > 0; }
  int width() const { return static_cast<int>(png_get_image_width(png_, info_)); }
  int height() const { return static_cast<int>(png_get_image_height(png_, info_)); }
  int channels() const {
    return png_get_color_type(png_, info_) == PNG_COLOR_TYPE_PALETTE ? 3 : png_get_channels(png_, info_);
  }

  /// Of 8 bits, in colour, with alpha where anything is transparent. False where the file is damaged.
  bool readPixels(Pixels8& pixels) {
    // What a file cannot hold takes no memory: deflate packs 1032 bytes into one at most.
    constexpr size_t kMostPacked = 1032;
    if (png_get_rowbytes(png_, info_) * static_cast<size_t>(height()) / kMostPacked > rest_.size()) {
      std::snprintf(complaint_.data(), complaint_.size(), "it is too short for %d x %d pixels", width(), height());
      return false;
    }
    if (!attempt(png_, [&] {
          png_set_expand(png_);
          png_set_scale_16(png_);
          png_set_gray_to_rgb(png_);
          png_set_interlace_handling(png_);
          png_read_update_info(png_, info_);
        }))
      return false;
    pixels = {width(), height(), png_get_channels(png_, info_), {}};
    const size_t row = png_get_rowbytes(png_, info_);
    pixels.bytes.resize(row * static_cast<size_t>(pixels.height));
    std::vector<png_bytep> rows;
    for (size_t y = 0; y < static_cast<size_t>(pixels.height); ++y) rows.push_back(pixels.bytes.data() + y * row);
    return attempt(png_, [&] {
      png_read_image(png_, rows.data());
      png_read_end(png_, info_);
    });
  }

  std::map<std::string, std::string> texts() const {
    std::map<std::string, std::string> texts;
    png_textp found = nullptr;
    const int count = png_get_text(png_, info_, &found, nullptr);
    for (int i = 0; i < count; ++i)
      if (found[i].compression == PNG_ITXT_COMPRESSION_NONE)
        texts[found[i].key] = std::string(found[i].text, found[i].itxt_length);
    return texts;
  }

  const char* complaint() const { return complaint_.data(); }

 private:
  Complaint complaint_{};
  std::string_view rest_;
  png_structp png_;
  png_infop info_;
};

/// Whether a chunk says that it is longer than what is left of the file. libpng would take memory for all of it before
/// it sees that it is not there, and its limit for chunks is no more than a warning.
bool breaksOff(std::string_view bytes) {
  constexpr size_t kSignature = 8, kWord = 4;
  for (size_t at = kSignature; at + 2 * kWord <= bytes.size();) {
    size_t length = 0;
    for (const char byte : bytes.substr(at, kWord)) length = length << 8 | static_cast<unsigned char>(byte);
    at += kWord;
    if (bytes.substr(at, kWord) == "IEND") return false;
    if (length > bytes.size() - at) return true;
    at += kWord + length + kWord;  // its name, itself, its sum
  }
  return false;
}

[[noreturn]] void refuse(const std::string& file, std::string_view bytes, const char* complaint) {
  const bool isPng =
      png_sig_cmp(reinterpret_cast<png_const_bytep>(bytes.data()), 0, std::min<size_t>(8, bytes.size())) == 0;
  throw InputError(fmt::format("{}: {}{}; expected a PNG of at most {} x {} pixels", file,
                               isPng ? "damaged PNG file: " : "not a PNG file", isPng ? complaint : "", kMaxSide,
                               kMaxSide));
}

/// What a PNG is made of beside its pixels.
struct Form {
  int width = 0, height = 0, channels = 0, bits = 8;
  bool isColour = true;  ///< sRGB; else plain numbers
  PixelDensity density;
};

/// They point into `text`. Throws InputError.
std::vector<png_text> textsOf(const std::string& file, const std::map<std::string, std::string>& text) {
  std::vector<png_text> texts;
  for (const auto& [key, value] : text) {
    if (key.empty() || key.size() > 79 || key.find('\0') != std::string::npos)
      throw InputError(fmt::format("{}: '{}' cannot be the name of a text in a PNG", file, key));
    png_text entry{};
    entry.compression = PNG_ITXT_COMPRESSION_NONE;
    entry.key = const_cast<char*>(key.c_str());  // libpng copies both
    entry.text = const_cast<char*>(value.c_str());
    entry.itxt_length = value.size();
    texts.push_back(entry);
  }
  return texts;
}

/// `rows`: as the file has them, but numbers of 16 bits as the processor has them. Throws InputError.
void write(const std::string& file, const Form& form, const uint8_t* rows,
           const std::map<std::string, std::string>& text) {
  if (form.width < 1 || form.height < 1 || form.width > kMaxSide || form.height > kMaxSide)
    throw InputError(fmt::format("{}: cannot be written with {} x {} pixels, expected 1 to {} a side", file, form.width,
                                 form.height, kMaxSide));
  std::vector<png_text> texts = textsOf(file, text);
  struct Output {
    std::string png;
    bool isFull = false;
  } output;
  const std::string profile = form.isColour ? sRgbProfile() : "";
  Complaint complaint{};
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &complaint, complain, ignore);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  if (!info) {
    png_destroy_write_struct(&png, nullptr);
    throw std::bad_alloc();
  }
  png_set_write_fn(
      png, &output,
      [](png_structp to, png_bytep bytes, size_t count) {
        auto& out = *static_cast<Output*>(png_get_io_ptr(to));
        try {
          out.png.append(reinterpret_cast<const char*>(bytes), count);
        } catch (const std::bad_alloc&) {
          out.isFull = true;
        }
        if (out.isFull) png_error(to, "needs more memory than there is");
      },
      nullptr);
  static constexpr int kColourTypes[] = {PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB,
                                         PNG_COLOR_TYPE_RGB_ALPHA};
  const bool written = attempt(png, [&] {
    png_set_IHDR(png, info, static_cast<png_uint_32>(form.width), static_cast<png_uint_32>(form.height), form.bits,
                 kColourTypes[form.channels - 1], PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    if (form.isColour)
      png_set_iCCP(png, info, "sRGB", PNG_COMPRESSION_TYPE_BASE, reinterpret_cast<png_const_bytep>(profile.data()),
                   static_cast<png_uint_32>(profile.size()));
    if (form.density.across_dpi > 0) {
      const auto perMetre = [](double dpi) {
        constexpr double kInchesPerMetre = 1 / 0.0254;
        return static_cast<png_uint_32>(std::lround(std::clamp(dpi * kInchesPerMetre, 1.0, 1e9)));
      };
      png_set_pHYs(png, info, perMetre(form.density.across_dpi), perMetre(form.density.down_dpi), PNG_RESOLUTION_METER);
    }
    if (!texts.empty()) png_set_text(png, info, texts.data(), static_cast<int>(texts.size()));
    png_write_info(png, info);
    if (form.bits == 16 && std::endian::native == std::endian::little) png_set_swap(png);
    const size_t row = png_get_rowbytes(png, info);
    for (size_t y = 0; y < static_cast<size_t>(form.height); ++y) png_write_row(png, rows + y * row);
    png_write_end(png, nullptr);
  });
  png_destroy_write_struct(&png, &info);
  if (!written) throw InputError(fmt::format("{}: {}", file, complaint.data()));
  writeFileAtomically(file, output.png);
}

}  // namespace

void writePng(const std::string& file, const Pixels8& pixels, const std::map<std::string, std::string>& text,
              PixelDensity density) {
  assert(pixels.channels == 3 || pixels.channels == 4);
  write(file, {pixels.width, pixels.height, pixels.channels, 8, true, density}, pixels.bytes.data(), text);
}

void writePng(const std::string& file, const Pixels16& pixels, PixelDensity density) {
  assert(pixels.channels == 1 || pixels.channels == 3);
  write(file, {pixels.width, pixels.height, pixels.channels, 16, false, density},
        reinterpret_cast<const uint8_t*>(pixels.values.data()), {});
}

Pixels8 readPng(const std::string& file, std::map<std::string, std::string>* texts) {
  const std::string bytes = readFile(file, kMaxFileBytes);
  if (breaksOff(bytes)) refuse(file, bytes, "it breaks off");
  Reader reader(bytes);
  Pixels8 pixels;
  if (!reader.readInfo() || !reader.readPixels(pixels)) refuse(file, bytes, reader.complaint());
  if (texts) *texts = reader.texts();
  return pixels;
}

PictureExtent readPngExtent(const std::string& file) {
  constexpr std::streamsize kHeaderBytes = 8 + 25;  // the signature, and the header
  std::string header(kHeaderBytes, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(header.data(), kHeaderBytes);
  header.resize(static_cast<size_t>(stream.gcount()));
  Reader reader(header);
  reader.readInfo();  // in vain, as the rest is not there; but it has read the header
  if (!reader.knowsExtent()) refuse(file, header, reader.complaint());
  return {reader.width(), reader.height(), reader.channels()};
}

}  // namespace loomlight
