#pragma once

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/base/text_encoding.h"

namespace loomlight {

/// Takes numbers off the front of a file whose most significant byte comes first. Throws InputError, naming `source`
/// and the byte, where the file ends before them.
class BigEndian {
 public:
  BigEndian(std::string_view bytes, const std::string& source) : bytes_(bytes), source_(source) {}

  bool atEnd() const { return at_ == bytes_.size(); }
  std::string place() const { return fmt::format("{}: byte {}", source_, begin_ + at_); }

  std::string_view bytes(size_t count) {
    if (count > bytes_.size() - at_)
      throw InputError(fmt::format("{}: expected {} bytes more; the file ends", place(), count));
    at_ += count;
    return bytes_.substr(at_ - count, count);
  }

  /// So many bytes by themselves; places in them are still those in the file.
  BigEndian block(size_t count) {
    const size_t begin = begin_ + at_;
    BigEndian inner(bytes(count), source_);
    inner.begin_ = begin;
    return inner;
  }

  uint32_t whole(size_t size) {
    uint32_t value = 0;
    for (const char byte : bytes(size)) value = value << 8 | static_cast<uint8_t>(byte);
    return value;
  }
  uint16_t u16() { return static_cast<uint16_t>(whole(2)); }
  uint32_t u32() { return whole(4); }
  float f32() { return std::bit_cast<float>(u32()); }

  /// UTF-16 of so many units, a zero at its end among them.
  std::string text(size_t units) {
    const std::string begin = place();
    std::string_view raw = bytes(2 * units);
    while (raw.ends_with(std::string_view("\0\0", 2))) raw.remove_suffix(2);
    if (raw.empty()) return {};
    return decodeText("\xFE\xFF" + std::string(raw), begin).text;
  }

 private:
  std::string_view bytes_;
  const std::string& source_;
  size_t begin_ = 0;  ///< of the bytes in the file
  size_t at_ = 0;
};

}  // namespace loomlight
