#include "core/volume/pool/brick_pool.h"

#include <gtest/gtest.h>

#include <thread>

#include "core/base/random.h"
#include "core/volume/build/voxelise.h"

namespace loomlight {
namespace {

const VoxelGrid kGrid{.cell = {9, 10, 6}, .size_mm = glm::vec3(0.05f), .zLower_mm = -0.15f};

/// Of some fibres that lie anyhow, and reach into the cell on the upper side if they are many.
Brick brickOf(int fibres, uint64_t seed) {
  Random random(seed);
  CellStrands strands;
  for (int i = 0; i < fibres; ++i) {
    const float u = 0.6f * random.uniform() - 0.22f, z = 0.2f * random.uniform() - 0.1f;
    strands.strands.push_back({static_cast<uint32_t>(strands.points.size()), 2, static_cast<uint8_t>(i % 2), false});
    strands.points.push_back({u, -0.25f, z});
    strands.points.push_back({u, 0.25f, -z});
  }
  return voxelise(strands, System::warp, kGrid);
}

TEST(BrickPool, KeepsWhatIsHeldAndTakesThePlaceOfTheRest) {
  BrickPool pool(kGrid.cell);
  const Brick small = brickOf(3, 1), large = brickOf(200, 2);
  ASSERT_NE(small.view(), large.view());
  const BrickPool::Id first = pool.add(small, System::warp), second = pool.add(large, System::warp);
  ASSERT_TRUE(first != BrickPool::kNone && second != BrickPool::kNone && first != second);
  EXPECT_EQ(pool.view(first), small.view());
  EXPECT_EQ(pool.view(second), large.view());
  EXPECT_EQ(pool[second].voxels, large.view().voxels());
  EXPECT_EQ(pool[second].components, large.components.size());
  EXPECT_TRUE(pool[second].reachesAbove);

  const BrickBlock* const place = pool.view(second).blocks;
  pool.hold({{second, BrickPool::kNone, second}});
  pool.release({{second, second}});
  const BrickPool::Id other = pool.add(brickOf(200, 3), System::warp);
  EXPECT_EQ(pool.view(second), large.view()) << "held once more than let go";
  pool.release({{second, other}});
  const BrickPool::Id third = pool.add(large, System::warp);
  EXPECT_EQ(pool.view(third).blocks, place);
  EXPECT_EQ(pool.view(third), large.view());
  EXPECT_EQ(pool.view(first), small.view());
  pool.release({{first, third}});
}

TEST(BrickPool, HasABrickOfNothing) {
  BrickPool pool(kGrid.cell);
  EXPECT_EQ(pool.view(BrickPool::kNone).voxels(), 0u);
  EXPECT_TRUE(pool.view(BrickPool::kNone).at({4, 5, 3}).empty());
  const BrickPool::Id empty = pool.add(brickOf(0, 1), System::weft);
  EXPECT_NE(empty, BrickPool::kNone);
  EXPECT_TRUE(pool.view(empty).at({4, 5, 3}).empty());
  pool.release({{empty, BrickPool::kNone}});
}

TEST(BrickList, HoldsItsBricksAsOftenAsTheyStandInIt) {
  const auto pool = std::make_shared<BrickPool>(kGrid.cell);
  const Brick brick = brickOf(20, 4);
  BrickList list(pool, 3);
  list.takeOver(0, pool->add(brick, System::warp));
  const BrickPool::Id id = list[0];
  const auto holders = [&] { return (*pool)[id].holders; };
  EXPECT_EQ(holders(), 1u);
  list.set(2, id);
  EXPECT_EQ(holders(), 2u);
  list.set(2, id);
  EXPECT_EQ(holders(), 2u);
  {
    BrickList copy = list;
    EXPECT_EQ(holders(), 4u);
    const BrickList moved = std::move(copy);
    EXPECT_EQ(holders(), 4u);
  }
  EXPECT_EQ(holders(), 2u);
  list.resize(1);
  EXPECT_EQ(holders(), 1u);
  list = BrickList(pool, 1);
  EXPECT_EQ(holders(), 0u);
}

TEST(BrickPool, ServesManyThreads) {
  BrickPool pool(kGrid.cell);
  std::vector<Brick> bricks;
  for (int i = 0; i < 8; ++i) bricks.push_back(brickOf(1 + 7 * i, i));
  std::vector<std::jthread> threads;
  for (uint64_t t = 0; t < 4; ++t)
    threads.emplace_back([&, t] {
      Random random(t);
      std::vector<std::pair<BrickPool::Id, size_t>> held;
      for (int step = 0; step < 5000; ++step) {
        const size_t which = random.below(8);
        held.emplace_back(pool.add(bricks[which], System::warp), which);
        if (held.size() < 10) continue;
        const auto [id, kind] = held[random.below(10)];
        EXPECT_EQ(pool.view(id), bricks[kind].view());
        std::erase_if(held, [id = id](const auto& one) { return one.first == id; });
        pool.release({{id}});
      }
      for (const auto& one : held) pool.release({{one.first}});
    });
}

}  // namespace
}  // namespace loomlight
