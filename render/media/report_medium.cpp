#include "render/media/report_medium.h"

#include "render/bvdf/local_cell.h"
#include "render/media/batch_of.h"

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

std::unique_ptr<MediumBatch> ReportMedium::batch(size_t paths) const {
  return std::make_unique<BatchOf<ReportMedium>>(*this, paths);
}

std::optional<Collision> ReportMedium::collide(const ScenePoint& from, Memory& memory, glm::vec3 direction,
                                               Random& random, TraceCounts& counts) const {
  VolumeMedium::Memory none;
  const auto met = volume_.collide(from, none, direction, random, counts);
  if (met) memory = {memory.events + 1, met->yarn, met->tangent, direction};
  return met;
}

float ReportMedium::transmittance(const ScenePoint& from, const Memory& memory, glm::vec3 direction, float distance,
                                  Random& random, TraceCounts& counts) const {
  if (memory.events != 1) return volume_.transmittance(from, {}, direction, distance, random, counts);
  const glm::mat3 frame = eventFrame(normalAt(*cloth_->shell, from), memory.tangent);
  const float visible = 1 - bvdf_->of(memory.yarn).occlusion(direction * frame, -memory.incoming * frame);
  if (visible <= 0) return 0;
  const float cell_mm = distanceThroughCell(*cloth_, from, direction);
  return visible * volume_.transmittanceBeyond(cell_mm, from, direction, distance, random, counts);
}

}  // namespace loomlight
