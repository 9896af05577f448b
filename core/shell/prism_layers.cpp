#include "core/shell/prism_layers.h"

#include <fmt/core.h>

#include <algorithm>

#include "core/shell/prism.h"

// How it works. Every vertex is offset by half the thickness along its normal, to both sides; a triangle becomes a
// prism of three tetrahedra. Where the mesh bends too sharply for that thickness, a tetrahedron has hardly any volume
// left or is turned inside out. All vertices of such triangles are then made thinner by a constant factor, and all
// triangles are tested again, until none is unsound: thickness only ever shrinks, so this ends. A triangle whose
// normals point away from it, or that would have to become thinner than kThinnestLayer, is left out.

namespace loomlight {
namespace {

constexpr double kLeastVolume = 0.1;  ///< of the volume the tetrahedron would have without curvature
constexpr double kThinning = 0.85;    ///< factor a step
constexpr double kThinnestLayer = 0.02;

std::vector<glm::vec3> weldedNormals(const DrapeMesh& mesh, const std::vector<uint32_t>& welded) {
  std::vector<glm::dvec3> sums(mesh.normals.size(), glm::dvec3(0));
  for (size_t i = 0; i < mesh.normals.size(); ++i) sums[welded[i]] += glm::dvec3(mesh.normals[i]);
  std::vector<glm::vec3> normals(mesh.normals.size());
  for (size_t i = 0; i < normals.size(); ++i) {
    const glm::dvec3 sum = sums[welded[i]];
    const double length = glm::length(sum);
    // Sheets that touch back to back cancel out; one of the two normals is as good as any other then.
    normals[i] = length > 1e-3 ? glm::vec3(sum / length) : mesh.normals[welded[i]];
  }
  return normals;
}

class Thinning {
 public:
  Thinning(const DrapeMesh& mesh, const std::vector<uint32_t>& welded, double halfThickness)
      : mesh_(mesh), welded_(welded), halfThickness_(halfThickness), scale_(mesh.positions.size(), 1.0) {
    layers_.normals = weldedNormals(mesh, welded);
    layers_.lower.resize(mesh.positions.size());
    layers_.upper.resize(mesh.positions.size());
    offset();
  }

  PrismLayers run() {
    std::vector<char> dropped(mesh_.triangles.size(), 0);
    for (bool changed = true; changed;) {
      std::vector<char> thinner(mesh_.positions.size(), 0);
      changed = false;
      for (size_t i = 0; i < mesh_.triangles.size(); ++i) {
        if (dropped[i]) continue;
        if (hopeless(mesh_.triangles[i])) {
          dropped[i] = 1;
          continue;
        }
        if (sound(mesh_.triangles[i])) continue;
        changed = true;
        for (int corner = 0; corner < 3; ++corner) thinner[welded_[mesh_.triangles[i][corner]]] = 1;
      }
      for (size_t i = 0; i < scale_.size(); ++i)
        if (thinner[i]) scale_[i] *= kThinning;
      offset();
    }
    for (uint32_t i = 0; i < mesh_.triangles.size(); ++i)
      if (!dropped[i]) layers_.triangles.push_back(i);
    sayWhatWasDone();
    return std::move(layers_);
  }

 private:
  void offset() {
    for (size_t i = 0; i < mesh_.positions.size(); ++i) {
      const glm::dvec3 middle(mesh_.positions[i]);
      const glm::dvec3 arm = glm::dvec3(layers_.normals[i]) * (halfThickness_ * scale_[welded_[i]]);
      layers_.lower[i] = middle - arm;
      layers_.upper[i] = middle + arm;
    }
  }

  /// Normal of the middle triangle, as long as twice its area.
  glm::dvec3 areaNormal(const glm::uvec3& triangle) const {
    const glm::dvec3 corner(mesh_.positions[triangle[0]]);
    return glm::cross(glm::dvec3(mesh_.positions[triangle[1]]) - corner,
                      glm::dvec3(mesh_.positions[triangle[2]]) - corner);
  }

  bool sound(const glm::uvec3& triangle) const {
    const std::array<int, 3> order = sortedCorners(triangle, welded_);
    glm::dvec3 corners[6];
    double thickness = 2 * halfThickness_;
    for (int i = 0; i < 3; ++i) {
      const uint32_t vertex = triangle[order[i]];
      corners[i] = layers_.lower[vertex];
      corners[i + 3] = layers_.upper[vertex];
      thickness = std::min(thickness, 2 * halfThickness_ * scale_[welded_[vertex]]);
    }
    const double least = kLeastVolume * glm::length(areaNormal(triangle)) * thickness;
    for (int tet = 0; tet < 3; ++tet) {
      const int* v = kPrismTets[tet];
      const glm::dmat3 edges(corners[v[1]] - corners[v[0]], corners[v[2]] - corners[v[0]],
                             corners[v[3]] - corners[v[0]]);
      if (!(glm::determinant(edges) * kPrismTetSign[tet] * orientation(order) > least)) return false;
    }
    return true;
  }

  /// Thinned towards nothing, the volumes tend to area x thickness x (normal of a corner . normal of the triangle).
  bool hopeless(const glm::uvec3& triangle) const {
    const glm::dvec2 u1 = mesh_.uv_mm[triangle[1]] - mesh_.uv_mm[triangle[0]];
    const glm::dvec2 u2 = mesh_.uv_mm[triangle[2]] - mesh_.uv_mm[triangle[0]];
    if (!(u1.x * u2.y - u1.y * u2.x > 0)) return true;
    const glm::dvec3 normal = areaNormal(triangle);
    const double least = kLeastVolume * glm::length(normal);
    double thickest = 0;
    for (int corner = 0; corner < 3; ++corner) {
      if (!(glm::dot(glm::dvec3(layers_.normals[triangle[corner]]), normal) > least)) return true;
      thickest = std::max(thickest, scale_[welded_[triangle[corner]]]);
    }
    return thickest < kThinnestLayer;
  }

  void sayWhatWasDone() {
    std::vector<char> used(mesh_.positions.size(), 0);
    for (const uint32_t triangle : layers_.triangles)
      for (int corner = 0; corner < 3; ++corner) used[welded_[mesh_.triangles[triangle][corner]]] = 1;
    size_t total = 0, thinned = 0;
    double thinnest = 1;
    for (size_t i = 0; i < used.size(); ++i) {
      if (!used[i]) continue;
      ++total;
      thinned += scale_[i] < 1;
      thinnest = std::min(thinnest, scale_[i]);
    }
    if (thinned > 0)
      layers_.repairs.push_back(
          fmt::format("{}: {} of {} points bend more sharply than cloth {:.3g} mm thick can; it is thinned there, to "
                      "{:.0f} % at the least",
                      mesh_.name, thinned, total, 2 * halfThickness_, 100 * thinnest));
    const size_t lost = mesh_.triangles.size() - layers_.triangles.size();
    if (lost > 0)
      layers_.repairs.push_back(
          fmt::format("{}: {} of {} triangles are creased too sharply to carry cloth and are left out", mesh_.name,
                      lost, mesh_.triangles.size()));
  }

  const DrapeMesh& mesh_;
  const std::vector<uint32_t>& welded_;
  double halfThickness_;
  std::vector<double> scale_;  ///< of the thickness, by welded vertex
  PrismLayers layers_;
};

}  // namespace

PrismLayers offsetLayers(const DrapeMesh& mesh, const std::vector<uint32_t>& welded, double halfThickness_mm) {
  return Thinning(mesh, welded, halfThickness_mm).run();
}

}  // namespace loomlight
