#pragma once

#include <cstdint>
#include <cstring>
#include <string_view>

#include "core/base/hash.h"

namespace loomlight {

/// Folds the bytes of a text into a running hash, one by one.
inline uint64_t hashBytes(uint64_t hash, std::string_view bytes) {
  for (const char byte : bytes) hash = hashCombine(hash, byte);
  return hash;
}

/// Of the content of a file: eight bytes at a time, then what is left. Not against forgers.
inline uint64_t checksum(std::string_view bytes) {
  uint64_t sum = bytes.size();
  for (; bytes.size() >= sizeof(sum); bytes.remove_prefix(sizeof(sum))) {
    uint64_t word = 0;
    std::memcpy(&word, bytes.data(), sizeof(word));
    sum = hashCombine(sum, word);
  }
  return hashBytes(sum, bytes);
}

}  // namespace loomlight
