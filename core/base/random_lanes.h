#pragma once

#include <array>

#include "core/base/random.h"
#include "core/base/simd.h"

namespace loomlight {

/// Uniform numbers in [0, 1) for T: for one number from one generator, for several side by side from one of each.
template <class T>
class RandomLanes;

/// Two of them that were drawn at once.
template <class T>
struct RandomPair {
  T first, second;
};

template <>
class RandomLanes<float> {
 public:
  explicit RandomLanes(Random& random) : random_(random) {}
  bool inUse() const { return true; }
  float uniform() { return random_.uniform(); }
  /// Draws where the mask holds; else 0.
  float uniform(bool mask) { return mask ? random_.uniform() : 0.0f; }
  /// Two numbers where the mask holds; else 0.
  RandomPair<float> uniformPair(bool mask) {
    if (!mask) return {0, 0};
    const Random::Pair both = random_.uniformPair();
    return {both.first, both.second};
  }

 private:
  Random& random_;
};

template <>
class RandomLanes<Float32x8> {
 public:
  static constexpr size_t kCount = 8;
  /// Null where a lane is not in use: it gets zeros.
  explicit RandomLanes(const std::array<Random*, kCount>& random) : random_(random) {}
  /// Which lanes have numbers. Who draws until something holds need not wait for the others.
  Int32x8 inUse() const {
    Int32x8 mask{};
    for (size_t lane = 0; lane < kCount; ++lane) mask[lane] = random_[lane] ? -1 : 0;
    return mask;
  }
  Float32x8 uniform() { return uniform(inUse()); }
  /// The lanes of the mask draw, each from its own; the others get 0.
  Float32x8 uniform(Int32x8 mask) {
    Float32x8 u{};
    for (size_t lane = 0; lane < kCount; ++lane)
      if (mask[lane] != 0 && random_[lane]) u[lane] = random_[lane]->uniform();
    return u;
  }
  RandomPair<Float32x8> uniformPair(Int32x8 mask) {
    RandomPair<Float32x8> pairs{};
    for (size_t lane = 0; lane < kCount; ++lane) {
      if (mask[lane] == 0 || !random_[lane]) continue;
      const Random::Pair both = random_[lane]->uniformPair();
      pairs.first[lane] = both.first;
      pairs.second[lane] = both.second;
    }
    return pairs;
  }

 private:
  std::array<Random*, kCount> random_;
};

}  // namespace loomlight
