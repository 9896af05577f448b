#include "core/shell/mesh_repair.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "core/base/error.h"
#include "core/shell/mesh_topology.h"

// How it works. In order: vertices at one place are welded; triangles without texture coordinates, or without area in
// the world or in the texture, are left out; each connected piece is wound one way, the way of most of its triangles,
// by walking from neighbour to neighbour; pieces whose texture is mirrored are mirrored back, and triangles that are
// folded over in it are left out; vertices are split where the texture has seams; normals are means over the triangles
// around, weighted by their angle. What was done is said in a list, for the user.

namespace loomlight {
namespace {

constexpr double kLargest_mm = 1e5;
/// Triangles thinner than this, area over squared longest side, are lines as far as float can tell.
constexpr double kThinnestTriangle = 1e-6;
/// Mean stretch of the mesh against its texture that is worth a word.
constexpr double kStretchWorthNoting = 1.5;

double doubleArea(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
  return glm::length(glm::cross(b - a, c - a));
}
double signedDoubleArea(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}
template <class Vec>
bool isLine(double doubledArea, const Vec& a, const Vec& b, const Vec& c) {
  const double longest = std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
  return !(doubledArea > kThinnestTriangle * longest * longest);
}

class Repair {
 public:
  Repair(const std::string& file, const MeshFile& mesh, double uvScale)
      : file_(file), source_(mesh), uvScale_(uvScale) {}

  DrapeMesh run() {
    out_.name = file_;
    if (source_.triangles.empty()) throw InputError(fmt::format("{}: expected a mesh with triangles, got none", file_));
    centrePositions();
    keepTriangles();
    orient();
    unmirror();
    splitVertices();
    computeNormals();
    noteStretch();
    return std::move(out_);
  }

 private:
  struct Triangle {
    glm::uvec3 vertex;  ///< welded
    glm::dvec2 uv[3];

    double uvArea() const { return signedDoubleArea(uv[0], uv[1], uv[2]); }
    void turnOver() {
      std::swap(vertex[1], vertex[2]);
      std::swap(uv[1], uv[2]);
    }
  };

  template <class... Args>
  void say(size_t count, fmt::format_string<Args...> text, Args&&... args) {
    if (count > 0) out_.repairs.push_back(file_ + ": " + fmt::format(text, std::forward<Args>(args)...));
  }

  void centrePositions() {
    glm::dvec3 lower(std::numeric_limits<double>::max()), upper(-lower);
    for (const MeshFile::Triangle& triangle : source_.triangles)
      for (const uint32_t vertex : triangle.vertex) {
        lower = glm::min(lower, glm::dvec3(source_.positions[vertex]));
        upper = glm::max(upper, glm::dvec3(source_.positions[vertex]));
      }
    const glm::dvec3 size = upper - lower;
    if (std::max({size.x, size.y, size.z}) > kLargest_mm)
      throw InputError(fmt::format("{}: expected a mesh of at most {:g} mm, got {:.4g} x {:.4g} x {:.4g} mm", file_,
                                   kLargest_mm, size.x, size.y, size.z));
    for (const glm::vec3& position : source_.positions)
      positions_.emplace_back(glm::dvec3(position) - (lower + upper) / 2.0);
    // Vertices that no triangle uses may lie anywhere; they must not upset the sorting.
    for (glm::vec3& position : positions_)
      if (!(glm::length(position) < 1e6f)) position = glm::vec3(0);
    welded_ = weldByPosition(positions_);
  }

  void keepTriangles() {
    size_t bare = 0, flat = 0, flatUv = 0;
    for (const MeshFile::Triangle& source : source_.triangles) {
      if (!source.hasUv) {
        ++bare;
        continue;
      }
      Triangle triangle{};
      for (int k = 0; k < 3; ++k) {
        triangle.vertex[k] = welded_[source.vertex[static_cast<size_t>(k)]];
        triangle.uv[k] = glm::dvec2(source.uv[static_cast<size_t>(k)]) * uvScale_;
      }
      const glm::dvec3 a(positions_[triangle.vertex[0]]), b(positions_[triangle.vertex[1]]),
          c(positions_[triangle.vertex[2]]);
      const bool isFlat = isLine(doubleArea(a, b, c), a, b, c);
      const bool isFlatUv = isLine(std::abs(triangle.uvArea()), triangle.uv[0], triangle.uv[1], triangle.uv[2]);
      flat += isFlat;
      flatUv += !isFlat && isFlatUv;
      if (!isFlat && !isFlatUv) triangles_.push_back(triangle);
    }
    const size_t all = source_.triangles.size();
    if (bare == all)
      throw InputError(
          fmt::format("{}: no texture coordinates; expected them at every corner, x along the weft and y "
                      "along the warp",
                      file_));
    if (triangles_.empty())
      throw InputError(
          fmt::format("{}: expected triangles with area in the world and in texture space; of {}, {} have "
                      "none in the world, {} none in texture space",
                      file_, all, flat, flatUv));
    say(bare, "{} of {} triangles have no texture coordinates and are left out", bare, all);
    say(flat, "{} of {} triangles have no area and are left out", flat, all);
    say(flatUv, "{} of {} triangles have no area in texture space and are left out", flatUv, all);
  }

