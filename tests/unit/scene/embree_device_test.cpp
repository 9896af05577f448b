#include "render/scene/embree_device.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "core/base/parallel.h"
#include "render/scene/fibre_bvh.h"
#include "tests/support/test_cloth.h"

namespace loomlight {
namespace {

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

/// On a cylinder, a few crossings wide.
std::shared_ptr<const Scene> drapedCloth() {
  Fabric fabric = test::whiteCotton();
  fabric.drape.kind = DrapeKind::cylinder;
  fabric.drape.radius_mm = 5;
  fabric.drape.width_mm = fabric.drape.height_mm = 2;
  return test::sceneOf(fabric);
}

TEST(EmbreeDevice, LeavesTheProgramItsThreads) {
  const EmbreeDevice device;
  EXPECT_TRUE(twoThreadsMeet());
}

TEST(EmbreeDevice, OfADrapeLeavesTheProgramItsThreads) {
  const auto scene = drapedCloth();
  EXPECT_TRUE(twoThreadsMeet());
}

TEST(EmbreeDevice, OfFibresLaidByOneThreadLeavesTheProgramItsThreads) {
  const auto scene = drapedCloth();
  Task one;
  one.threads = 1;
  const auto fibres = FibreBvh::build(scene->cloth, planFibres(*scene->cloth, {}), one);
  ASSERT_NE(fibres, nullptr);
  EXPECT_TRUE(twoThreadsMeet());
}

}  // namespace
}  // namespace loomlight
