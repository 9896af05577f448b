#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/fabric/fabric.h"

namespace loomlight {

/// A triangle mesh that cloth lies on: positions in mm, texture coordinates in mm of cloth (x along the weft, y along
/// the warp). Seams (one position, two texture coordinates) split vertices.
struct DrapeMesh {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;      ///< unit, smooth, pointing to the cloth's face
  std::vector<glm::vec2> uv_mm;
  std::vector<glm::uvec3> triangles;
  std::vector<std::string> repairs;    ///< what was mended or left out, in words for the user
};

/// The surface a fabric asks for: generated (flat, cylinder, sphere) or loaded. Throws InputError for a mesh that cannot
/// be used, naming file, place and what was expected.
DrapeMesh makeDrape(const Drape& drape);
DrapeMesh loadDrapeMesh(const std::string& file, double uvScale_mm);

/// The cloth's slab, bent onto a drape: every triangle, offset to both sides by half the thickness, is a prism of three
/// tetrahedra, split consistently so that neighbours share faces. In a tetrahedron the map from world to cloth is
/// affine, so rays stay straight and keep their parameter. Immutable.
class Shell {
 public:
  struct Tet {
    uint32_t vertex[4];
    int32_t neighbour[4];       ///< tetrahedron across the face opposite vertex i; -1: the boundary
    glm::mat3 toCloth;          ///< cloth = toCloth * world + offset
    glm::vec3 offset;
    glm::vec4 plane[4];         ///< inward normal and distance of the face opposite vertex i: dot(n, x) + w >= 0 inside
  };
  struct BoundaryFace {
    uint32_t vertex[3];         ///< counter-clockwise seen from outside
    uint32_t tet;
  };

  /// `uv` beyond [0, width] x [0, height] is cloth too if the mesh has it; the piece is made as large as the uv range.
  /// Prisms that thickness times curvature would turn inside out are thinned until they do not, and say so in repairs.
  Shell(const DrapeMesh& mesh, double halfThickness_mm);

  /// A flat drape is no mesh at all: world and cloth space differ by a translation, and one box holds everything.
  static Shell flat(double width_mm, double height_mm, double halfThickness_mm);
  bool isFlat() const { return tets_.empty(); }

  std::span<const Tet> tets() const { return tets_; }
  std::span<const glm::vec3> vertices() const { return vertices_; }
  std::span<const BoundaryFace> boundary() const { return boundary_; }

  /// The cloth's coordinates that the shell uses, mm: how large the piece must be, and which uv is its corner.
  glm::vec2 uvLower_mm() const { return uvLower_; }
  glm::vec2 uvUpper_mm() const { return uvUpper_; }
  const std::vector<std::string>& repairs() const { return repairs_; }
  glm::vec3 lower_mm() const;    ///< world bounds
  glm::vec3 upper_mm() const;

  glm::vec3 toCloth(int tet, glm::vec3 world) const;
  /// d world / d cloth at a point, interpolated smoothly over the surface from the vertices' frames (never constant per
  /// tetrahedron, so highlights show no facets). Tangents transform by it; its determinant scales densities.
  glm::mat3 frame(int tet, glm::vec3 world) const;
  /// Parameter at which a ray from inside leaves the tetrahedron, and the face (0..3) it leaves through.
  float exit(int tet, glm::vec3 origin, glm::vec3 direction, int& face) const;

 private:
  Shell() = default;
  std::vector<glm::vec3> vertices_;
  std::vector<glm::mat3> vertexFrames_;
  std::vector<Tet> tets_;
  std::vector<BoundaryFace> boundary_;
  std::vector<std::string> repairs_;
  glm::vec2 uvLower_{0}, uvUpper_{0};
  glm::vec3 lower_{0}, upper_{0};
  glm::vec3 flatOffset_{0};
};

}  // namespace loomlight
