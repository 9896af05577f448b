#pragma once

#include <array>

#include "render/media/medium.h"
#include "render/scene/camera_rays.h"
#include "render/scene/scene.h"
#include "render/transport/path_sink.h"

namespace loomlight {

/// How paths are followed.
struct PathRules {
  PathSampling sampling;
  uint32_t maxEvents = 1;  ///< fibres met on a path, at most; the last one sends on the light of lamps alone

  /// As the pictures of a scene have it.
  static PathRules of(const Scene& scene) {
    return {scene.sampling, static_cast<uint32_t>(scene.fabric->render.maxDepth)};
  }
  /// Paths that find all their light by themselves, and end for no other reason than their length.
  static PathRules plain(uint32_t maxEvents) {
    return {{.stratified = false, .roulette = false, .lampsByChance = false, .lamps = false}, maxEvents};
  }
};

/// The one way in which light is traced: from the eye backwards, fibre by fibre, by a medium that finds them. At each a
/// lamp is looked for, and the fibre's BCSDF sends the path on; both ways of finding a lamp are weighted against each
/// other by the balance heuristic (Veach 1997). No path has a colour: it carries the lengths that it has travelled
/// inside the fibres of each material, of which colour is made where light is met (path_light.h).
///
/// One thread, as many paths after each other as it likes. Scene and medium must outlive it.
class PathIntegrator {
 public:
  static constexpr uint32_t kFirstDimension = 2;  ///< of stratified numbers; those below are the camera's

  PathIntegrator(const Scene& scene, const Medium& medium, const PathRules& rules);

  /// One path, told to `sink`; its cost is added to `counts`.
  void follow(const Ray& ray, Random& random, PathSink& sink, TraceCounts& counts);

 private:
  static constexpr size_t kMaxMaterials = 64;  // of a valid fabric
  struct Event;                                // a fibre, as the path has come to it
  std::span<const float> lengths_mm() const { return {lengths_mm_.data(), materials_}; }
  float lampChance(float value) const;
  bool survives(Random& random);
  void gather(PathLight light, PathSink& sink) const;
  void gatherEscaped(glm::vec3 direction, float scatterPdf, float visible, PathSink& sink) const;
  std::optional<PathLight> sampleLight(const Event& event, Random& random, TraceCounts& counts);

  const Scene& scene_;
  PathRules rules_;
  bool seesDirectLightApart_, lamps_;
  size_t materials_;
  std::unique_ptr<MediumPath> path_;
  std::array<float, kMaxMaterials> lengths_mm_{};  ///< of the path so far, inside the fibres of each material
  float weight_ = 1;
  uint32_t events_ = 0;
};

}  // namespace loomlight
