#pragma once

#include <functional>

#include "core/base/units.h"
#include "core/shell/drape_mesh.h"

namespace loomlight {

// What drapes that are made rather than read are made of.

/// How long the facets are across a bend, mm. None lies further than 4 um, a third of a fibre, from the smooth surface,
/// or else turns by more than 1.5 degrees; and none turns by more than 8 degrees. Finer ones would show nothing more,
/// and where they are narrower than the cloth is thick, a ray crosses more of them than voxels.
double facetAcross(double radius_mm);

inline constexpr int kMaxDrapeCells = 200000;
/// Cells straight along an axis may be long, but beyond this ratio their planes lose precision.
inline constexpr double kMaxCellAspect = 64.0;

struct SurfacePoint {
  glm::dvec3 position;
  glm::dvec3 normal;
};

/// A grid of `columns` x `rows` cells over the swatch [0, width] x [0, height], mapped by `surface`.
DrapeMesh gridMesh(double width, double height, int columns, int rows,
                   const std::function<SurfacePoint(glm::dvec2 uv)>& surface);

/// How many cells of about that size, at least 1.
int cellsFor(double length, double cell, int limit);

}  // namespace loomlight
