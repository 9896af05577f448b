#pragma once

#include <cstdint>

#include "core/base/hash.h"
#include "core/base/stratified.h"

namespace loomlight {

/// A small, fast generator: SplitMix64 in counter form. The stream is a pure function of the seed, so anything built
/// from it is reproducible on every machine.
///
/// Numbers that many samples of one thing draw for the same purpose may be stratified over them: see stratify().
class Random {
 public:
  explicit constexpr Random(uint64_t seed) : state_(mixBits(seed)) {}
  /// For sample `index` of what belongs to `seed`.
  constexpr Random(uint64_t seed, uint32_t index)
      : state_(mixBits(mixBits(seed ^ index))), seed_(seed), index_(index) {}

  /// The next `count` numbers of bits() and uniform() are coordinates `dimension`, `dimension` + 1, ... of point
  /// `index` of a low-discrepancy sequence (stratified.h); what is drawn beyond them is random again. Begin at an even
  /// dimension with what belongs together in pairs.
  constexpr void stratify(uint32_t dimension, uint32_t count) {
    dimension_ = dimension;
    end_ = dimension + count;
  }

  constexpr uint64_t next() { return mixBits(state_ += 0xD1B54A32D192ED03ull); }
  /// 32 of them.
  constexpr uint32_t bits() {
    if (dimension_ < end_) [[unlikely]]
      return stratifiedBits();
    return static_cast<uint32_t>(next() >> 32);
  }
  /// Uniform in [0, 1): 24 bits, so that it is exact in float and never rounds to 1.
  constexpr float uniform() { return fraction(bits()); }
  struct Pair {
    float first, second;
  };
  /// Two of them, for little more than one; where they are stratified, two dimensions that are so together.
  constexpr Pair uniformPair() {
    if (dimension_ < end_) [[unlikely]]
      return stratifiedPair();
    const uint64_t both = next();
    return {fraction(static_cast<uint32_t>(both >> 32)), fraction(static_cast<uint32_t>(both))};
  }
  constexpr double uniformDouble() { return static_cast<double>(next() >> 11) * 0x1p-53; }
  /// Uniform in {0, ..., n - 1}; n > 0. Bias below n / 2^32.
  constexpr uint32_t below(uint32_t n) { return static_cast<uint32_t>(((next() >> 32) * n) >> 32); }

 private:
  static constexpr float fraction(uint32_t bits) { return static_cast<float>(bits >> 8) * 0x1p-24f; }
  /// Apart, since it is long and rare: only the first events of a path are stratified.
  [[gnu::noinline]] constexpr uint32_t stratifiedBits() { return stratified::coordinate(seed_, index_, dimension_++); }
  [[gnu::noinline]] constexpr Pair stratifiedPair() {
    const uint32_t even = dimension_ + (dimension_ & 1);  // an odd one that is left is not drawn
    if (even + 2 > end_) {
      dimension_ = end_;
      return uniformPair();
    }
    dimension_ = even + 2;
    const stratified::PairOfDimensions pair(seed_, index_, even);
    return {fraction(pair.coordinate(0)), fraction(pair.coordinate(1))};
  }

  uint64_t state_;
  uint64_t seed_ = 0;
  uint32_t index_ = 0, dimension_ = 0, end_ = 0;
};

}  // namespace loomlight
