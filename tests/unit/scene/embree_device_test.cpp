#include <gtest/gtest.h>

#include <tbb/global_control.h>

#include <cstddef>

#include "render/scene/fibre_bricks.h"
#include "render/scene/fibre_bvh.h"
#include "tests/support/test_cloth.h"

namespace loomlight {
namespace {

// A number of threads that an Embree device is told becomes a limit of oneTBB's for the whole program. That limit is
// what is asked for: whether threads really come to a piece of work at once is nothing that oneTBB promises on a
// machine that has much else to do. In builds without oneTBB's threads devices are told to use one, and nobody minds.
#ifndef LOOMLIGHT_STD_THREADS

size_t threadsAllowed() {
  return tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
}

/// A few crossings wide.
Fabric smallCloth(DrapeKind drape) {
  Fabric fabric = test::whiteCotton();
  fabric.drape.kind = drape;
  fabric.drape.radius_mm = 5;
  fabric.drape.width_mm = fabric.drape.height_mm = 2;
  return fabric;
}

// Where rays enter cloth on a drape is found by Embree.
TEST(EmbreeDevice, OfADrapeLeavesTheProgramItsThreads) {
  const size_t before = threadsAllowed();
  const auto scene = test::sceneOf(smallCloth(DrapeKind::cylinder));
  ASSERT_TRUE(scene && !scene->cloth->shell->isFlat());
  EXPECT_EQ(threadsAllowed(), before);
}

TEST(EmbreeDevice, OfFibresLaidByOneThreadLeavesTheProgramItsThreads) {
  const size_t before = threadsAllowed();
  const auto scene = test::sceneOf(smallCloth(DrapeKind::flat));
  Task one;
  one.threads = 1;
  const auto fibres = FibreBvh::build(scene->cloth, planFibres(*scene->cloth, {}), one);
  ASSERT_NE(fibres, nullptr);
  EXPECT_EQ(threadsAllowed(), before);
}

TEST(EmbreeDevice, OfBricksLeavesTheProgramItsThreads) {
  const size_t before = threadsAllowed();
  Fabric near = smallCloth(DrapeKind::flat);
  near.camera.distance_mm = 0.7;
  const auto scene = test::sceneOf(near);
  ASSERT_NE(scene->cloth->fibres, nullptr);
  FibreBricks::Reader reader(*scene->cloth->fibres, *scene->cloth->volume);
  reader.meet({{0.1f, 0.1f, 1}, {0, 0, -1}, 0, 2});
  ASSERT_GT(scene->cloth->fibres->made(), 0u);
  EXPECT_EQ(threadsAllowed(), before);
}

#endif

}  // namespace
}  // namespace loomlight
