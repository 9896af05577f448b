#include <gtest/gtest.h>

#include <deque>
#include <functional>
#include <map>
#include <thread>

#include "core/volume/traverse/cloth_volume.h"
#include "tests/unit/volume/volume_fixture.h"

namespace loomlight {
namespace {

using namespace volume_test;

/// One step of a designer, at random.
Fabric edited(const Fabric& before, Random& random) {
  Fabric fabric = before;
  const int ends = fabric.weave.ends(), picks = fabric.weave.picks();
  const auto place = [&] { return std::pair(random.below(picks), random.below(ends)); };
  const auto yarn = [&]() -> Yarn& { return fabric.yarns[random.below(static_cast<uint32_t>(fabric.yarns.size()))]; };
  switch (random.below(20)) {
    case 0: {  // paste an area, over the edge too
      const auto [pick, end] = place();
      const uint32_t height = 1 + random.below(6), width = 1 + random.below(6);
      for (uint32_t p = 0; p < height; ++p)
        for (uint32_t e = 0; e < width; ++e)
          fabric.weave = fabric.weave.with((pick + p) % picks, (end + e) % ends, random.below(2) != 0);
      break;
    }
    case 1:
      fabric.weave = fabric.weave.resized(6 + random.below(14), 6 + random.below(14));
      break;
    case 2:
      yarn().plyTwist_per_m = 300 + 100 * random.below(5);
      break;
    case 3:
      yarn().plies = 1 + random.below(3);
      break;
    case 4:
      yarn().count_tex = 25 + 5 * random.below(5);
      break;
    case 5:
      fabric.ends_per_cm = 20 + 8 * random.below(3);  // the most of them leave crowded threads no room
      break;
    case 6:
      fabric.fibres[0].absorption_per_mm = Rgb(random.uniform());
      break;
    case 7:
      fabric.warpSequence.assign(1 + random.below(3), 0);
      for (int& index : fabric.warpSequence) index = static_cast<int>(random.below(2));
      break;
    case 8:
      std::swap(fabric.yarns[0], fabric.yarns[1]);
      break;
    case 9:
      yarn().evennessCv_percent = 10 * random.below(3);
      break;
    case 10:
      yarn().slubs_per_m = 20 * random.below(2);
      break;
    case 11:
      fabric.settCv_percent = 5 * random.below(3);
      break;
    case 12:
      fabric.crowding = fabric.crowding > 0 ? 0 : 1 + random.below(3);
      break;
    case 13: {
      std::vector<double>& spacing = random.below(2) ? fabric.warpSpacing : fabric.weftSpacing;
      spacing.assign(random.below(4), 1);
      for (double& distance : spacing) distance += random.below(3);
      break;
    }
    default: {
      const auto [pick, end] = place();
      fabric.weave = fabric.weave.with(pick, end, !fabric.weave.at(pick, end));
    }
  }
  return fabric;
}

/// A state that undo and redo come back to.
struct State {
  Fabric fabric;
  std::shared_ptr<const ClothVolume> fresh;  ///< built from nothing, of a piece as large as it was then
};

/// Edits, undoes and redoes at random; after every step the volume must be what a fresh build makes, byte for byte.
void walk(Fabric fabric, int ends, int picks, int steps, Random& random) {
  Task one;
  one.threads = 1;  // for volumes this small, to wake another takes longer than to do its work
  std::deque<State> history{{std::move(fabric), nullptr}};
  size_t now = 0;
  auto geometry = geometryOf(history[0].fabric, ends, picks);
  auto volume = ClothVolume::build(geometry, 1, one);
  for (int step = 0; step < steps; ++step) {
    const uint32_t action = random.below(8);
    if (action == 0 && now > 0) {
      --now;  // undo
    } else if (action == 1 && now + 1 < history.size()) {
      ++now;  // redo
    } else {
      history.resize(now + 1);
      history.push_back({edited(history[now].fabric, random), nullptr});
      ++now;
    }
    if (random.below(10) == 0) {  // a piece of another size
      ends = 1 + random.below(2 * ends);
      picks = 1 + random.below(2 * picks);
    }
    geometry = std::make_shared<const ClothGeometry>(history[now].fabric, ends, picks, geometry.get());
    // Somebody looks at a corner of it meanwhile, and is shown what there is.
    const CellRect corner{0, 0, 1 + static_cast<int>(random.below(picks)), 1 + static_cast<int>(random.below(ends))};
    const PreviewSink look{corner, [](double) { return true; },
                           [&](const std::shared_ptr<const ClothVolume>& sketch) { EXPECT_TRUE(isWhole(*sketch)); }};
    volume = ClothVolume::build(geometry, 1, one, volume.get(), &look);
    auto& fresh = history[now].fresh;
    if (!fresh || fresh->geometry().ends() != ends || fresh->geometry().picks() != picks)
      fresh = ClothVolume::build(geometryOf(history[now].fabric, ends, picks), 1, one);
    ASSERT_TRUE(sameVolume(*fresh, *volume)) << "step " << step;
  }
}

TEST(Edits, LeaveWhatAFreshBuildMakes) {
  for (uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    Fabric fabric = seed % 2 == 0 ? hairyTwill() : slubbyTwill();
    fabric.fibres[0].radius_um = 45;  // few
    fabric.yarns[0].hairiness_per_mm = 0;
    fabric.weave = fabric.weave.resized(16, 12);
    fabric.crowding = seed > 4 ? 1 : 0;
    // A piece of several repeats, of less than one, or of one and a bit.
    const int ends = 8 + random.below(24), picks = 8 + random.below(24);
    ASSERT_NO_FATAL_FAILURE(walk(fabric, ends, picks, 60, random));
  }
}

TEST(Edits, InThousandsOfSequencesLeaveWhatAFreshBuildMakes) {
  Fabric fabric = hairyTwill();
  fabric.fibres[0].radius_um = 80;  // a handful: it is the maps that this is about
  fabric.yarns[0].hairiness_per_mm = 0;
  for (uint64_t seed = 1; seed <= 2000; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const int ends = 1 + random.below(12), picks = 1 + random.below(12);
    fabric.crowding = static_cast<double>(seed % 2);
    ASSERT_NO_FATAL_FAILURE(walk(fabric, ends, picks, 4, random));
  }
}

/// Bricks of a volume, by where they lie, and their bytes.
std::map<const BrickBlock*, size_t> bricksOf(const ClothVolume& volume) {
  std::map<const BrickBlock*, size_t> bricks;
  for (int pick = 0; pick < volume.geometry().picks(); ++pick)
    for (int end = 0; end < volume.geometry().ends(); ++end)
      for (const System system : {System::warp, System::weft}) {
        const BrickView brick = volume.brick(system, pick, end);
        bricks[brick.blocks] = sizeof(BrickPool::Entry) + brick.bytes();
      }
  return bricks;
}

TEST(Edits, OfACrossingVoxeliseOnlyShapesThatWereNotThere) {
  Fabric fabric = plainFabric();
  fabric.weave = fabric.weave.resized(120, 120).with(3, 5, true).with(4, 5, true);
  auto volume = volumeOf(fabric, 120, 120, 2);
  size_t most = 0, all = 0;
  Random random(4);
  for (int step = 0; step < 20; ++step) {
    const int pick = random.below(120), end = random.below(120);
    fabric.weave = fabric.weave.with(pick, end, !fabric.weave.at(pick, end));
    const auto before = bricksOf(*volume);
    volume = volumeOf(fabric, 120, 120, 2, volume.get());
    size_t made = 0;
    for (const auto& brick : bricksOf(*volume)) made += before.count(brick.first) == 0;
    most = std::max(most, made);
    all += made;
  }
  // A crossing is within reach of nine cells of either yarn, each in one phase.
  EXPECT_LE(most, 2u * (2 * kCrossingReach + 1));
  EXPECT_GT(all, 0u);
}

TEST(Edits, OfTheOrderOfColoursVoxeliseNothing) {
  Fabric fabric = hairyTwill();
  const auto before = volumeOf(fabric, 30, 30, 1);
  EXPECT_GT(before->bricksVoxelised(), 0u);
  for (const int colours : {2, 3, 5, 7}) {
    Fabric striped = fabric;
    for (int i = 1; i < colours; ++i) striped.yarns.push_back(fabric.yarns[0]);
    striped.warpSequence.clear();
    for (int i = 0; i < colours; ++i) striped.warpSequence.push_back(i == 0 ? 0 : i + 1);
    const auto after = volumeOf(striped, 30, 30, 1, before.get());
    EXPECT_EQ(after->bricksVoxelised(), 0u) << colours;
    EXPECT_TRUE(after->geometry().differsInWeaveOnly(before->geometry())) << colours;
    EXPECT_TRUE(sameVolume(*volumeOf(striped, 30, 30, 1), *after)) << colours;
  }
}

TEST(Edits, ThatNoFibreFollowsVoxeliseNothing) {
  Fabric fabric = plainFabric();
  fabric.yarns[0].plyTwist_per_m = 12;  // less than a turn in the longest period
  const auto before = volumeOf(fabric, 40, 40, 2);
  fabric.yarns[0].plyTwist_per_m = 12.5;
  const auto geometry = geometryOf(fabric, 40, 40);
  EXPECT_TRUE(geometry->differsInWeaveOnly(before->geometry()));
  const auto after = volumeOf(fabric, 40, 40, 2, before.get());
  EXPECT_EQ(after->bricksVoxelised(), 0u);
  EXPECT_TRUE(sameVolume(*volumeOf(fabric, 40, 40, 2), *after));
}

/// Of the rows that the maps of both would take if each had its own.
double shareOfBytesBeside(const Fabric& fabric, const ClothVolume& after, const ClothVolume& before) {
  const double crossings = 4.0 * fabric.weave.ends() * fabric.weave.picks();  // bytes, of both systems
  size_t bricks = 0;
  const auto known = bricksOf(before);
  for (const auto& [brick, bytes] : bricksOf(after)) bricks += known.count(brick) ? 0 : bytes;
  return static_cast<double>(after.bytesBeside(before) - bricks) / crossings;
}

TEST(Edits, OfAYarnReadNoCrossingAnew) {
  const Fabric fabric = jacquard(800);
  const auto before = volumeOf(fabric, 800, 800, 1);
  for (const auto& edit : std::vector<std::function<void(Fabric&)>>{
           [](Fabric& f) { f.yarns[0].plyTwist_per_m = 900; }, [](Fabric& f) { f.yarns[0].plies = 3; },
           [](Fabric& f) { f.yarns[0].count_tex = 35; }, [](Fabric& f) { f.ends_per_cm = 21; },
           [](Fabric& f) { f.render.resolution = 2; }}) {
    Fabric edited = fabric;
    edit(edited);
    const auto after = volumeOf(edited, 800, 800, edited.render.resolution, before.get());
    EXPECT_LT(shareOfBytesBeside(edited, *after, *before), 0.3);
    EXPECT_TRUE(sameVolume(*volumeOf(edited, 800, 800, edited.render.resolution), *after));
  }
}

TEST(Edits, OfTheSizeOfTheRepeatReadOnlyWhatIsNew) {
  const Fabric fabric = jacquard(800);
  const auto before = volumeOf(fabric, 820, 820, 1);
  Fabric longer = fabric;
  longer.weave = fabric.weave.resized(800, 807);
  // The warp is longer, but each pick is what it was.
  const auto after = volumeOf(longer, 820, 820, 1, before.get());
  EXPECT_LT(shareOfBytesBeside(longer, *after, *before), 0.8);
  EXPECT_TRUE(sameVolume(*volumeOf(longer, 820, 820, 1), *after));
}

TEST(Edits, ThatAreStoppedMakeNothing) {
  const Fabric fabric = jacquard(60);
  const auto before = volumeOf(fabric, 70, 70, 1);
  std::stop_source stop;
  stop.request_stop();
  Fabric longer = fabric;
  longer.weave = fabric.weave.resized(64, 60);
  EXPECT_EQ(ClothVolume::build(geometryOf(longer, 70, 70), 1, Task{stop.get_token(), {}, 1}, before.get()), nullptr);
}

TEST(Edits, OfOneVolumeMayBeMadeAtTheSameTime) {
  const Fabric fabric = jacquard(60);
  const auto before = volumeOf(fabric, 70, 70, 1);
  std::vector<std::shared_ptr<const ClothVolume>> made(4);
  std::vector<Fabric> edited(made.size(), fabric);
  edited[0].weave = fabric.weave.with(7, 5, !fabric.weave.at(7, 5));
  edited[1].weave = fabric.weave.resized(64, 57);
  edited[2].yarns[0].plyTwist_per_m = 900;
  edited[3].ends_per_cm = 21;
  {
    std::vector<std::jthread> makers;
    for (size_t i = 0; i < made.size(); ++i)
      makers.emplace_back([&, i] { made[i] = volumeOf(edited[i], 70, 70, 1, before.get()); });
  }
  for (size_t i = 0; i < made.size(); ++i) EXPECT_TRUE(sameVolume(*volumeOf(edited[i], 70, 70, 1), *made[i])) << i;
}

TEST(Edits, LeaveTheVolumeBeforeAsItWas) {
  const Fabric fabric = jacquard(60);
  const auto before = volumeOf(fabric, 100, 100, 2), copy = volumeOf(fabric, 100, 100, 2);
  Fabric painted = fabric;
  for (int i = 0; i < 30; ++i) painted.weave = painted.weave.with(7, i, !painted.weave.at(7, i));
  const auto after = volumeOf(painted, 100, 100, 2, before.get());
  EXPECT_FALSE(sameVolume(*before, *after));
  EXPECT_TRUE(sameVolume(*before, *copy));
}

}  // namespace
}  // namespace loomlight