  /// For every triangle the neighbours across edges that exactly two share. `nonManifoldEdges`: how many more than two
  /// share.
  struct Neighbour {
    uint32_t triangle;
    bool agrees;  ///< wound alike
    bool sameUv;
  };
  std::vector<std::vector<Neighbour>> neighbours(size_t& nonManifoldEdges) const {
    std::vector<glm::uvec3> corners;
    corners.reserve(triangles_.size());
    for (const Triangle& triangle : triangles_) corners.push_back(triangle.vertex);
    std::vector<uint32_t> identity(positions_.size());
    for (uint32_t i = 0; i < identity.size(); ++i) identity[i] = i;

    std::vector<std::vector<Neighbour>> result(triangles_.size());
    nonManifoldEdges = 0;
    const std::vector<TriangleSide> sides = sortedSides(corners, identity);
    forEachEdge(sides, [&](std::span<const TriangleSide> edge) {
      nonManifoldEdges += edge.size() > 2;
      if (edge.size() != 2) return;
      const bool agrees = edge[0].forward != edge[1].forward;
      const bool sameUv = uvAt(edge[0], true) == uvAt(edge[1], true) && uvAt(edge[0], false) == uvAt(edge[1], false);
      result[edge[0].triangle].push_back({edge[1].triangle, agrees, sameUv});
      result[edge[1].triangle].push_back({edge[0].triangle, agrees, sameUv});
    });
    return result;
  }

  glm::dvec2 uvAt(const TriangleSide& side, bool low) const {
    const int corner = low == side.forward ? side.corner : (side.corner + 1) % 3;
    return triangles_[side.triangle].uv[corner];
  }

  /// Calls piece(indices) for every set of triangles connected by `linked` neighbours; visit(from, to, neighbour) on
  /// the way, for every tree edge.
  template <class Linked, class Visit, class Piece>
  void forEachPiece(const std::vector<std::vector<Neighbour>>& graph, Linked linked, Visit visit, Piece piece) {
    std::vector<char> seen(graph.size(), 0);
    std::vector<uint32_t> members;
    for (uint32_t seed = 0; seed < graph.size(); ++seed) {
      if (seen[seed]) continue;
      members.assign(1, seed);
      seen[seed] = 1;
      for (size_t i = 0; i < members.size(); ++i) {
        const uint32_t from = members[i];
        for (const Neighbour& next : graph[from]) {
          if (seen[next.triangle] || !linked(next)) continue;
          seen[next.triangle] = 1;
          visit(from, next);
          members.push_back(next.triangle);
        }
      }
      piece(members);
    }
  }

  void orient() {
    size_t crowded = 0, turned = 0;
    const auto graph = neighbours(crowded);
    std::vector<char> flip(triangles_.size(), 0);
    forEachPiece(
        graph, [](const Neighbour&) { return true; },
        [&](uint32_t from, const Neighbour& next) { flip[next.triangle] = next.agrees ? flip[from] : !flip[from]; },
        [&](const std::vector<uint32_t>& members) {
          size_t flipped = 0;
          for (const uint32_t member : members) flipped += flip[member];
          const bool most = 2 * flipped > members.size();
          for (const uint32_t member : members) {
            if (bool(flip[member]) == most) continue;
            triangles_[member].turnOver();
            ++turned;
          }
        });
    say(crowded, "{} edges are shared by more than two triangles; the cloth ends there", crowded);
    say(turned, "{} of {} triangles were wound against their neighbours and are turned over", turned,
        triangles_.size());
  }

  void unmirror() {
    size_t crowded = 0, mirrored = 0, pieces = 0;
    const auto graph = neighbours(crowded);
    forEachPiece(
        graph, [](const Neighbour& next) { return next.sameUv; }, [](uint32_t, const Neighbour&) {},
        [&](const std::vector<uint32_t>& members) {
          ++pieces;
          double area = 0, least = std::numeric_limits<double>::max(), most = -least;
          for (const uint32_t member : members) {
            area += triangles_[member].uvArea();
            for (const glm::dvec2& uv : triangles_[member].uv) {
              least = std::min(least, uv.x);
              most = std::max(most, uv.x);
            }
          }
          if (area >= 0) return;
          ++mirrored;
          for (const uint32_t member : members)
            for (glm::dvec2& uv : triangles_[member].uv) uv.x = least + most - uv.x;
        });
    say(mirrored, "texture coordinates of {} of {} pieces were mirrored and are mirrored back", mirrored, pieces);

    const size_t before = triangles_.size();
    std::erase_if(triangles_, [](const Triangle& triangle) { return !(triangle.uvArea() > 0); });
    say(before - triangles_.size(), "{} of {} triangles are folded over in texture space and are left out",
        before - triangles_.size(), before);
  }

