#pragma once

#include <cstdint>
#include <string_view>

namespace loomlight::fuzz {

/// The bytes of an input as choices, one after the other; behind their end each is the first.
class Choices {
 public:
  explicit Choices(std::string_view bytes) : rest_(bytes) {}

  bool isOver() const { return rest_.empty(); }
  /// In {0, ..., n - 1}, 0 < n <= 256.
  uint32_t below(uint32_t n) {
    if (rest_.empty()) return 0;
    const auto byte = static_cast<uint8_t>(rest_.front());
    rest_.remove_prefix(1);
    return byte % n;
  }
  int from(int first, int last) { return first + static_cast<int>(below(static_cast<uint32_t>(last - first + 1))); }

 private:
  std::string_view rest_;
};

}  // namespace loomlight::fuzz
