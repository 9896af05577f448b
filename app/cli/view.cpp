#include "app/cli/view.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/fabric/model/height_seen.h"

namespace loomlight {
namespace {

struct Preset {
  const char* name;
  ViewChoice view;
};

const Preset kPresets[] = {
    {"front", {-90, 50, {}, {}}}, {"top", {-90, 90, {}, {}}},  {"side", {-90, 15, {}, {}}},
    {"close", {-90, 50, {}, 12}}, {"macro", {-90, 90, {}, 4}},
};

// Where the line through `point` along `direction` meets the mesh last, seen along the direction: what a camera
// standing there sees in the middle of its picture. The point itself where the line misses.
glm::dvec3 outermost(const DrapeMesh& mesh, glm::dvec3 point, glm::dvec3 direction) {
  double furthest = -std::numeric_limits<double>::infinity();
  for (const glm::uvec3& triangle : mesh.triangles) {
    const glm::dvec3 a(mesh.positions[triangle.x]);
    const glm::dvec3 ab = glm::dvec3(mesh.positions[triangle.y]) - a, ac = glm::dvec3(mesh.positions[triangle.z]) - a;
    // Moller and Trumbore 1997.
    const glm::dvec3 p = glm::cross(direction, ac);
    const double determinant = glm::dot(ab, p);
    if (determinant == 0) continue;
    const glm::dvec3 s = point - a, q = glm::cross(s, ab);
    const double u = glm::dot(s, p) / determinant, v = glm::dot(direction, q) / determinant;
    if (u < 0 || v < 0 || u + v > 1) continue;
    furthest = std::max(furthest, glm::dot(ac, q) / determinant);
  }
  return std::isfinite(furthest) ? point + furthest * direction : point;
}

}  // namespace

std::optional<ViewChoice> viewPreset(const std::string& name) {
  const auto* found =
      std::find_if(std::begin(kPresets), std::end(kPresets), [&](const Preset& preset) { return preset.name == name; });
  if (found == std::end(kPresets)) return std::nullopt;
  return found->view;
}

std::string viewPresetNames() {
  std::string names;
  for (const Preset& preset : kPresets) names += (names.empty() ? "" : ", ") + std::string(preset.name);
  return names;
}

Camera cameraOf(const ViewChoice& view, const Fabric& fabric, const DrapeMesh& drape) {
  glm::dvec3 lower(std::numeric_limits<double>::infinity()), upper = -lower;
  for (const glm::vec3& position : drape.positions) {
    lower = glm::min(lower, glm::dvec3(position));
    upper = glm::max(upper, glm::dvec3(position));
  }
  const glm::dvec3 middle = 0.5 * (lower + upper);

  Camera camera = fabric.camera;
  camera.azimuth_deg = view.azimuth_deg;
  camera.elevation_deg = view.elevation_deg;
  camera.target_mm = middle;
  const double azimuth = view.azimuth_deg * kPi / 180, elevation = view.elevation_deg * kPi / 180;
  const glm::dvec3 towardsEye(std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
                              std::sin(elevation));
  const double tallest = 0.5 * heightSeenPerDistance(camera);  // for each millimetre of distance

  if (view.seenPitches) {
    camera.target_mm = outermost(drape, middle, towardsEye);
    const double pitch = 0.5 * (fabric.warpPitch_mm() + fabric.weftPitch_mm());
    camera.distance_mm = 0.5 * *view.seenPitches * pitch / tallest;
  } else if (view.distance_mm) {
    camera.distance_mm = *view.distance_mm;
  } else {
    // Near enough that the outline just fits: every point p needs |vertical offset| <= (distance - depth) tallest.
    const glm::dvec3 right(-std::sin(azimuth), std::cos(azimuth), 0);
    const glm::dvec3 up = glm::cross(towardsEye, right);
    const double widest = tallest * fabric.render.width / fabric.render.height;
    double distance = 0;
    for (const glm::vec3& position : drape.positions) {
      const glm::dvec3 p = glm::dvec3(position) - middle;
      const double reach = std::max(std::abs(glm::dot(p, up)) / tallest, std::abs(glm::dot(p, right)) / widest);
      distance = std::max(distance, reach + (camera.fov_deg > 0 ? glm::dot(p, towardsEye) : 0.0));
    }
    camera.distance_mm = 1.04 * distance;
  }
  camera.distance_mm = std::clamp(camera.distance_mm, 0.1, 1e5);
  return camera;
}

}  // namespace loomlight
