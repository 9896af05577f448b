#pragma once

#include <cstdint>

#include "core/base/hash.h"

namespace loomlight {

/// A small, fast generator: SplitMix64 in counter form. The stream is a pure function of the seed, so anything built
/// from it is reproducible on every machine.
class Random {
 public:
  explicit constexpr Random(uint64_t seed) : state_(mixBits(seed)) {}

  constexpr uint64_t next() { return mixBits(state_ += 0xD1B54A32D192ED03ull); }
  /// Uniform in [0, 1): 24 bits, so that it is exact in float and never rounds to 1.
  constexpr float uniform() { return static_cast<float>(next() >> 40) * 0x1p-24f; }
  constexpr double uniformDouble() { return static_cast<double>(next() >> 11) * 0x1p-53; }
  /// Uniform in {0, ..., n - 1}; n > 0. Bias below n / 2^32.
  constexpr uint32_t below(uint32_t n) { return static_cast<uint32_t>(((next() >> 32) * n) >> 32); }

 private:
  uint64_t state_;
};

}  // namespace loomlight
