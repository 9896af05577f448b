#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "core/shell/drape_mesh.h"
#include "core/shell/mesh_topology.h"

namespace loomlight {

/// A drape, and which of its triangles meet: all of a shell that does not depend on how thick the cloth is.
struct DrapeSurface {
  /// Cost: two sorts, of the vertices and of the triangles' sides.
  explicit DrapeSurface(DrapeMesh drape)
      : mesh(std::move(drape)), welded(weldByPosition(mesh.positions)), sides(sortedSides(mesh.triangles, welded)) {}

  size_t bytes() const {
    return mesh.positions.size() * (sizeof(glm::vec3) * 2 + sizeof(glm::vec2) + sizeof(uint32_t)) +
           mesh.triangles.size() * (sizeof(glm::uvec3) + 3 * sizeof(TriangleSide));
  }

  DrapeMesh mesh;
  std::vector<uint32_t> welded;     ///< weldByPosition() of its vertices
  std::vector<TriangleSide> sides;  ///< sortedSides() of its triangles
};

}  // namespace loomlight
