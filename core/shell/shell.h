#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

#include "core/base/simd.h"

namespace loomlight {

struct DrapeSurface;

/// The cloth's slab, bent onto a drape: every triangle, offset to both sides by half the thickness, is a prism of three
/// tetrahedra, split consistently so that neighbours share faces. In a tetrahedron the map from world to cloth is
/// affine, so rays stay straight and keep their parameter. Immutable.
///
/// A seam in texture space is no boundary in the world: its two sides have vertices of their own at equal positions,
/// and are neighbours; only the cloth's coordinates jump there. Sheets that interpenetrate stay separate: a ray walks
/// one, and meets what remains of the other after leaving it.
class Shell {
 public:
  /// The planes of a tetrahedron's faces, face i opposite vertex i, side by side: inward unit normals and distances.
  struct Planes {
    Float32x4 x, y, z, w;

    glm::vec4 operator[](int i) const { return {x[i], y[i], z[i], w[i]}; }
    void set(int i, glm::vec4 plane) {
      x[i] = plane.x;
      y[i] = plane.y;
      z[i] = plane.z;
      w[i] = plane.w;
    }
    /// How fast a point moves away from each.
    Float32x4 approach(glm::vec3 direction) const { return x * direction.x + y * direction.y + z * direction.z; }
    /// Distances of a point, >= 0 inside.
    Float32x4 heights(glm::vec3 point) const { return approach(point) + w; }
  };
  struct Tet {
    uint32_t vertex[4];
    int32_t neighbour[4];  ///< tetrahedron across the face opposite vertex i; -1: the boundary
    glm::mat3 toCloth;     ///< cloth = toCloth * world + offset
    glm::vec3 offset;
    Planes plane;
    Float32x4 height;  ///< of each vertex over the face opposite to it
  };
  struct BoundaryFace {
    uint32_t vertex[3];  ///< counter-clockwise seen from outside
    uint32_t tet;
  };

  /// `uv` beyond [0, width] x [0, height] is cloth too if the mesh has it; the piece is made as large as the uv range.
  /// Prisms that thickness times curvature would turn inside out are thinned until they do not, and say so in repairs.
  /// Throws InputError if no triangle at all can carry cloth.
  Shell(const DrapeSurface& surface, double halfThickness_mm);

  /// A flat drape is no mesh at all: world and cloth space differ by a translation, and one box holds everything.
  static Shell flat(double width_mm, double height_mm, double halfThickness_mm);
  bool isFlat() const { return tets_.empty(); }
  float thickness_mm() const { return 2 * halfThickness_mm_; }

  std::span<const Tet> tets() const { return tets_; }
  std::span<const glm::vec3> vertices() const { return vertices_; }
  std::span<const BoundaryFace> boundary() const { return boundary_; }
  size_t bytes() const;

  /// The cloth's coordinates that the shell uses, mm: how large the piece must be, and which uv is its corner.
  glm::vec2 uvLower_mm() const { return uvLower_; }
  glm::vec2 uvUpper_mm() const { return uvUpper_; }
  const std::vector<std::string>& repairs() const { return repairs_; }  ///< the mesh's own and the shell's
  glm::vec3 lower_mm() const;                                           ///< world bounds
  glm::vec3 upper_mm() const;

  /// x in [0, width], y in [0, height] counted from uvLower_mm, z in [-halfThickness, halfThickness].
  glm::vec3 toCloth(int tet, glm::vec3 world) const;
  /// d world / d cloth at a point, interpolated smoothly over the surface from the vertices' frames (never constant per
  /// tetrahedron, so highlights show no facets). Tangents transform by it; its determinant scales densities.
  glm::mat3 frame(int tet, glm::vec3 world) const;
  /// Parameter at which a ray from inside leaves the tetrahedron, and the face (0..3; 0 if flat) it leaves through.
  /// `direction` is unit. A ray that rounding has put slightly outside gets the parameter at which it should have left,
  /// which may lie a little before the one it came in with: keep the larger. The two tetrahedra of a face hold exactly
  /// opposite planes, so walking never turns round at a face.
  float exit(int tet, glm::vec3 origin, glm::vec3 direction, int& face) const;

 private:
  Shell() = default;
  void addPrisms(const DrapeSurface& surface, std::span<const uint32_t> triangles);
  void linkSides(const DrapeSurface& surface, std::span<const uint32_t> triangles);
  void collectBoundary();

  std::vector<glm::vec3> vertices_;  ///< two a mesh vertex: lower, upper
  std::vector<glm::mat3> vertexFrames_;
  std::vector<Tet> tets_;  ///< three a prism
  std::vector<BoundaryFace> boundary_;
  std::vector<std::string> repairs_;
  glm::vec2 uvLower_{0}, uvUpper_{0};
  glm::vec3 lower_{0}, upper_{0};
  float halfThickness_mm_ = 0;
};

}  // namespace loomlight
