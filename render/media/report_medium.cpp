#include "render/media/report_medium.h"

#include "render/bvdf/local_cell.h"
#include "render/media/loomlight_batch.h"
#include "render/media/shell_walk.h"

namespace loomlight {
namespace {

/// Distance to the far side of the cell around a place. Within the cell the drape is taken as affine: cells are small
/// against its triangles, or its triangles nearly in one plane.
float distanceThroughCell(const TraceData& data, const ScenePoint& from, glm::vec3 direction) {
  const Shell& shell = *data.shell;
  const glm::vec3 cloth = shell.toCloth(from.tet, from.world);
  const glm::vec3 clothDirection = shell.isFlat() ? direction : shell.tets()[from.tet].toCloth * direction;
  return LocalCell::around(cloth, *data.volume).exit(cloth, clothDirection);
}

}  // namespace

/// Paths through the plain volume, and what each has met.
class ReportMedium::Batch final : public MediumBatch {
 public:
  Batch(const ReportMedium& medium, size_t paths) : medium_(medium), volume_(medium.volume_, paths), met_(paths) {}

  void begin(uint32_t path, const ScenePoint& from, const RayCone& cone) override {
    volume_.begin(path, from, cone);
    met_[path] = {};
  }
  void collide(std::span<const PathRay> pathRays, std::span<std::optional<Collision>> met,
               TraceCounts& counts) override {
    volume_.collide(pathRays, met, counts);
    for (size_t i = 0; i < pathRays.size(); ++i) {
      if (!met[i]) continue;
      LastMet& last = met_[pathRays[i].path];
      last = {last.events + 1, met[i]->yarn, met[i]->tangent, pathRays[i].direction};
    }
  }
  void leave(uint32_t path, const Collision& met, glm::vec3 wi, float length_radii) override {
    volume_.leave(path, met, wi, length_radii);
  }
  void transmit(std::span<ShadowRay> rays, TraceCounts& counts) override {
    cast_.clear();
    clear_mm_.clear();
    for (ShadowRay& ray : rays) {
      const bool straight = met_[ray.path].events == 1;  // from a lamp to the first fibre
      ray.visible = straight ? nearby(ray) : 1;
      if (!(ray.visible > 0)) continue;
      cast_.push_back(ray);
      clear_mm_.push_back(straight ? distanceThroughCell(*medium_.cloth_, place(ray.path), ray.direction) : 0);
    }
    volume_.transmitBeyond(cast_, clear_mm_, counts);
    size_t next = 0;
    for (ShadowRay& ray : rays)
      if (ray.visible > 0) ray.visible *= cast_[next++].visible;
  }
  size_t offsetsAcross(uint32_t path, const Collision& met, std::span<float> offsets, Random& random) const override {
    return volume_.offsetsAcross(path, met, offsets, random);
  }
  const ScenePoint& place(uint32_t path) const override { return volume_.place(path); }
  void copy(uint32_t path, uint32_t to) override {
    volume_.copy(path, to);
    met_[to] = met_[path];
  }

 private:
  /// The last fibre of a path, and how the path came to it.
  struct LastMet {
    int events = 0;  ///< fibres met so far
    int yarn = 0;    ///< index into Fabric::yarns
    glm::vec3 tangent{1, 0, 0}, incoming{0, 0, -1};
  };
  /// How much of the light is seen within the cell around the fibre that it leaves, by the table of its yarn.
  float nearby(const ShadowRay& ray) const {
    const LastMet& last = met_[ray.path];
    const ScenePoint& from = place(ray.path);
    const glm::vec3 normal = LocalDrape::at(*medium_.cloth_->shell, from.tet, from.world).normal();
    const glm::mat3 frame = eventFrame(normal, last.tangent);
    return 1 - medium_.bvdf_->of(last.yarn).occlusion(ray.direction * frame, -last.incoming * frame);
  }

  const ReportMedium& medium_;
  LoomlightBatch volume_;
  std::vector<LastMet> met_;
  // Of one call:
  std::vector<ShadowRay> cast_;
  std::vector<float> clear_mm_;
};

ReportMedium::ReportMedium(std::shared_ptr<const TraceData> cloth, std::shared_ptr<const BvdfSet> bvdf)
    : cloth_(std::move(cloth)), volume_(cloth_, LoomlightMedium::plain(EventLaw::report)), bvdf_(std::move(bvdf)) {}

std::unique_ptr<MediumBatch> ReportMedium::batch(size_t paths) const {
  return std::make_unique<Batch>(*this, paths);
}

}  // namespace loomlight
