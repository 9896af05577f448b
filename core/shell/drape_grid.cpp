#include "core/shell/drape_grid.h"

#include <algorithm>
#include <cmath>

namespace loomlight {

double facetAcross(double radius_mm) {
  constexpr double kFinest = 1.5 * kPi / 180, kCoarsest = 8 * kPi / 180, kSagitta_mm = 0.004;
  return std::clamp(std::sqrt(8 * radius_mm * kSagitta_mm), radius_mm * kFinest, radius_mm * kCoarsest);
}

DrapeMesh gridMesh(double width, double height, int columns, int rows,
                   const std::function<SurfacePoint(glm::dvec2 uv)>& surface) {
  DrapeMesh mesh;
  for (int row = 0; row <= rows; ++row) {
    for (int column = 0; column <= columns; ++column) {
      const glm::dvec2 uv(width * column / columns, height * row / rows);
      const SurfacePoint point = surface(uv);
      mesh.positions.emplace_back(point.position);
      mesh.normals.emplace_back(point.normal);
      mesh.uv_mm.emplace_back(uv);
    }
  }
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const uint32_t corner = static_cast<uint32_t>(row * (columns + 1) + column);
      const uint32_t above = corner + static_cast<uint32_t>(columns) + 1;
      mesh.triangles.emplace_back(corner, corner + 1, above + 1);
      mesh.triangles.emplace_back(corner, above + 1, above);
    }
  }
  return mesh;
}

int cellsFor(double length, double cell, int limit) {
  return std::clamp(static_cast<int>(std::min(std::ceil(length / cell), 1e6)), 1, limit);
}

}  // namespace loomlight
