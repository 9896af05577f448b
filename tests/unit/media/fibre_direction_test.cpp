#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "render/media/fibre_medium.h"
#include "render/media/loomlight_medium.h"
#include "render/media/volume_medium.h"
#include "tests/support/test_cloth.h"

namespace loomlight {
namespace {

constexpr int kRays = 4000;

/// Calls visit(const Collision&) for what rays onto the middle of the cloth meet; returns how many met something.
template <class Visit>
int meet(const Scene& scene, const Medium& medium, Visit&& visit) {
  Random random(11);
  TraceCounts counts;
  int met = 0;
  MediumPath path = medium.path();
  for (int i = 0; i < kRays; ++i) {
    const float x = random.uniform() - 0.5f, y = random.uniform() - 0.5f;
    const glm::vec3 down = glm::normalize(glm::vec3(0.2f, 0.3f, -1));
    path.begin({glm::vec3(x, y, 0) - 10.0f * down, -1});
    const auto collision = path.collide(down, random, counts);
    if (!collision) continue;
    ++met;
    visit(*collision);
  }
  EXPECT_GT(met, kRays / 4) << scene.fabric->name;
  return met;
}

bool followsYarn(const Collision& c, System system) {
  return system == System::warp ? c.tangent.y > 0 : c.tangent.x > 0;
}

/// Four standard deviations of how many of n fair coins show heads.
double fairly(int n) {
  return 4 * 0.5 * std::sqrt(n);
}

TEST(FibreDirection, IsEitherWhereverAVolumeIsMet) {
  const auto scene = test::sceneOf(test::whiteCotton());
  const VolumeMedium volume(scene->cloth);
  const LoomlightMedium ours(scene->cloth);
  for (const Medium* medium : {static_cast<const Medium*>(&volume), static_cast<const Medium*>(&ours)}) {
    // Whichever yarn it is, along x + y it lies one way or the other; and so it does along z, which a yarn climbs.
    int along = 0, upwards = 0;
    const int met = meet(*scene, *medium, [&](const Collision& c) {
      along += c.tangent.x + c.tangent.y > 0;
      upwards += c.tangent.z > 0;
    });
    EXPECT_NEAR(along, 0.5 * met, fairly(met));
    EXPECT_NEAR(upwards, 0.5 * met, fairly(met));
  }
}

TEST(FibreDirection, OfAnExplicitFibreIsOneAllAlongIt) {
  const auto scene = test::sceneOf(test::whiteCotton());
  const auto fibres = FibreMedium::build(scene->cloth, {}, Task{});
  std::map<uint64_t, bool> follows;
  meet(*scene, *fibres, [&](const Collision& c) {
    const System system = std::abs(c.tangent.y) > std::abs(c.tangent.x) ? System::warp : System::weft;
    const auto [known, isNew] = follows.emplace(c.fibre, followsYarn(c, system));
    EXPECT_EQ(known->second, followsYarn(c, system)) << "fibre " << c.fibre;
  });
  int along = 0;
  for (const auto& [fibre, yes] : follows) along += yes;
  const int met = static_cast<int>(follows.size());
  EXPECT_GT(met, 100);
  EXPECT_NEAR(along, 0.5 * met, fairly(met));
}

}  // namespace
}  // namespace loomlight
