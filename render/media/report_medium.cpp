#include "render/media/report_medium.h"

#include "render/bvdf/local_cell.h"

namespace loomlight {
namespace {

glm::vec3 normalAt(const Shell& shell, const ScenePoint& place) {
  if (shell.isFlat()) return {0, 0, 1};
  const glm::mat3 frame = shell.frame(place.tet, place.world);
  return glm::normalize(glm::cross(frame[0], frame[1]));
}

/// Distance to the far side of the cell around a place. Within the cell the drape is taken as affine: cells are small
/// against its triangles, or its triangles nearly in one plane.
float distanceThroughCell(const TraceData& data, const ScenePoint& from, glm::vec3 direction) {
  const Shell& shell = *data.shell;
  const glm::vec3 cloth = shell.toCloth(from.tet, from.world);
  const glm::vec3 clothDirection = shell.isFlat() ? direction : shell.tets()[from.tet].toCloth * direction;
  return LocalCell::around(cloth, *data.volume).exit(cloth, clothDirection);
}

}  // namespace

ReportMedium::ReportMedium(std::shared_ptr<const TraceData> cloth, std::shared_ptr<const BvdfSet> bvdf)
    : cloth_(std::move(cloth)), volume_(cloth_, EventLaw::report), bvdf_(std::move(bvdf)) {}

std::optional<Collision> ReportMedium::collide(const Departure& from, glm::vec3 direction, Random& random,
                                               TraceCounts& counts) const {
  return volume_.collide(from, direction, random, counts);
}

Departure ReportMedium::leave(const Collision& collision, glm::vec3 wi, int order) const {
  Departure departure = volume_.leave(collision, wi, order);
  departure.leaving.tangent = collision.tangent;
  departure.leaving.yarn = collision.yarn;
  departure.flights[0].direction = collision.incoming;
  return departure;
}

float ReportMedium::transmittance(const Departure& from, glm::vec3 direction, float distance, Random& random,
                                  TraceCounts& counts) const {
  if (from.events != 1) return volume_.transmittance(from, direction, distance, random, counts);
  const glm::mat3 frame = eventFrame(normalAt(*cloth_->shell, from.place), from.leaving.tangent);
  const float visible =
      1 - bvdf_->of(from.leaving.yarn).occlusion(direction * frame, -from.flights[0].direction * frame);
  if (visible <= 0) return 0;
  const float cell_mm = distanceThroughCell(*cloth_, from.place, direction);
  return visible * volume_.transmittanceBeyond(cell_mm, from, direction, distance, random, counts);
}

}  // namespace loomlight
