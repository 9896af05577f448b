#pragma once

#include <cstdint>
#include <cstring>
#include <type_traits>

namespace loomlight {

/// Finaliser of SplitMix64 (Steele et al. 2014): a bijection of 64 bits in which every input bit moves every output
/// bit.
constexpr uint64_t mixBits(uint64_t x) {
  x += 0x9E3779B97F4A7C15ull;
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9ull;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBull;
  return x ^ (x >> 31);
}

/// Folds a value, bit for bit, into a running hash. For keys of caches in memory, not against attackers.
template <class T>
uint64_t hashCombine(uint64_t hash, const T& value) {
  static_assert(std::has_unique_object_representations_v<T> || std::is_floating_point_v<T>,
                "a type with padding has no well-defined bytes to hash");
  static_assert(sizeof(T) <= 8);
  uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof(T));
  return mixBits(hash ^ bits);
}

}  // namespace loomlight
