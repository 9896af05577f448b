#pragma once

#include <cstdint>
#include <vector>

namespace loomlight {

// Orders of yarns along a warp or weft (Fabric::warpSequence), made from others.

/// There and back, turning on the outermost threads: A B C becomes A B C B. Of one or two threads it is the same.
std::vector<int> mirrored(const std::vector<int>& sequence);
std::vector<int> reversed(const std::vector<int>& sequence);
/// Every stripe `factor` times as wide; factor >= 1.
std::vector<int> widened(const std::vector<int>& sequence, int factor);

/// Stripes by chance: each of a width from `narrowest` to `widest` threads, of a yarn drawn with its weight, neighbours
/// of different yarns where there are two. `weights` per yarn, none negative, one positive; 1 <= narrowest <= widest;
/// threads >= 1. The last stripe may be cut off. A pure function of its arguments.
struct StripeChance {
  int threads = 96;
  int narrowest = 2;
  int widest = 16;
  uint64_t seed = 1;
};
std::vector<int> randomStripes(const std::vector<double>& weights, const StripeChance& chance);

}  // namespace loomlight
