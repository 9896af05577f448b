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
glm::vec4 barycentric(const Shell::Tet& tet, std::span<const glm::vec3> vertices, glm::vec3 point) {
  glm::vec4 weight(0);
  for (int i = 0; i < 4; ++i) {
    const glm::vec3 normal(tet.plane[i]);
    const float height = glm::dot(normal, vertices[tet.vertex[i]]) + tet.plane[i].w;
    weight[i] = std::max(0.0f, (glm::dot(normal, point) + tet.plane[i].w) / height);
  }
  const float sum = weight.x + weight.y + weight.z + weight.w;
  return sum > 0 ? weight / sum : glm::vec4(0.25f);
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
  return shell;
}

glm::vec3 Shell::toCloth(int tet, glm::vec3 world) const {
  if (isFlat()) return world + glm::vec3(upper_.x, upper_.y, 0);
  const Tet& t = tets_[static_cast<size_t>(tet)];
  return t.toCloth * world + t.offset;
}

glm::mat3 Shell::frame(int tet, glm::vec3 world) const {
  if (isFlat()) return glm::mat3(1);
  const Tet& t = tets_[static_cast<size_t>(tet)];
  const glm::vec4 weight = barycentric(t, vertices_, world);
  glm::mat3 blend(0);
  for (int i = 0; i < 4; ++i) blend += weight[i] * vertexFrames_[t.vertex[i]];
  return blend;
}

float Shell::exit(int tet, glm::vec3 origin, glm::vec3 direction, int& face) const {
  face = 0;
  if (isFlat()) return exitBox(lower_, upper_, origin, direction);
  const Tet& t = tets_[static_cast<size_t>(tet)];
  float nearest = std::numeric_limits<float>::infinity();
  for (int i = 0; i < 4; ++i) {
    const glm::vec3 normal(t.plane[i]);
    const float approach = glm::dot(normal, direction);
    if (approach > -kAlong) continue;
    const float parameter = (glm::dot(normal, origin) + t.plane[i].w) / -approach;
    if (parameter >= nearest) continue;
    nearest = parameter;
    face = i;
  }
  return nearest;
}

}  // namespace loomlight
