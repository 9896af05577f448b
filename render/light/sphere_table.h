#pragma once

#include <cstdint>
#include <vector>

#include "core/base/random.h"
#include "render/light/lat_long.h"

namespace loomlight {

/// Chooses directions in proportion to values tabulated over the lat-long rectangle: a row by its share, a cell in the
/// row by its share, a direction in the cell with uniform density per solid angle. Shares are integers, 2^31 of them,
/// drawn with 31 random bits, so that pdf() is the density of sample() exactly; cells with less than half a share are
/// never drawn and have pdf 0. Four bytes a cell.
class SphereTable {
 public:
  /// `radiance`: mean radiance of each cell, finite and >= 0, row by row from the zenith. All zero: uniform.
  SphereTable(int width, int height, const std::vector<float>& radiance);

  struct Sample {
    glm::vec3 direction;
    float pdf;  ///< per solid angle, > 0
  };
  Sample sample(Random& random) const;
  float pdf(glm::vec3 d) const;  ///< per solid angle
  /// Integral of the radiance over the sphere.
  double power() const { return power_; }

 private:
  float cellPdf(int x, int y) const;
  const uint32_t* row(int y) const { return &cells_[static_cast<size_t>(y) * static_cast<size_t>(width_)]; }

  int width_, height_;
  double power_ = 0;
  std::vector<uint32_t> rows_;   ///< cumulative shares
  std::vector<uint32_t> cells_;  ///< cumulative shares within each row
  std::vector<float> cosines_;   ///< of the edges of the rows, height + 1
};

}  // namespace loomlight
