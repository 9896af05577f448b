#include "render/trace/report_medium.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "render/trace/cloth_walk.h"
#include "render/trace/local_cell.h"
#include "render/trace/voxel_extinction.h"

namespace loomlight {
namespace {

Scene withReportLaw(Scene scene) {
  Fabric fabric = *scene.fabric;
  fabric.render.eventLaw = EventLaw::report;
  scene.fabric = std::make_shared<const Fabric>(std::move(fabric));
  return scene;
}

/// A departure from the first event carries what the BVDF says of its direction: its clearance is the way to the far
/// side of the cell, and instead of a fibre, which statistics do not know, it holds the probability of getting there.
void setLocalVisibility(Departure& departure, float visibility, float cell_mm) {
  departure.fibre = std::bit_cast<uint32_t>(visibility);
  departure.clearance_mm = cell_mm;
}
float localVisibility(const Departure& departure) {
  return std::bit_cast<float>(static_cast<uint32_t>(departure.fibre));
}

}  // namespace

ReportMedium::ReportMedium(const Scene& scene, std::shared_ptr<const BvdfSet> bvdf)
    : scene_(withReportLaw(scene)), volume_(scene_), bvdf_(std::move(bvdf)) {}

std::optional<Collision> ReportMedium::collide(const Departure& from, glm::vec3 direction, Random& random,
                                               TraceCounts& counts) const {
  return volume_.collide(from, direction, random, counts);
}

Departure ReportMedium::leave(const Collision& collision, glm::vec3 wi, int order) const {
  Departure departure = volume_.leave(collision, wi, order);
  if (collision.events != 1) return departure;
  const glm::mat3 frame = eventFrame(collision.normal, collision.tangent);
  const float occlusion = bvdf_->of(collision.yarn).occlusion(wi * frame, -collision.incoming * frame);
  // Within a cell the drape is taken as affine: cells are small against the triangles, or the triangles nearly flat.
  const Shell& shell = *scene_.shell;
  const int tet = collision.place.tet;
  const glm::vec3 cloth = shell.toCloth(tet, collision.place.world);
  const glm::vec3 clothDirection = shell.isFlat() ? wi : shell.tets()[tet].toCloth * wi;
  setLocalVisibility(departure, 1 - occlusion, LocalCell::around(cloth, *scene_.volume).exit(cloth, clothDirection));
  return departure;
}

float ReportMedium::transmittance(const Departure& from, glm::vec3 direction, float distance, Random& random,
                                  TraceCounts& counts) const {
  if (from.events != 1) return volume_.transmittance(from, direction, distance, random, counts);
  const float visibility = localVisibility(from);
  if (visibility <= 0) return 0;
  return visibility * transmittanceBeyond(from.clearance_mm, from, direction, distance, random, counts);
}

float ReportMedium::transmittanceBeyond(float cell_mm, const Departure& from, glm::vec3 direction, float distance,
                                        Random& random, TraceCounts& counts) const {
  // As VolumeMedium: exact to e^-4, then 0 or e^-4, because what hardly gets through is not worth walking for.
  constexpr float kExactDepth = 4.0f;
  const float deepest = kExactDepth - std::log1p(-random.uniform());
  float depth = 0;
  ++counts.rays;
  const bool through =
      walkCloth(scene_, from.place, direction, distance,
                [&](const VoxelContent& content, float tEnter, float tLeave, const LocalDrape& drape, int) {
                  const float length = tLeave - std::max(tEnter, cell_mm);
                  if (length <= 0) return true;
                  ++counts.steps;
                  depth += VoxelExtinction(scene_, content, drape, direction).total() * length;
                  return depth < deepest;
                });
  return through ? std::exp(-std::min(depth, kExactDepth)) : 0.0f;
}

}  // namespace loomlight
