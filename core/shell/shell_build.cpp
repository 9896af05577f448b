#include <fmt/core.h>

#include <algorithm>
#include <limits>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/shell/drape_surface.h"
#include "core/shell/prism.h"
#include "core/shell/prism_layers.h"
#include "core/shell/shell.h"

// How it works. Every triangle of the drape is offset to both sides and becomes a prism, which is cut into three
// tetrahedra such that neighbours cut the face between them along the same diagonal (prism.h). A tetrahedron maps
// affinely from the world to the cloth. Its four planes are computed from vertices in one order, so that two neighbours
// see the very same plane; faces without a neighbour are the boundary that rays enter by.

namespace loomlight {
namespace {

constexpr size_t kChunk = 4096;

/// body(i) for all i in [0, count), in parallel; i are small pieces of work.
template <class Body>
void forAll(size_t count, Body body) {
  parallelFor((count + kChunk - 1) / kChunk, 0, [&](size_t chunk) {
    for (size_t i = chunk * kChunk; i < std::min(count, (chunk + 1) * kChunk); ++i) body(i);
  });
}

/// Plane through three points, normal of unit length; computed in double, since both tetrahedra of the face rely on it.
glm::dvec4 planeThrough(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
  const glm::dvec3 normal = glm::normalize(glm::cross(b - a, c - a));
  return {normal, -glm::dot(normal, (a + b + c) / 3.0)};
}

/// Planes, turned inward. The vertices of a face have the same order and positions in both of its tetrahedra (prism.h),
/// so the two get the same numbers but for the sign.
void setPlanes(Shell::Tet& tet, const glm::dvec3 (&corner)[4]) {
  for (int i = 0; i < 4; ++i) {
    const glm::dvec4 plane = planeThrough(corner[i == 0 ? 1 : 0], corner[i <= 1 ? 2 : 1], corner[i <= 2 ? 3 : 2]);
    const bool inward = glm::dot(glm::dvec3(plane), corner[i]) + plane.w > 0;
    const glm::vec4 rounded(plane);
    tet.plane.set(i, inward ? rounded : -rounded);
  }
  for (int i = 0; i < 4; ++i) tet.height[i] = tet.plane.heights(glm::vec3(corner[i]))[i];
}

void setMap(Shell::Tet& tet, const glm::dvec3 (&world)[4], const glm::dvec3 (&cloth)[4]) {
  const glm::dmat3 worldEdges(world[1] - world[0], world[2] - world[0], world[3] - world[0]);
  const glm::dmat3 clothEdges(cloth[1] - cloth[0], cloth[2] - cloth[0], cloth[3] - cloth[0]);
  const glm::dmat3 map = clothEdges * glm::inverse(worldEdges);
  tet.toCloth = glm::mat3(map);
  tet.offset = glm::vec3(cloth[0] - map * world[0]);
}

/// d world / d cloth at every vertex of both layers. The tangents are the mean Jacobian of the triangles about the
/// vertex on its own layer (weighted by area in the cloth), laid into the smooth tangent plane, so that vertices on the
/// two sides of a seam agree on it; the third column is the line from the lower to the upper layer.
std::vector<glm::mat3> framesOf(const DrapeMesh& mesh, const PrismLayers& layers, double halfThickness) {
  struct Sum {
    glm::dvec3 u{0}, v{0};
    double area = 0;
  };
  std::vector<Sum> sums(2 * mesh.positions.size());
  for (const uint32_t index : layers.triangles) {
    const glm::uvec3 triangle = mesh.triangles[index];
    const glm::dvec2 u1 = mesh.uv_mm[triangle[1]] - mesh.uv_mm[triangle[0]];
    const glm::dvec2 u2 = mesh.uv_mm[triangle[2]] - mesh.uv_mm[triangle[0]];
    for (uint32_t layer = 0; layer < 2; ++layer) {
      const std::vector<glm::vec3>& points = layer == 0 ? layers.lower : layers.upper;
      const glm::dvec3 e1 = points[triangle[1]] - points[triangle[0]];
      const glm::dvec3 e2 = points[triangle[2]] - points[triangle[0]];
      for (int corner = 0; corner < 3; ++corner) {
        Sum& sum = sums[2 * triangle[corner] + layer];
        sum.u += e1 * u2.y - e2 * u1.y;
        sum.v += e2 * u1.x - e1 * u2.x;
        sum.area += u1.x * u2.y - u1.y * u2.x;
      }
    }
  }
  std::vector<glm::mat3> frames(sums.size(), glm::mat3(1));
  for (size_t i = 0; i < sums.size(); ++i) {
    if (!(sums[i].area > 0)) continue;  // no triangle uses the vertex
    const glm::dvec3 normal(layers.normals[i / 2]);
    const auto laid = [&](glm::dvec3 tangent) {
      const glm::dvec3 flat = tangent - normal * glm::dot(normal, tangent);
      const double length = glm::length(flat);
      return length > 0 ? flat * (glm::length(tangent) / length) : tangent;
    };
    const glm::dvec3 across = glm::dvec3(layers.upper[i / 2] - layers.lower[i / 2]) / (2 * halfThickness);
    frames[i] = glm::mat3(laid(sums[i].u / sums[i].area), laid(sums[i].v / sums[i].area), across);
  }
  return frames;
}

}  // namespace

Shell::Shell(const DrapeSurface& surface, double halfThickness_mm) : repairs_(surface.mesh.repairs) {
  const DrapeMesh& mesh = surface.mesh;
  halfThickness_mm_ = static_cast<float>(halfThickness_mm);
  const PrismLayers layers = offsetLayers(mesh, surface.welded, halfThickness_mm);
  repairs_.insert(repairs_.end(), layers.repairs.begin(), layers.repairs.end());
  if (layers.triangles.empty())
    throw InputError(
        fmt::format("{}: expected triangles that can carry cloth {:.3g} mm thick; all {} are creased too sharply",
                    mesh.name, 2 * halfThickness_mm, mesh.triangles.size()));

  vertices_.reserve(2 * mesh.positions.size());
  for (size_t i = 0; i < mesh.positions.size(); ++i) {
    vertices_.push_back(layers.lower[i]);
    vertices_.push_back(layers.upper[i]);
  }
  vertexFrames_ = framesOf(mesh, layers, halfThickness_mm);

  uvLower_ = glm::vec2(std::numeric_limits<float>::max());
  uvUpper_ = -uvLower_;
  lower_ = glm::vec3(std::numeric_limits<float>::max());
  upper_ = -lower_;
  for (const uint32_t triangle : layers.triangles) {
    for (int corner = 0; corner < 3; ++corner) {
      const uint32_t vertex = mesh.triangles[triangle][corner];
      uvLower_ = glm::min(uvLower_, mesh.uv_mm[vertex]);
      uvUpper_ = glm::max(uvUpper_, mesh.uv_mm[vertex]);
      lower_ = glm::min(lower_, glm::min(layers.lower[vertex], layers.upper[vertex]));
      upper_ = glm::max(upper_, glm::max(layers.lower[vertex], layers.upper[vertex]));
    }
  }
  addPrisms(surface, layers.triangles);
  linkSides(surface, layers.triangles);
  collectBoundary();
}

void Shell::addPrisms(const DrapeSurface& surface, std::span<const uint32_t> triangles) {
  const DrapeMesh& mesh = surface.mesh;
  tets_.resize(3 * triangles.size());
  forAll(triangles.size(), [&](size_t prism) {
    const glm::uvec3 triangle = mesh.triangles[triangles[prism]];
    const std::array<int, 3> order = sortedCorners(triangle, surface.welded);
    for (int k = 0; k < 3; ++k) {
      Tet& tet = tets_[3 * prism + static_cast<size_t>(k)];
      glm::dvec3 world[4], cloth[4];
      for (int i = 0; i < 4; ++i) {
        const int corner = kPrismTets[k][i];
        const uint32_t vertex = triangle[order[corner % 3]];
        tet.vertex[i] = 2 * vertex + (corner >= 3 ? 1 : 0);
        world[i] = vertices_[tet.vertex[i]];
        cloth[i] = {glm::dvec2(mesh.uv_mm[vertex]) - glm::dvec2(uvLower_),
                    corner >= 3 ? halfThickness_mm_ : -halfThickness_mm_};
        const PrismFace face = kPrismFaces[k][i];
        tet.neighbour[i] = face.kind == PrismFace::Kind::inner ? static_cast<int32_t>(3 * prism + face.target) : -1;
      }
      setPlanes(tet, world);
      setMap(tet, world, cloth);
    }
  });
}

void Shell::linkSides(const DrapeSurface& surface, std::span<const uint32_t> triangles) {
  constexpr int32_t kNone = -1;  // a triangle that carries no cloth
  std::vector<int32_t> prismOf(surface.mesh.triangles.size(), kNone);
  for (size_t prism = 0; prism < triangles.size(); ++prism) prismOf[triangles[prism]] = static_cast<int32_t>(prism);

  // The tetrahedra at the two triangles of a side, and the face (0..3) of each.
  struct TetFace {
    int32_t tet;
    int face;
  };
  const auto faceOf = [&](const TriangleSide& side, int upper) {
    const std::array<int, 3> order = sortedCorners(surface.mesh.triangles[side.triangle], surface.welded);
    const auto rank = [&](int corner) {
      return static_cast<int>(std::find(order.begin(), order.end(), corner) - order.begin());
    };
    const int which = sideBetween(rank(side.corner), rank((side.corner + 1) % 3));
    const int k = kSideTets[which][upper];
    int face = 0;
    while (kPrismFaces[k][face].kind != PrismFace::Kind::side || kPrismFaces[k][face].target != which ||
           kPrismFaces[k][face].upper != upper)
      ++face;
    return TetFace{3 * prismOf[side.triangle] + k, face};
  };
  // Anything but two triangles that run the edge in opposite directions is no surface there: the cloth ends.
  std::vector<TriangleSide> carrying;
  forEachEdge(surface.sides, [&](std::span<const TriangleSide> edge) {
    carrying.clear();
    for (const TriangleSide& side : edge)
      if (prismOf[side.triangle] != kNone) carrying.push_back(side);
    if (carrying.size() != 2 || carrying[0].forward == carrying[1].forward) return;
    for (int upper = 0; upper < 2; ++upper) {
      const TetFace a = faceOf(carrying[0], upper), b = faceOf(carrying[1], upper);
      tets_[static_cast<size_t>(a.tet)].neighbour[a.face] = b.tet;
      tets_[static_cast<size_t>(b.tet)].neighbour[b.face] = a.tet;
    }
  });
}

void Shell::collectBoundary() {
  for (size_t i = 0; i < tets_.size(); ++i) {
    const Tet& tet = tets_[i];
    for (int face = 0; face < 4; ++face) {
      if (tet.neighbour[face] >= 0) continue;
      BoundaryFace out{{tet.vertex[face == 0 ? 1 : 0], tet.vertex[face <= 1 ? 2 : 1], tet.vertex[face <= 2 ? 3 : 2]},
                       static_cast<uint32_t>(i)};
      const glm::vec3 a = vertices_[out.vertex[0]];
      const glm::vec3 normal = glm::cross(vertices_[out.vertex[1]] - a, vertices_[out.vertex[2]] - a);
      if (glm::dot(normal, glm::vec3(tet.plane[face])) > 0) std::swap(out.vertex[1], out.vertex[2]);
      boundary_.push_back(out);
    }
  }
}

glm::vec3 Shell::lower_mm() const {
  return lower_;
}
glm::vec3 Shell::upper_mm() const {
  return upper_;
}

}  // namespace loomlight
