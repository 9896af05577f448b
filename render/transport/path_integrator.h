#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/task.h"
#include "core/fabric/model/validate.h"
#include "render/media/medium.h"
#include "render/scene/camera_rays.h"
#include "render/scene/scene.h"
#include "render/transport/path_sink.h"

namespace loomlight {

/// A path as it sets out, and who hears of it.
struct PathStart {
  Ray ray;
  Random random;  ///< the path's own; it is left where the path has ended
  PathSink* sink;
};

/// The one way in which light is traced: from the eye backwards, fibre by fibre, by a medium that finds them. At each a
/// lamp is looked for, and the fibre's BCSDF sends the path on; both ways of finding a lamp are weighted against each
/// other by the balance heuristic (Veach 1997). No path has a colour: it carries the lengths that it has travelled
/// inside the fibres of each material, of which colour is made where light is met (path_light.h).
///
/// Paths go on side by side, stage by stage: all fly, then all look for their lamps, then all are sent on (a wavefront:
/// Laine et al. 2013). So each stage's code and tables stay at hand, and many paths are computed side by side. Where
/// one has ended the next begins, so that all places are taken while there are paths. What becomes of a path does not
/// depend on the others, since it has random numbers of its own.
///
/// One thread, as many batches after each other as it likes. Scene and medium must outlive it.
class PathIntegrator {
 public:
  static constexpr uint32_t kFirstDimension = 2;  ///< of stratified numbers; those below are the camera's
  static constexpr size_t kBatch = 256;           ///< paths that are under way at once, at most

  /// With so many under way at once, at most kBatch.
  PathIntegrator(const Scene& scene, const Medium& medium, const PathSampling& sampling, size_t most = 1);

  /// Follows them, as many as there are, to their ends; their cost is added to `counts`. False where `task` (may be
  /// null) was stopped: then some have not ended.
  bool follow(std::span<PathStart> paths, TraceCounts& counts, const Task* task = nullptr);
  /// One path alone.
  void follow(const Ray& ray, Random& random, PathSink& sink, TraceCounts& counts);

 private:
  static constexpr size_t kMaxMaterials = kMaxKinds;
  /// A path between two fibres.
  struct State {
    PathStart* start = nullptr;
    const Collision* at = nullptr;  ///< in `met_`, until it flies on
    glm::vec3 direction{0, 0, -1};
    float scatterPdf = 0, weight = 1;
    uint32_t events = 0;
    bool addedAlready = false;  ///< what this flight may bring straight from a lamp to the first fibre
  };
  static constexpr size_t kOffsets = 4;  // places across a fibre from which a lamp is looked for at once
  /// A lamp that is looked for from where a path has met a fibre.
  struct LightQuery {
    uint32_t path = 0;
    LightSample light;
    std::array<float, kOffsets> offsets{};  ///< across the fibre, where the path may as well have met it
    uint32_t count = 0;                     ///< of them
  };
  /// What fibres send on of the light of eight queries, side by side.
  struct LightResponses;
  /// A lamp's light on its way to a path, unless it is in shadow.
  struct PendingLight {
    Rgb radiance{0};
    float mean = 0, divisor = 1;  ///< radiance counts with their quotient
    PathLight light;              ///< all but its radiance
  };
  Random& randomOf(uint32_t path) { return states_[path].start->random; }
  PathSink& sinkOf(uint32_t path) { return *states_[path].start->sink; }
  std::span<float> lengths_mm(uint32_t path) { return {&lengths_mm_[path * materials_], materials_}; }
  void begin(PathStart& start);
  void end(uint32_t path, PathEnd why);
  void fly(TraceCounts& counts);
  void sampleLights(TraceCounts& counts);
  void scatter();
  size_t scatterEight(std::span<uint32_t> eight);
  void seeDirectLightApart(TraceCounts& counts);
  void stratify(uint32_t path, uint32_t events, uint32_t use);
  bool isLampCertain(uint32_t events) const;
  void sortByMaterial();
  int materialOf(uint32_t path) const { return states_[path].at->material; }
  float absorbingRadius_mm(uint32_t path) const;
  LightResponses evaluate(std::span<const LightQuery> queries) const;
  void chooseOffset(const LightQuery& query, const LightResponses& responses, size_t lane, Random& random);
  bool survives(uint32_t path, Random& random);
  void gather(uint32_t path, PathLight light);
  void gatherEscaped(uint32_t path, float visible);

  const Scene& scene_;
  PathSampling sampling_;
  bool seesDirectLightApart_, lamps_;
  size_t materials_;
  std::unique_ptr<MediumBatch> medium_;
  std::vector<State> states_;
  std::vector<float> lengths_mm_;  ///< of each path so far, inside the fibres of each material
  std::vector<uint32_t> active_;   ///< the places of the paths that are under way
  std::vector<uint32_t> free_;     ///< the other places
  // Of one stage:
  std::vector<uint32_t> sorted_;
  std::vector<LightQuery> lightQueries_;
  std::vector<PathRay> pathRays_;
  std::vector<std::optional<Collision>> met_;
  std::vector<ShadowRay> shadowRays_;
  std::vector<PendingLight> pendingLights_;
};

}  // namespace loomlight
