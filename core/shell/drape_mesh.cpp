#include "core/shell/drape_mesh.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/shell/drape_grid.h"
#include "core/shell/drape_shapes.h"

namespace loomlight {
namespace {

constexpr double kSphereReach = 0.8 * kPi;

DrapeMesh flatDrape(const Drape& drape) {
  const glm::dvec3 middle(drape.width_mm / 2, drape.height_mm / 2, 0);
  return gridMesh(drape.width_mm, drape.height_mm, 1, 1,
                  [&](glm::dvec2 uv) { return SurfacePoint{glm::dvec3(uv, 0) - middle, {0, 0, 1}}; });
}

DrapeMesh cylinderDrape(const Drape& drape) {
  const double radius = drape.radius_mm;
  const double turn = 2 * kPi * radius;
  // A swatch typed as one turn to a few digits is meant to close.
  const bool closed = drape.height_mm > turn * (1 - 1e-4);
  const double height = closed ? turn : drape.height_mm;
  const int rows = cellsFor(height, facetAcross(radius), 1000);
  const int columns = cellsFor(drape.width_mm, kMaxCellAspect * height / rows, kMaxDrapeCells / rows);

  // Centre of the bounding box: the arc's top is at +radius, its lowest point at the two ends.
  const double halfAngle = height / (2 * radius);
  const double centre = radius * (1 + std::cos(halfAngle)) / 2;
  DrapeMesh mesh = gridMesh(drape.width_mm, height, columns, rows, [&](glm::dvec2 uv) {
    // Both ends of a closed coil must be the very same numbers, so that they are joined.
    const double angle = closed && uv.y >= height ? -halfAngle : uv.y / radius - halfAngle;
    const glm::dvec3 normal(0, std::sin(angle), std::cos(angle));
    return SurfacePoint{radius * normal + glm::dvec3(uv.x - drape.width_mm / 2, 0, -centre), normal};
  });
  if (drape.height_mm > turn * (1 + 1e-4))
    mesh.repairs.push_back(fmt::format(
        "drape.height_mm: {:g} mm is more than one turn round a cylinder of radius {:g} mm; cut to {:.4g} mm",
        drape.height_mm, radius, turn));
  return mesh;
}

DrapeMesh sphereDrape(const Drape& drape) {
  const double radius = drape.radius_mm;
  const double halfDiagonal = std::hypot(drape.width_mm, drape.height_mm) / 2;
  const double cut = std::min(1.0, kSphereReach * radius / halfDiagonal);
  const double width = drape.width_mm * cut, height = drape.height_mm * cut;
  const int columns = cellsFor(width, facetAcross(radius), 400);
  const int rows = cellsFor(height, facetAcross(radius), 400);

  const double reach = halfDiagonal * cut / radius;
  const double centre = radius * (1 + std::cos(reach)) / 2;
  DrapeMesh mesh = gridMesh(width, height, columns, rows, [&](glm::dvec2 uv) {
    const glm::dvec2 arm = uv - glm::dvec2(width, height) / 2.0;
    const double angle = glm::length(arm) / radius;
    const double gather = angle > 1e-9 ? std::sin(angle) / angle : 1.0;
    const glm::dvec3 normal(arm / radius * gather, std::cos(angle));
    return SurfacePoint{radius * normal - glm::dvec3(0, 0, centre), normal};
  });
  if (cut < 1)
    mesh.repairs.push_back(
        fmt::format("drape: {:g} x {:g} mm does not fit on a sphere of radius {:g} mm; cut to {:.4g} x {:.4g} mm",
                    drape.width_mm, drape.height_mm, radius, width, height));
  return mesh;
}

void expectPositive(double value, const char* name) {
  if (!(value > 0 && value <= 1e6))
    throw InputError(fmt::format("drape.{}: expected a positive number of millimetres, got {:g}", name, value));
}

DrapeMesh onStraightGrain(const Drape& drape) {
  if (drape.kind == DrapeKind::mesh) return loadDrapeMesh(drape.file, drape.uvScale_mm);
  expectPositive(drape.width_mm, "width_mm");
  expectPositive(drape.height_mm, "height_mm");
  if (drape.kind == DrapeKind::flat) return flatDrape(drape);
  expectPositive(drape.radius_mm, "radius_mm");
  switch (drape.kind) {
    case DrapeKind::cylinder:
      return cylinderDrape(drape);
    case DrapeKind::folds:
      return foldedDrape(drape);
    case DrapeKind::cushion:
      return cushionDrape(drape);
    case DrapeKind::skirt:
      return skirtDrape(drape);
    default:
      return sphereDrape(drape);
  }
}

/// Turns the cloth on its surface, and moves it so that its coordinates begin at 0.
void turnCloth(std::vector<glm::vec2>& uv_mm, double grain_deg) {
  const double angle = grain_deg * kPi / 180;
  const glm::dvec2 weft(std::cos(angle), std::sin(angle)), warp(-weft.y, weft.x);
  const auto turned = [&](glm::dvec2 uv) { return glm::dvec2(glm::dot(uv, weft), glm::dot(uv, warp)); };
  glm::dvec2 lower = turned(uv_mm.front());
  for (const glm::vec2 uv : uv_mm) lower = glm::min(lower, turned(uv));
  for (glm::vec2& uv : uv_mm) uv = turned(uv) - lower;
}

}  // namespace

DrapeMesh makeDrape(const Drape& drape) {
  DrapeMesh mesh = onStraightGrain(drape);
  if (drape.kind != DrapeKind::flat && drape.grain_deg != 0) turnCloth(mesh.uv_mm, drape.grain_deg);
  return mesh;
}

}  // namespace loomlight
