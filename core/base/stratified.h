#pragma once

#include <cstdint>

#include "core/base/hash.h"

namespace loomlight {

/// Coordinates of the points of a low-discrepancy sequence in any number of dimensions: each two of them, 2j and 2j +
/// 1, are a (0,2)-sequence (the first two dimensions of Sobol 1967), visited in a shuffled order of its own, and every
/// dimension is Owen-scrambled, so that each point is uniform and any estimate made with them unbiased. Shuffling and
/// scrambling are one kind of hash (Laine and Karras 2011; Burley 2020, "Practical hash-based Owen scrambling").
/// Of the first 2^k points each of the 2^k elementary intervals of a pair holds exactly one, for every k.
namespace stratified {

constexpr uint32_t reverseBits(uint32_t x) {
  x = (x >> 16) | (x << 16);
  x = ((x >> 8) & 0x00FF00FFu) | ((x & 0x00FF00FFu) << 8);
  x = ((x >> 4) & 0x0F0F0F0Fu) | ((x & 0x0F0F0F0Fu) << 4);
  x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
  return ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
}

/// A bijection in which a bit depends on itself and lower ones only: on reversed bits, a nested permutation of halves,
/// quarters, eighths ... The even factors are fractional bits of square roots.
constexpr uint32_t permuteNested(uint32_t reversed, uint32_t seed) {
  uint32_t x = reversed + seed;
  x ^= x * 0x6A09E666u;
  x *= (seed >> 16) | 1u;
  x ^= x * 0xBB67AE84u;
  x ^= x * 0x3C6EF372u;
  return x;
}

/// The second Sobol dimension of point `index`, bits reversed: its generator matrix is Pascal's triangle modulo two,
/// and by Lucas's theorem the sum runs over all sets of index bits that contain a bit's own.
constexpr uint32_t pascal(uint32_t index) {
  index ^= (index >> 1) & 0x55555555u;
  index ^= (index >> 2) & 0x33333333u;
  index ^= (index >> 4) & 0x0F0F0F0Fu;
  index ^= (index >> 8) & 0x00FF00FFu;
  return index ^ ((index >> 16) & 0x0000FFFFu);
}

/// What the coordinates of two dimensions have in common: a point of a sequence that belongs to `seed`.
struct PairOfDimensions {
  uint64_t hash;
  uint32_t shuffled;  ///< the index
  constexpr PairOfDimensions(uint64_t seed, uint32_t index, uint32_t dimension)
      : hash(mixBits(seed ^ (dimension >> 1))),
        shuffled(reverseBits(permuteNested(reverseBits(index), static_cast<uint32_t>(hash)))) {}

  /// 32 bits of the first of both, or the second.
  constexpr uint32_t coordinate(uint32_t which) const {
    const auto ofDimension = static_cast<uint32_t>(mixBits(hash + 1 + which) >> 32);
    // The first dimension is the index, its bits reversed: reversed again it is the index itself.
    return reverseBits(permuteNested(which ? pascal(shuffled) : shuffled, ofDimension));
  }
};

/// 32 bits of coordinate `dimension` of point `index` of the sequence that belongs to `seed`.
constexpr uint32_t coordinate(uint64_t seed, uint32_t index, uint32_t dimension) {
  return PairOfDimensions(seed, index, dimension).coordinate(dimension & 1);
}

}  // namespace stratified
}  // namespace loomlight
