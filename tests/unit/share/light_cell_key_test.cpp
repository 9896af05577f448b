#include "render/share/light_cell_key.h"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "render/scene/camera_rays.h"
#include "render/scene/thread_shade.h"
#include "render/share/cell_deposits.h"
#include "render/share/first_fibres.h"
#include "render/transport/make_medium.h"
#include "tests/support/test_cloth.h"

namespace loomlight {
namespace {

/// Looks straight down on a cloth, and says in which cells the fibres are that it meets.
struct FromAbove {
  explicit FromAbove(std::shared_ptr<const Scene> of) : scene(std::move(of)) {}
  std::optional<Collision> meet(float x, float y, float height_mm) {
    path.begin({{x, y, height_mm}, -1});
    return path.collide({0, 0, -1}, random, counts);
  }

  std::shared_ptr<const Scene> scene;
  std::unique_ptr<const Medium> medium = makeMedium(*scene, 1e9, Task{});
  MediumPath path = medium->path();
  LightCellKeys keys{*scene};
  Random random{1};
  TraceCounts counts;
};

/// The cells of level 1 that ends are seen in from straight above, by how deeply they are dyed.
std::map<int, std::set<uint64_t>> cellsOfEnds(double shadeVariation_percent) {
  Fabric fabric = test::whiteCotton();
  fabric.yarns[0].shadeVariation_percent = shadeVariation_percent;
  fabric.render.resolution = 2;
  fabric.drape.width_mm = 20;
  fabric.drape.height_mm = 2;
  FromAbove above(test::sceneOf(fabric));
  std::map<int, std::set<uint64_t>> cells;
  for (float x = -9; x < 9; x += 0.1f) {
    const auto met = above.meet(x, 0.1f, 5);
    if (!met || met->yarnId.system != System::warp) continue;
    cells[shadeClass(System::warp, met->yarnId.index)].insert(above.keys.of(*met).keys[1]);
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

// Beside a wide gap a thread is in other light than between close neighbours.
TEST(LightCellKeys, KeepThreadsThatAreDisplacedApart) {
  Fabric fabric = test::whiteCotton();
  fabric.yarns[0].count_tex = 8;
  fabric.warpSpacing = {1, 1, 2};
  fabric.render.resolution = 2;
  FromAbove above(test::sceneOf(fabric));
  std::array<std::set<uint64_t>, 3> cells;  // of level 3, by the place of the end in the spacing
  for (int i = 0; i < 4000; ++i) {
    const float x = 8 * above.random.uniform() - 4, y = 8 * above.random.uniform() - 4;
    const auto met = above.meet(x, y, 5);
    if (met && met->yarnId.system == System::warp)
      cells[static_cast<size_t>(met->yarnId.index) % 3].insert(above.keys.of(*met).keys[3]);
  }
  for (size_t a = 0; a < 3; ++a) {
    EXPECT_GT(cells[a].size(), 1u);
    for (const uint64_t key : cells[a]) EXPECT_EQ(cells[(a + 1) % 3].count(key), 0u) << a;
  }
}

std::shared_ptr<const Scene> onFolds() {
  Fabric fabric = test::whiteCotton();
  fabric.render.resolution = 2;
  fabric.drape.kind = DrapeKind::folds;
  fabric.drape.radius_mm = 4;
  fabric.drape.width_mm = 80;
  fabric.drape.height_mm = 20;
  fabric.camera.distance_mm = 150;
  return test::sceneOf(fabric);
}

// Where steps of how cloth lies meet, jitter mixes them; anything else would be seen as a line on a fold. On a wall of
// 80 degrees a tenth of a millimetre is .06 radians, a quarter of a step, so that half of all may change.
TEST(LightCellKeys, ChangeBitByBitOverFolds) {
  constexpr int kJitters = 8;  // each way
  FromAbove above(onFolds());
  std::array<std::vector<uint64_t>, 2> before;  // by system
  std::array<float, 2> at_mm = {-1e9f, -1e9f};
  int compared = 0;
  for (float x = -20; x < 20; x += 0.02f) {
    const auto met = above.meet(x, 0.1f, 50);
    if (!met) continue;
    std::vector<uint64_t> now;
    for (int i = 0; i < kJitters * kJitters; ++i) {
      const glm::vec2 jitter = (glm::vec2(i % kJitters, i / kJitters) + 0.5f) / float{kJitters} - 0.5f;
      now.push_back(above.keys.of(*met, jitter).keys[kLieLevel]);
    }
    const auto system = static_cast<size_t>(met->yarnId.system);
    if (x - at_mm[system] < 0.1f) {
      ++compared;
      int differing = 0;
      for (size_t i = 0; i < now.size(); ++i) differing += now[i] != before[system][i];
      EXPECT_LE(differing, kJitters * kJitters * 3 / 4) << x;
    }
    before[system] = std::move(now);
    at_mm[system] = x;
  }
  EXPECT_GT(compared, 500);
}

// Jitter looks for light where cloth lies a little otherwise; at the ends of what there is, nothing lies so.
TEST(FirstFibres, OnFoldsAreInCellsThatLightIsKnownOf) {
  constexpr int kSide = 64;
  const auto scene = onFolds();
  const auto medium = makeMedium(*scene, 1e9, Task{});
  const CameraRays camera(scene->fabric->camera, kSide, kSide);
  CellSums cells;
  FirstHits hits(kSide, kSide);
  CellDeposits deposits(*scene, cells, hits);
  Film film(kSide, kSide);
  renderUpTo(32, *scene, *medium, camera, film, Task{}, {.first = &deposits});
  deposits.settle();

  FirstFibres fibres(*scene, *medium, camera);
  std::vector<PixelSample> samples;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) samples.push_back({x, y, 100});
  ASSERT_TRUE(fibres.trace(samples, Task{}));
  int met = 0, known = 0, elsewhere = 0;
  LightCellKeys keys(*scene);
  for (size_t i = 0; i < samples.size(); ++i) {
    const Collision* const fibre = fibres.at(i);
    if (!fibre) continue;
    const LightCellPath path = fibres.cellsOf(samples[i], *fibre, cells);
    ++met;
    known += cells.knows(path.keys[kLieLevel]);
    elsewhere += path.keys[kLieLevel] != keys.of(*fibre).keys[kLieLevel];
  }
  ASSERT_GT(met, 500);
  EXPECT_EQ(known, met);
  EXPECT_GT(elsewhere, 0.2 * met) << "and yet they are mixed";
}

}  // namespace
}  // namespace loomlight
