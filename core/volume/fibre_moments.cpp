#include "core/volume/fibre_moments.h"

#include <algorithm>
#include <cmath>

#include "core/volume/tangent_spread.h"

namespace loomlight {
namespace {

/// Eigenvector of the largest eigenvalue of the symmetric tensor, unit; any one of them where several are largest.
/// Closed form (Smith 1961, "Eigenvalues of a symmetric 3 x 3 matrix"); the vector from cross products.
glm::dvec3 principalAxis(const FibreMoments& m) {
  const double xx = m.sums[0], yy = m.sums[1], zz = m.sums[2], xy = m.sums[3], xz = m.sums[4], yz = m.sums[5];
  const double mean = (xx + yy + zz) / 3;
  const double dx = xx - mean, dy = yy - mean, dz = zz - mean;
  const double p = std::sqrt((dx * dx + dy * dy + dz * dz + 2 * (xy * xy + xz * xz + yz * yz)) / 6);
  if (p <= 1e-12 * mean) return {0, 0, 1};  // all directions alike
  const double det = dx * (dy * dz - yz * yz) - xy * (xy * dz - yz * xz) + xz * (xy * yz - dy * xz);
  const double cosine = std::clamp(det / (2 * p * p * p), -1.0, 1.0);
  const double largest = 2 * p * std::cos(std::acos(cosine) / 3);  // above the mean
  const glm::dvec3 rows[3] = {{dx - largest, xy, xz}, {xy, dy - largest, yz}, {xz, yz, dz - largest}};
  glm::dvec3 axis(0);
  double best = 0;
  for (int i = 0; i < 3; ++i) {
    const glm::dvec3 c = glm::cross(rows[i], rows[(i + 1) % 3]);
    if (const double size = glm::dot(c, c); size > best) {
      best = size;
      axis = c;
    }
  }
  if (best > 1e-20 * p * p * p * p) return axis / std::sqrt(best);
  // The two largest are equal, all rows are parallel: anything across them will do.
  glm::dvec3 row = rows[0];
  for (const glm::dvec3& r : rows)
    if (glm::dot(r, r) > glm::dot(row, row)) row = r;
  const glm::dvec3 other =
      std::abs(row.z) <= std::max(std::abs(row.x), std::abs(row.y)) ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
  return glm::normalize(glm::cross(row, other));
}

}  // namespace

FibreDistribution fitDistribution(const FibreMoments& m, double voxelVolume_mm3, int material) {
  const glm::dvec3 axis = principalAxis(m);
  const double along = axis.x * axis.x * m.sums[0] + axis.y * axis.y * m.sums[1] + axis.z * axis.z * m.sums[2] +
                       2 * (axis.x * axis.y * m.sums[3] + axis.x * axis.z * m.sums[4] + axis.y * axis.z * m.sums[5]);
  const double length = m.length_mm();
  FibreDistribution d;
  d.direction = glm::vec3(axis);
  d.spread = static_cast<float>(TangentSpread::spreadFromMeanSquareSine(1 - along / length));
  d.lengthDensity = static_cast<float>(length / voxelVolume_mm3);
  d.packing = static_cast<float>(m.sums[6] / length);
  d.material = material;
  return d;
}

double mergeCost(const FibreMoments& a, const FibreMoments& b) {
  const double la = a.length_mm(), lb = b.length_mm();
  double distance = 0;
  for (int i = 0; i < 6; ++i) {
    const double difference = a.sums[i] / la - b.sums[i] / lb;
    distance += (i < 3 ? 1 : 2) * difference * difference;
  }
  return distance * la * lb / (la + lb);
}

}  // namespace loomlight