  /// One vertex for every position and texture coordinate.
  void splitVertices() {
    glm::dvec2 lower(std::numeric_limits<double>::max()), upper(-lower);
    struct Corner {
      uint32_t welded;
      glm::vec2 uv;
      size_t place;  ///< 3 x triangle + corner
    };
    std::vector<Corner> corners;
    corners.reserve(3 * triangles_.size());
    for (size_t i = 0; i < triangles_.size(); ++i)
      for (int k = 0; k < 3; ++k) {
        lower = glm::min(lower, triangles_[i].uv[k]);
        upper = glm::max(upper, triangles_[i].uv[k]);
        corners.push_back({triangles_[i].vertex[k], glm::vec2(triangles_[i].uv[k]), 3 * i + static_cast<size_t>(k)});
      }
    if (!(std::max(upper.x - lower.x, upper.y - lower.y) <= kLargest_mm))
      throw InputError(
          fmt::format("{}: expected cloth of at most {:g} mm, but texture coordinates times drape.uv_scale_mm "
                      "({:g}) make {:.4g} x {:.4g} mm",
                      file_, kLargest_mm, uvScale_, upper.x - lower.x, upper.y - lower.y));
    std::sort(corners.begin(), corners.end(), [](const Corner& a, const Corner& b) {
      return std::tie(a.welded, a.uv.x, a.uv.y, a.place) < std::tie(b.welded, b.uv.x, b.uv.y, b.place);
    });
    out_.triangles.resize(triangles_.size());
    for (size_t i = 0; i < corners.size(); ++i) {
      const Corner& corner = corners[i];
      if (i == 0 || corner.welded != corners[i - 1].welded || corner.uv != corners[i - 1].uv) {
        out_.positions.push_back(positions_[corner.welded]);
        out_.uv_mm.push_back(corner.uv);
      }
      out_.triangles[corner.place / 3][static_cast<int>(corner.place % 3)] =
          static_cast<uint32_t>(out_.positions.size() - 1);
    }
  }

  void computeNormals() {
    const std::vector<uint32_t> welded = weldByPosition(out_.positions);
    std::vector<glm::dvec3> sums(out_.positions.size(), glm::dvec3(0));
    for (const glm::uvec3& triangle : out_.triangles) {
      glm::dvec3 corner[3];
      for (int k = 0; k < 3; ++k) corner[k] = out_.positions[triangle[k]];
      const glm::dvec3 normal = glm::normalize(glm::cross(corner[1] - corner[0], corner[2] - corner[0]));
      for (int k = 0; k < 3; ++k) {
        const glm::dvec3 a = glm::normalize(corner[(k + 1) % 3] - corner[k]);
        const glm::dvec3 b = glm::normalize(corner[(k + 2) % 3] - corner[k]);
        sums[welded[triangle[k]]] += normal * std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0));
      }
    }
    out_.normals.resize(out_.positions.size());
    for (size_t i = 0; i < out_.normals.size(); ++i) {
      const double length = glm::length(sums[welded[i]]);
      out_.normals[i] = length > 1e-9 ? glm::vec3(sums[welded[i]] / length) : glm::vec3(0, 0, 1);
    }
  }

  void noteStretch() {
    double world = 0, cloth = 0;
    for (const glm::uvec3& t : out_.triangles) {
      world += doubleArea(out_.positions[t[0]], out_.positions[t[1]], out_.positions[t[2]]);
      cloth += signedDoubleArea(out_.uv_mm[t[0]], out_.uv_mm[t[1]], out_.uv_mm[t[2]]);
    }
    const double stretch = std::sqrt(world / cloth);
    if (stretch > kStretchWorthNoting || stretch < 1 / kStretchWorthNoting)
      say(1, "the mesh is {:.3g} times as long as its cloth; drape.uv_scale_mm {:.4g} would make them equal", stretch,
          uvScale_ * stretch);
  }

  const std::string& file_;
  const MeshFile& source_;
  double uvScale_;
  std::vector<glm::vec3> positions_;
  std::vector<uint32_t> welded_;
  std::vector<Triangle> triangles_;
  DrapeMesh out_;
};

}  // namespace

DrapeMesh repairMesh(const std::string& file, const MeshFile& mesh, double uvScale_mm) {
  return Repair(file, mesh, uvScale_mm).run();
}

DrapeMesh loadDrapeMesh(const std::string& file, double uvScale_mm) {
  if (!(uvScale_mm > 0 && uvScale_mm <= 1e6))
    throw InputError(
        fmt::format("{}: drape.uv_scale_mm: expected a number above 0 and up to 1e6, got {:g}", file, uvScale_mm));
  return repairMesh(file, readMeshFile(file), uvScale_mm);
}

}  // namespace loomlight
