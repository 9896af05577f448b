#pragma once

#include <cassert>
#include <cstddef>

#include "core/base/simd.h"

namespace loomlight {

/// A number for each of `count` lanes, at least one; those beyond are like the last that is in use. `number` may be
/// asked for the same more than once.
template <class T, class Number>
T columnOf(size_t count, Number&& number) {
  constexpr auto kMost = static_cast<size_t>(kLanes<T>);
  assert(0 < count && count <= kMost);
  T lanes{};
  for (size_t lane = 0; lane < kMost; ++lane) lanes[lane] = number(lane < count ? lane : count - 1);
  return lanes;
}

/// The same of vectors, which have members x, y and z.
template <class T, class Vector>
Vec3Of<T> columnsOf(size_t count, Vector&& vector) {
  constexpr auto kMost = static_cast<size_t>(kLanes<T>);
  assert(0 < count && count <= kMost);
  Vec3Of<T> lanes{};
  for (size_t lane = 0; lane < kMost; ++lane) {
    const auto v = vector(lane < count ? lane : count - 1);
    lanes.x[lane] = v.x;
    lanes.y[lane] = v.y;
    lanes.z[lane] = v.z;
  }
  return lanes;
}

}  // namespace loomlight
