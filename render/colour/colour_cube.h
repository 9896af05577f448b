#pragma once

#include <glm/glm.hpp>

#include <span>
#include <vector>

#include "core/base/units.h"

namespace loomlight {

/// A map of sRGB-encoded colours that is known at the corners of a grid and linear between them, as a graphics card
/// looks it up. Corners lie closer together in the dark, where tone curves of displays bend most: corner i of a channel
/// is at (i / (kSide - 1))^2. 1.1 MB for half floats, 2.3 for floats. Immutable.
class ColourCube {
 public:
  static constexpr int kSide = 33;

  /// Where a corner lies, in [0, 1]; the inverse is the square root.
  static float cornerAt(int i) {
    const float u = static_cast<float>(i) / static_cast<float>(kSide - 1);
    return u * u;
  }

  /// kSide^3 values, red the fastest.
  explicit ColourCube(std::vector<glm::vec4> corners);

  /// Trilinear; colours are clamped to [0, 1]. The fourth number is what the maker of the cube says it is.
  glm::vec4 at(const Rgb& encoded) const;
  std::span<const glm::vec4> corners() const { return corners_; }

 private:
  std::vector<glm::vec4> corners_;
};

}  // namespace loomlight
