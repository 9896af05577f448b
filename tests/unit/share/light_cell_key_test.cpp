#include "render/share/light_cell_key.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "render/scene/thread_shade.h"
#include "render/transport/make_medium.h"
#include "tests/support/test_cloth.h"

namespace loomlight {
namespace {

/// The cells of level 1 that ends are seen in from straight above, by how deeply they are dyed.
std::map<int, std::set<uint64_t>> cellsOfEnds(double shadeVariation_percent) {
  Fabric fabric = test::whiteCotton();
  fabric.yarns[0].shadeVariation_percent = shadeVariation_percent;
  fabric.render.resolution = 2;
  fabric.drape.width_mm = 20;
  fabric.drape.height_mm = 2;
  const auto scene = test::sceneOf(fabric);
  const auto medium = makeMedium(*scene, 1e9, Task{});
  MediumPath path = medium->path();
  LightCellKeys keys(*scene);
  Random random(1);
  TraceCounts counts;
  std::map<int, std::set<uint64_t>> cells;
  for (float x = -9; x < 9; x += 0.1f) {
    path.begin({{x, 0.1f, 5}, -1});
    const auto met = path.collide({0, 0, -1}, random, counts);
    if (!met || met->yarnId.system != System::warp) continue;
    cells[shadeClass(System::warp, met->yarnId.index)].insert(keys.of(*met).keys[1]);
  }
  return cells;
}

TEST(LightCellKeys, KeepThreadsOfSeveralShadesApart) {
  const auto cells = cellsOfEnds(10);
  ASSERT_GE(cells.size(), 4u);
  std::set<uint64_t> all;
  for (const auto& [shade, keys] : cells) {
    EXPECT_EQ(keys.size(), 1u);
    all.insert(keys.begin(), keys.end());
  }
  EXPECT_EQ(all.size(), cells.size());
}

TEST(LightCellKeys, AreOneForThreadsOfOneShade) {
  std::set<uint64_t> all;
  for (const auto& [shade, keys] : cellsOfEnds(0)) all.insert(keys.begin(), keys.end());
  EXPECT_EQ(all.size(), 1u);
}

}  // namespace
}  // namespace loomlight
