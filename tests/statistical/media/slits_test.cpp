#include <gtest/gtest.h>

#include "tests/support/every_medium.h"
#include "tests/support/sampled_mean.h"

namespace loomlight {
namespace {

/// Thick yarns side by side, with slits between them that are narrower than a voxel.
Fabric slits(double fibreDisorder_deg) {
  Fabric fabric = test::whiteCotton();
  fabric.fibres[0].radius_um = 6;
  Yarn& yarn = fabric.yarns[0];
  yarn.fibresPerPly = 400;
  yarn.packing = 0.55;
  yarn.flattening = 1;
  yarn.plyTwist_per_m = 300;
  yarn.fibreDisorder_deg = fibreDisorder_deg;
  fabric.press = 0;
  fabric.ends_per_cm = 29;
  fabric.picks_per_cm = 6;
  fabric.drape.width_mm = fabric.drape.height_mm = 9;  // rays come down within 4 mm of the middle
  return fabric;
}

/// How many rays through the cloth, about as steep as light that comes through it, meet nothing.
test::SampledMean passing(Fabric fabric, const test::MediumKind& kind, int rays, uint64_t seed) {
  kind.askFor(fabric);
  const auto scene = test::sceneOf(fabric);
  const auto medium = kind.make(*scene);
  const auto way = medium->batch(1);
  Random random(seed);
  TraceCounts counts;
  test::SampledMean share;
  for (int i = 0; i < rays; ++i) {
    const glm::vec3 origin(6 * random.uniform() - 3, 6 * random.uniform() - 3, 5);
    const glm::vec3 direction =
        glm::normalize(glm::vec3(0.4f * random.uniform() - 0.2f, 0.4f * random.uniform() - 0.2f, -1));
    way->begin(0, {origin, -1}, {});
    const PathRay ray{0, direction, &random};
    std::optional<Collision> met;
    way->collide({&ray, 1}, {&met, 1}, counts);
    share.add(met ? 0 : 1);
  }
  return share;
}

// Spread over their voxels, the fibres at the rims of yarns would close the slits: half of the light that comes
// through dense cloth would be lost. What few rays pass is as much as among the fibres themselves, within a tenth of it
// and the noise.
TEST(Slits, LetThroughAsMuchAsAmongFibres) {
  constexpr int kRays = 60000;
  for (const double disorder_deg : {0.0, 7.0}) {
    SCOPED_TRACE(disorder_deg);
    const auto fibres = passing(slits(disorder_deg), test::kFibresInBricks, kRays, 1);
    const auto volume = passing(slits(disorder_deg), test::kLoomlight, kRays, 2);
    const double noise = std::hypot(fibres.standardError(), volume.standardError());
    RecordProperty("fibres", std::to_string(fibres.mean()));
    RecordProperty("volume", std::to_string(volume.mean()));
    EXPECT_GT(fibres.mean(), 0.005);
    EXPECT_LT(fibres.mean(), 0.1);
    EXPECT_NEAR(volume.mean(), fibres.mean(), 0.1 * fibres.mean() + 4 * noise);
  }
}

}  // namespace
}  // namespace loomlight
