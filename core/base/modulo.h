#pragma once

#include <cstdint>
#include <limits>

namespace loomlight {

/// i counted from the nearest multiple of n below: 0 <= wrap(i, n) < n.
constexpr int wrap(int i, int n) {
  const int r = i % n;
  return r < 0 ? r + n : r;
}

/// Remainder and quotient by a divisor that is used often: multiplications instead of a division (Lemire, Kaser and
/// Kurz 2019, "Faster remainder by direct computation"). Exact for all 32-bit numbers.
class Modulo {
 public:
  constexpr Modulo() = default;  ///< by 1
  explicit constexpr Modulo(uint32_t divisor)
      : inverse_(std::numeric_limits<uint64_t>::max() / divisor + 1), divisor_(divisor) {}
  constexpr uint32_t operator()(uint32_t n) const {
    return static_cast<uint32_t>(static_cast<Wide>(inverse_ * n) * divisor_ >> 64);
  }
  constexpr uint32_t quotient(uint32_t n) const {
    return divisor_ == 1 ? n : static_cast<uint32_t>(static_cast<Wide>(inverse_) * n >> 64);
  }

 private:
  __extension__ using Wide = unsigned __int128;
  uint64_t inverse_ = 0;
  uint32_t divisor_ = 1;
};

}  // namespace loomlight
