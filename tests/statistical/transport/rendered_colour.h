#pragma once

#include <memory>
#include <vector>

#include "render/colour/colour_space.h"
#include "render/transport/make_medium.h"
#include "render/transport/path_length_tally.h"
#include "render/transport/path_tracer.h"
#include "tests/support/every_sample.h"
#include "tests/support/test_cloth.h"

namespace loomlight {

/// Under a dome of the fabric's lamps.
inline Fabric patchOf(const Fabric& fabric) {
  Fabric patch = colourPatch(fabric);
  patch.light.illuminant = fabric.light.illuminant;
  return patch;
}

struct PatchOfCloth {
  explicit PatchOfCloth(const Fabric& fabric)
      : scene(test::sceneOf(patchOf(fabric))), medium(makeMedium(*scene, defaultMemoryLimit_bytes(), Task{})) {}
  std::shared_ptr<const Scene> scene;
  std::unique_ptr<const Medium> medium;
};

/// What the path tracer shows of each yarn, seen from straight above in a white dome.
inline std::vector<Rgb> renderedColours(Fabric fabric) {
  fabric.render.seed += 1;
  fabric.camera.elevation_deg = 90;
  fabric.camera.fov_deg = 0;
  fabric.camera.distance_mm = 20;
  const PatchOfCloth patch(fabric);
  constexpr int kSide = 64;
  constexpr uint32_t kSamples = 12;
  // The middle of a picture that shows most of the patch: about three repeats each way, so that it hardly matters where
  // they are cut.
  const CameraRays camera(fabric.camera, 2 * kSide, 2 * kSide);
  std::vector<glm::dvec3> sums(fabric.yarns.size(), glm::dvec3(0.0));
  std::vector<int> seen(fabric.yarns.size(), 0);
  TraceCounts counts;
  test::forEachSample(*patch.scene, *patch.medium, camera, {kSide / 2, kSide / 2, kSide, kSide}, kSamples, counts,
                      [&](int, int, const PathSample& sample) {
                        if (sample.yarn < 0) return;
                        sums[static_cast<size_t>(sample.yarn)] += glm::dvec3(sample.direct + sample.indirect);
                        ++seen[static_cast<size_t>(sample.yarn)];
                      });
  std::vector<Rgb> colours;
  for (size_t yarn = 0; yarn < sums.size(); ++yarn) colours.emplace_back(sums[yarn] / static_cast<double>(seen[yarn]));
  return colours;
}

inline double colourDifference(const Rgb& a, const Rgb& b) {
  return ciede2000(labFromLinear(glm::dvec3(a)), labFromLinear(glm::dvec3(b)));
}

}  // namespace loomlight
