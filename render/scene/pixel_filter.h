#pragma once

#include <cmath>
#include <glm/vec2.hpp>

namespace loomlight {

/// What a pixel is the mean of: places about its centre, the fewer the farther away, up to a whole pixel on each side.
/// Samples are spread so, rather than weighted: each counts alike, and no two pixels share one (filter importance
/// sampling; pbrt's TriangleFilter).
///
/// Of a pattern as fine as the pixels, such as threads seen from afar, the mean over a pixel's own square would leave
/// sinc(f) as moire, f: its cycles a pixel; at 2.5 an eighth of its contrast. This leaves the square of that.
struct TriangleFilter {
  /// From the pixel's corner, -1/2 to 3/2 each way. `u`: in [0, 1), evenly; even strata of it stay strata.
  static glm::vec2 sample(glm::vec2 u) { return {offset(u.x), offset(u.y)}; }

 private:
  static float offset(float u) { return u < 0.5f ? std::sqrt(2 * u) - 0.5f : 1.5f - std::sqrt(2 * (1 - u)); }
};

}  // namespace loomlight
