#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace loomlight {

/// A kind of yarn among others: red, green and blue from 0 to 1, and how else it differs.
using YarnPoint = std::array<double, 5>;

double distanceOf(const YarnPoint& a, const YarnPoint& b);

/// For each of the points the one of at most `most` of them that stands for it, itself for those that are kept. The
/// first is kept; `points` and `most` not empty. No point is further from its stand-in than twice the least that is
/// possible (Gonzalez 1985: each next one kept is the furthest from all that are).
std::vector<size_t> standIns(std::span<const YarnPoint> points, size_t most);

}  // namespace loomlight
