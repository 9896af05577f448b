#pragma once

#include <cstdint>
#include <vector>

namespace loomlight {

// Orders of yarns along a warp or weft (Fabric::warpSequence), made from others.

/// There and back, turning on the outermost yarns: A B C becomes A B C B. Of one or two it is the same.
std::vector<int> mirrored(const std::vector<int>& sequence);
std::vector<int> reversed(const std::vector<int>& sequence);
/// The same order so many times; times >= 1. It is to be varied: as it stands the cloth is the same.
std::vector<int> repeated(const std::vector<int>& sequence, int times);
/// Every stripe `factor` times as wide; factor >= 1.
std::vector<int> widened(const std::vector<int>& sequence, int factor);

/// Ends or picks of one yarn side by side.
struct Stripe {
  int yarn = 0, width = 0;  ///< width: in ends or picks
  friend bool operator==(const Stripe&, const Stripe&) = default;
};
std::vector<Stripe> stripesOf(const std::vector<int>& sequence);
std::vector<int> sequenceOf(const std::vector<Stripe>& stripes);
/// The last stripe made longer by as few yarns as make the order repeat with a weave of `repeat` ends (or picks); >= 1.
std::vector<int> balanced(std::vector<int> sequence, int repeat);

/// Stripes by chance: each of a width from `narrowest` to `widest` yarns, of a yarn drawn with its weight, neighbours
/// of different yarns where there are two. `weights` per yarn, none negative, one positive; 1 <= narrowest <= widest;
/// length >= 1. The last stripe may be cut off. A pure function of its arguments.
struct StripeChance {
  int length = 96;  ///< of the order, in ends or picks
  int narrowest = 2;
  int widest = 16;
  uint64_t seed = 1;
};
std::vector<int> randomStripes(const std::vector<double>& weights, const StripeChance& chance);

}  // namespace loomlight
