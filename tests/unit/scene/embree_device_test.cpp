#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "core/base/parallel.h"
#include "render/scene/fibre_bricks.h"
#include "render/scene/fibre_bvh.h"
#include "tests/support/test_cloth.h"

namespace loomlight {
namespace {

// A number of threads that an Embree device is told becomes a limit for the whole program.

/// Whether two pieces of work are done at the same time: each waits for the other to have begun.
bool twoThreadsMeet() {
  std::atomic<int> begun{0}, met{0};
  const auto patience = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  parallelFor(2, 2, [&](size_t) {
    ++begun;
    while (begun < 2 && std::chrono::steady_clock::now() < patience) std::this_thread::yield();
    if (begun == 2) ++met;
  });
  return met == 2;
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
  const auto scene = test::sceneOf(smallCloth(DrapeKind::cylinder));
  ASSERT_TRUE(scene && !scene->cloth->shell->isFlat());
  EXPECT_TRUE(twoThreadsMeet());
}

TEST(EmbreeDevice, OfFibresLaidByOneThreadLeavesTheProgramItsThreads) {
  const auto scene = test::sceneOf(smallCloth(DrapeKind::flat));
  Task one;
  one.threads = 1;
  const auto fibres = FibreBvh::build(scene->cloth, planFibres(*scene->cloth, {}), one);
  ASSERT_NE(fibres, nullptr);
  EXPECT_TRUE(twoThreadsMeet());
}

TEST(EmbreeDevice, OfBricksLeavesTheProgramItsThreads) {
  Fabric near = smallCloth(DrapeKind::flat);
  near.camera.distance_mm = 0.7;
  const auto scene = test::sceneOf(near);
  ASSERT_NE(scene->cloth->fibres, nullptr);
  FibreBricks::Reader reader(*scene->cloth->fibres, *scene->cloth->volume);
  reader.meet({{0.1f, 0.1f, 1}, {0, 0, -1}, 0, 2});
  ASSERT_GT(scene->cloth->fibres->made(), 0u);
  EXPECT_TRUE(twoThreadsMeet());
}

}  // namespace
}  // namespace loomlight
