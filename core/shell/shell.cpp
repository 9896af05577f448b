#include "core/shell/shell.h"

#include <algorithm>
#include <limits>

namespace loomlight {
namespace {

/// A ray whose direction makes a smaller sine with a face than this runs along it and does not leave through it: the
/// sign of the product is rounding then, and rays along an edge could circle about it for ever.
constexpr float kAlong = 1e-6f;

/// Weights of the four vertices at a point, from its distances to the opposite faces; clamped for points that rounding
/// has put outside.
Float32x4 barycentric(const Shell::Tet& tet, glm::vec3 point) {
  const Float32x4 weight = most(Float32x4{}, tet.plane.heights(point) / tet.height);
  const float sum = weight[0] + weight[1] + weight[2] + weight[3];
  return sum > 0 ? weight / sum : broadcast<Float32x4>(0.25);
}

float exitBox(glm::vec3 lower, glm::vec3 upper, glm::vec3 origin, glm::vec3 direction) {
  float nearest = std::numeric_limits<float>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    if (direction[axis] == 0) continue;
    const float wall = direction[axis] > 0 ? upper[axis] : lower[axis];
    nearest = std::min(nearest, (wall - origin[axis]) / direction[axis]);
  }
  return nearest;
}

}  // namespace

Shell Shell::flat(double width_mm, double height_mm, double halfThickness_mm) {
  Shell shell;
  shell.uvUpper_ = glm::vec2(width_mm, height_mm);
  shell.upper_ = glm::vec3(width_mm / 2, height_mm / 2, halfThickness_mm);
  shell.lower_ = -shell.upper_;
  shell.halfThickness_mm_ = static_cast<float>(halfThickness_mm);
  return shell;
}

size_t Shell::bytes() const {
  return sizeof(Shell) + vertices().size_bytes() + std::span(vertexFrames_).size_bytes() + tets().size_bytes() +
         boundary().size_bytes();
}

glm::vec3 Shell::toCloth(int tet, glm::vec3 world) const {
  if (isFlat()) return world + glm::vec3(upper_.x, upper_.y, 0);
  const Tet& t = tets_[static_cast<size_t>(tet)];
  return t.toCloth * world + t.offset;
}

glm::mat3 Shell::frame(int tet, glm::vec3 world) const {
  if (isFlat()) return glm::mat3(1);
  const Tet& t = tets_[static_cast<size_t>(tet)];
  const Float32x4 weight = barycentric(t, world);
  glm::mat3 blend(0);
  for (int i = 0; i < 4; ++i) blend += weight[i] * vertexFrames_[t.vertex[i]];
  return blend;
}

float Shell::exit(int tet, glm::vec3 origin, glm::vec3 direction, int& face) const {
  face = 0;
  if (isFlat()) return exitBox(lower_, upper_, origin, direction);
  const Tet& t = tets_[static_cast<size_t>(tet)];
  constexpr float kNever = std::numeric_limits<float>::infinity();
  const Float32x4 approach = t.plane.approach(direction);
  const Float32x4 there = t.plane.heights(origin) / -approach;
  const Float32x4 parameter = approach > -kAlong ? broadcast<Float32x4>(kNever) : there;
  float nearest = kNever;
  for (int i = 0; i < 4; ++i) {
    if (parameter[i] >= nearest) continue;
    nearest = parameter[i];
    face = i;
  }
  return nearest;
}

}  // namespace loomlight
