#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/volume/traverse/cloth_volume.h"
#include "tests/unit/volume/volume_fixture.h"

namespace loomlight {
namespace {

using namespace volume_test;

/// Takes all that it is shown.
struct Looker {
  explicit Looker(const CellRect& rect)
      : look{rect,
             [this](double fraction) {
               fractions.push_back(fraction);
               return true;
             },
             [this](std::shared_ptr<const ClothVolume> sketch) { sketches.push_back(std::move(sketch)); }} {}
  Looker(const Looker&) = delete;
  Looker& operator=(const Looker&) = delete;

  PreviewSink look;
  std::vector<double> fractions;
  std::vector<std::shared_ptr<const ClothVolume>> sketches;
};

CellRect somewhere(const ClothGeometry& geometry, Random& random) {
  CellRect rect;
  rect.pick = random.below(geometry.picks());
  rect.end = random.below(geometry.ends());
  rect.picks = 1 + random.below(geometry.picks() - rect.pick);
  rect.ends = 1 + random.below(geometry.ends() - rect.end);
  return rect;
}

/// visit(system, pick, end) for all yarns in the cells.
template <class Visit>
void forEachYarn(const CellRect& rect, const Visit& visit) {
  for (int pick = rect.pick; pick < rect.pick + rect.picks; ++pick)
    for (int end = rect.end; end < rect.end + rect.ends; ++end)
      for (const System system : {System::warp, System::weft}) visit(system, pick, end);
}

CellRect whole(const ClothGeometry& geometry) {
  return {0, 0, geometry.picks(), geometry.ends()};
}

std::set<const BrickBlock*> bricksIn(const ClothVolume& volume, const CellRect& rect) {
  std::set<const BrickBlock*> bricks;
  forEachYarn(rect, [&](System system, int pick, int end) { bricks.insert(volume.brick(system, pick, end).blocks); });
  return bricks;
}

TEST(PreviewSink, ShowsWhatIsSeenAsItWillBeBeforeTheRestIsMade) {
  const Fabric fabric = jacquard(40);
  const auto geometry = geometryOf(fabric, 60, 50);
  const auto fresh = ClothVolume::build(geometry, 2, oneThread());
  Random random(5);
  int exact = 0;  // sketches
  for (int round = 0; round < 10; ++round) {
    const CellRect rect = somewhere(*geometry, random);
    SCOPED_TRACE(fmt::format("{} picks, {} ends", rect.picks, rect.ends));
    Looker looker(rect);
    const auto volume = ClothVolume::build(geometry, 2, oneThread(), nullptr, &looker.look);
    ASSERT_TRUE(sameVolume(*fresh, *volume));
    EXPECT_EQ(volume->bricksVoxelised(), fresh->bricksVoxelised());
    ASSERT_EQ(looker.sketches.size(), looker.fractions.size());
    if (looker.sketches.empty()) continue;  // all is in view, each shape in one phase
    const size_t seen = bricksIn(*fresh, rect).size();
    const auto made = static_cast<size_t>(std::lround(looker.fractions.back() * volume->bricksVoxelised()));
    EXPECT_LE(made, seen);      // nothing else was made before
    if (made < seen) continue;  // the last brick that is seen was the last of all
    ++exact;
    forEachYarn(rect, [&](System system, int pick, int end) {
      EXPECT_TRUE(looker.sketches.back()->brick(system, pick, end) == fresh->brick(system, pick, end));
    });
  }
  EXPECT_GT(exact, 5);
}

TEST(PreviewSink, HasABrickOfTheRightShapeInEveryCellThatIsSeenAndOneOfTheRightYarnInAllOthers) {
  for (const Fabric& fabric : {hairyTwill(), slubbyTwill()}) {
    const auto geometry = geometryOf(fabric, 40, 36);
    const auto fresh = ClothVolume::build(geometry, 1, oneThread());
    const CellRect all = whole(*geometry), rect{3, 5, 2, 2};
    Looker looker(rect);
    ClothVolume::build(geometry, 1, oneThread(), nullptr, &looker.look);
    ASSERT_EQ(looker.sketches.size(), 2u);
    looker.sketches.push_back(ClothVolume::sketch(geometry, 1, rect, oneThread()));
    const auto shapeOf = [&](System system, int pick, int end) {
      YarnCellKey key = geometry->key(system, pick, end);
      key.phase = key.stretch = 0;
      return key;
    };
    for (const auto& sketch : looker.sketches) {
      ASSERT_LT(sketch->counts().segments, fresh->counts().segments * 40);  // walks all bricks: none is missing
      forEachYarn(all, [&](System system, int pick, int end) {
        const BrickView shown = sketch->brick(system, pick, end);
        const bool seen = rect.contains(pick, end);
        bool known = false;
        forEachYarn(all, [&](System other, int p, int e) {
          if (known || other != system || !(fresh->brick(other, p, e) == shown)) return;
          const YarnCellKey a = shapeOf(system, pick, end), b = shapeOf(other, p, e);
          known = seen ? a == b : a.yarn == b.yarn;
        });
        ASSERT_TRUE(known) << pick << " " << end << (seen ? " seen" : "");
      });
    }
  }
}

TEST(PreviewSink, MakesOneBrickOfEachShapeThatIsSeenFirst) {
  const Fabric fabric = hairyTwill();
  const auto geometry = geometryOf(fabric, 40, 36);
  const CellRect rect{0, 0, 4, 4};  // a repeat
  std::vector<YarnCellKey> shapes;
  forEachYarn(rect, [&](System system, int pick, int end) {
    YarnCellKey key = geometry->key(system, pick, end);
    key.phase = 0;
    if (std::find(shapes.begin(), shapes.end(), key) == shapes.end()) shapes.push_back(key);
  });
  Looker looker(rect);
  const auto volume = ClothVolume::build(geometry, 1, oneThread(), nullptr, &looker.look);
  ASSERT_FALSE(looker.fractions.empty());
  EXPECT_EQ(std::lround(looker.fractions.front() * volume->bricksVoxelised()), static_cast<long>(shapes.size()));
}

TEST(PreviewSink, LeavesAnEditWhatAFreshBuildMakes) {
  Random random(9);
  Fabric fabric = jacquard(30);
  fabric.fibres[0].radius_um = 40;
  auto geometry = geometryOf(fabric, 50, 44);
  auto volume = ClothVolume::build(geometry, 1, oneThread());
  size_t sketches = 0;
  for (int step = 0; step < 60; ++step) {
    const int pick = random.below(30), end = random.below(30);
    fabric.weave = fabric.weave.with(pick, end, !fabric.weave.at(pick, end));
    if (step % 5 == 0) fabric.yarns[0].plyTwist_per_m = 300 + 100 * random.below(5);
    if (step % 7 == 0) fabric.ends_per_cm = 20 + random.below(3);
    geometry = std::make_shared<const ClothGeometry>(fabric, 50, 44, geometry.get());
    Looker looker(somewhere(*geometry, random));
    volume = ClothVolume::build(geometry, 1, oneThread(), volume.get(), &looker.look);
    sketches += looker.sketches.size();
    ASSERT_TRUE(sameVolume(*ClothVolume::build(geometryOf(fabric, 50, 44), 1, oneThread()), *volume)) << step;
  }
  EXPECT_GT(sketches, 20u);
}

TEST(PreviewSink, MayStopTheBuild) {
  const auto geometry = geometryOf(hairyTwill(), 40, 36);
  std::stop_source stop;
  Task task = oneThread();
  task.stop = stop.get_token();
  size_t bricks = 0, before = 0;
  task.progress = [&](double) { ++bricks; };
  Looker looker({0, 0, 2, 2});
  looker.look.show = [&](std::shared_ptr<const ClothVolume>) {
    before = bricks;
    stop.request_stop();
  };
  EXPECT_EQ(ClothVolume::build(geometry, 1, task, nullptr, &looker.look), nullptr);
  EXPECT_GT(before, 0u);
  EXPECT_EQ(bricks, before);  // not one more
}

}  // namespace
}  // namespace loomlight
