#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "render/media/loomlight_medium.h"
#include "tests/support/every_medium.h"
#include "tests/support/sampled_mean.h"

namespace loomlight {
namespace {

/// Highly twisted ends with hardly a pick between them, in voxels as large as a yarn: fibres at angles of all kinds in
/// each.
Fabric twistedWarp(const test::MediumKind& kind) {
  Fabric fabric = test::whiteCotton();
  Yarn& yarn = fabric.yarns[0];
  yarn.fibresPerPly = 60;
  yarn.packing = 0.1;  // so loose that a short way never meets two
  yarn.flattening = 1;
  yarn.plyTwist_per_m = 1500;
  fabric.weave = Weave(std::vector<Weave::Row>{Weave::Row{1}});
  fabric.ends_per_cm = 20;
  fabric.picks_per_cm = 2;
  fabric.drape.width_mm = fabric.drape.height_mm = 4;
  fabric.render.resolution = 1;
  kind.askFor(fabric);
  return fabric;
}

/// Length of fibre per volume, as rays of one direction find it, but for a factor that is the same for all: each fibre
/// that is met within a short way from anywhere in the cloth stands for the more of its length, the less of it the ray
/// sees.
test::SampledMean lengthSeen(const Scene& scene, const Medium& medium, glm::vec3 direction) {
  constexpr float kShort_mm = 0.002f;  // what lies before hides one or two percent
  constexpr uint32_t kRays = 1'500'000, kTogether = 1000;
  TraceCounts counts;
  test::SampledMean length;
  const auto batch = medium.batch(kTogether);
  std::vector<Random> randoms;
  for (uint32_t i = 0; i < kTogether; ++i) randoms.emplace_back(3, i);
  std::vector<PathRay> rays;
  for (uint32_t i = 0; i < kTogether; ++i) rays.push_back({i, direction, &randoms[i]});
  std::vector<std::optional<Collision>> found(kTogether);
  for (uint32_t first = 0; first < kRays; first += kTogether) {
    for (uint32_t i = 0; i < kTogether; ++i) {
      Random& random = randoms[i];
      const float x = random.uniform(), y = random.uniform(), z = random.uniform();
      const glm::vec3 place =
          glm::mix(scene.cloth->shell->lower_mm(), scene.cloth->shell->upper_mm(), glm::vec3(x, y, z));
      batch->begin(i, {place, 0}, {});
    }
    batch->collide(rays, found, counts);
    for (const auto& met : found) {
      const bool near = met && met->distance_mm < kShort_mm;
      length.add(near ? 1 / glm::length(glm::cross(met->tangent, direction)) : 0);
    }
  }
  return length;
}

const glm::vec3 kAcross = glm::normalize(glm::vec3(1, 0, 0.2f));
const glm::vec3 kDirections[] = {{0, 1, 0},
                                 {0, 0, -1},
                                 glm::normalize(glm::vec3(0.1f, 1, 0.2f)),
                                 glm::normalize(glm::vec3(0.6f, 0.5f, -1)),
                                 glm::normalize(glm::vec3(-1, 1, 0))};

struct Comparison {
  int differ = 0;         ///< directions in which there is another length of fibre than across the warp
  double worstError = 0;  ///< of the lengths, over that across the warp: what a difference is held against
};

Comparison compareDirections(const Scene& scene, const Medium& medium) {
  const test::SampledMean across = lengthSeen(scene, medium, kAcross);
  Comparison comparison;
  for (const glm::vec3 direction : kDirections) {
    const test::SampledMean length = lengthSeen(scene, medium, direction);
    const double error = std::hypot(length.standardError(), across.standardError());
    comparison.worstError = std::max(comparison.worstError, error / across.mean());
    const int runs = 2 * static_cast<int>(std::size(kDirections));  // of this kind of test, in all of what follows
    comparison.differ += !test::isWithinNoise(length.mean(), across.mean(), error, runs);
  }
  return comparison;
}

void expectSameFromAnyDirection(const Scene& scene, const Medium& medium) {
  const Comparison comparison = compareDirections(scene, medium);
  EXPECT_EQ(comparison.differ, 0);
  EXPECT_LT(comparison.worstError, 0.03);
}

// The cloth has the same fibres whatever direction it is looked at from: where few of them are met, each must be one of
// which little is seen. So it is only where extinction, the choice of components and that of tangents belong together.
TEST(FibreLength, IsTheSameFromAnyDirection) {
  const auto scene = test::sceneOf(twistedWarp(test::kPlain));
  expectSameFromAnyDirection(*scene, *test::kPlain.make(*scene));
  // With a radius, surfaces lie before their axes, and a place has others from each side.
  const LoomlightMedium thin(scene->cloth, {.finiteRadius = false, .packing = true, .hotSpot = true});
  expectSameFromAnyDirection(*scene, thin);
}

// Fibres chosen by density alone, as the report has it, are met too often by rays that hardly see them: each stands for
// so much length that no number of samples makes it certain, and yet the difference is seen.
TEST(FibreLength, IsNotByTheReportsLaw) {
  const auto scene = test::sceneOf(twistedWarp(test::kReportsLaw));
  EXPECT_GT(compareDirections(*scene, *test::kReportsLaw.make(*scene)).differ, 0);
}

}  // namespace
}  // namespace loomlight
