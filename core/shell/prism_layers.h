#pragma once

#include <string>
#include <vector>

#include "core/shell/drape_mesh.h"

namespace loomlight {

/// The two faces of the cloth about its middle surface, one point each for every vertex of the mesh. Vertices that are
/// welded have bitwise equal points.
struct PrismLayers {
  std::vector<glm::vec3> lower, upper;
  std::vector<glm::vec3> normals;   ///< unit; equal for welded vertices
  std::vector<uint32_t> triangles;  ///< those that carry a prism: indices into DrapeMesh::triangles
  std::vector<std::string> repairs;
};

/// Offsets the mesh by +-halfThickness along its normals. Where thickness times curvature would turn a prism inside
/// out, the layers are drawn together until each of its tetrahedra keeps a tenth of its flat volume; a triangle that no
/// thickness can save (normals more than a right angle from it, or mirrored texture coordinates) carries no cloth.
PrismLayers offsetLayers(const DrapeMesh& mesh, const std::vector<uint32_t>& welded, double halfThickness_mm);

}  // namespace loomlight
