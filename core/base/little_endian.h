#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace loomlight {

/// Bytes of a file whose numbers have their lowest byte first, whatever the processor.
class LittleEndian {
 public:
  LittleEndian& u16(unsigned value) { return put(value, 2); }  ///< below 2^16
  LittleEndian& u32(size_t value) { return put(value, 4); }    ///< below 2^32
  LittleEndian& text(std::string_view value) {
    bytes_ += value;
    return *this;
  }
  size_t size() const { return bytes_.size(); }
  const std::string& bytes() const { return bytes_; }

 private:
  LittleEndian& put(size_t value, int count) {
    for (int i = 0; i < count; ++i) bytes_ += static_cast<char>(value >> (8 * i) & 0xFF);
    return *this;
  }

  std::string bytes_;
};

}  // namespace loomlight
