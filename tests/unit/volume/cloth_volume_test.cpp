#include "core/volume/traverse/cloth_volume.h"

#include <gtest/gtest.h>

#include <atomic>

#include "core/base/error.h"
#include "core/volume/pool/tangent_spread.h"
#include "tests/support/voxel_march.h"
#include "tests/unit/volume/volume_fixture.h"

namespace loomlight {
namespace {

using namespace volume_test;

double lengthOf(const CellStrands& strands) {
  double length = 0;
  for (const auto& strand : strands.strands)
    for (uint32_t i = strand.first; i + 1 < strand.first + strand.count; ++i)
      length += glm::distance(glm::dvec3(strands.points[i]), glm::dvec3(strands.points[i + 1]));
  return length;
}

double lengthOf(const BrickView& brick, const VoxelGrid& grid) {
  double length = 0;
  for (int z = 0; z < brick.cell.z; ++z)
    for (int y = -brick.cell.y; y < 2 * brick.cell.y; ++y)
      for (int x = -brick.cell.x; x < 2 * brick.cell.x; ++x) {
        const glm::ivec3 v(x, y, z);
        for (const Component c : brick.at(v)) length += c.lengthDensity() * grid.volume_mm3(v);
      }
  return length;
}

TEST(VoxelGrid, LeafIsAFractionOfTheYarnAndTheSlabIsCovered) {
  for (const int resolution : {1, 2, 4, 8, 16}) {
    const auto geometry = geometryOf(plainFabric(), 4, 4);
    const VoxelGrid grid = makeGrid(*geometry, resolution);
    EXPECT_NEAR(grid.cell.x * static_cast<double>(grid.size_mm.x), geometry->warpPitch_mm(), 1e-6);
    EXPECT_NEAR(grid.cell.y * static_cast<double>(grid.size_mm.y), geometry->weftPitch_mm(), 1e-6);
    EXPECT_NEAR(grid.size_mm.z, geometry->minYarnDiameter_mm() / resolution, 1e-6);
    EXPECT_LE(grid.zLower_mm, -geometry->halfThickness_mm() + 1e-7);
    EXPECT_LT(-grid.zLower_mm, geometry->halfThickness_mm() + grid.size_mm.z);
    EXPECT_EQ(grid.atLevel(grid.levels() - 1).perCell(), glm::ivec3(1));
    EXPECT_TRUE(grid.levels() == 1 || grid.atLevel(grid.levels() - 2).perCell() != glm::ivec3(1));
  }
}

TEST(VoxelGrid, FinestLeafIsNoNarrowerThanAFibre) {
  Fabric fabric = plainFabric();
  fabric.yarns[0].fibresPerPly = 20;
  const auto geometry = geometryOf(fabric, 4, 4);
  const double r = geometry->yarns().minFibreRadius_mm(), d = geometry->minYarnDiameter_mm();
  ASSERT_LT(d / 16, 2 * r);
  EXPECT_NEAR(makeGrid(*geometry, 16).size_mm.z, std::min(2 * r, d / 8), 1e-6);
  EXPECT_NEAR(makeGrid(*geometry, 8).size_mm.z, d / 8, 1e-6);
}

TEST(VoxelGrid, AbsurdClothsGetACoarserLeaf) {
  Fabric fabric = plainFabric();
  fabric.ends_per_cm = fabric.picks_per_cm = 0.2;
  fabric.yarns[0].count_tex = 0.5;
  const VoxelGrid grid = makeGrid(*geometryOf(fabric, 2, 2), 16);
  EXPECT_LE(static_cast<double>(grid.cell.x) * grid.cell.y * grid.cell.z, kMaxCellVoxels);
}

TEST(ClothVolume, IntegratesToTheLengthOfItsFibres) {
  for (const Fabric& fabric : {plainFabric(), hairyTwill(), slubbyTwill()}) {
    const auto volume = volumeOf(fabric, 4, 4, 8);
    const ClothGeometry& geometry = volume->geometry();
    const auto sumOverCells = [](const auto& lengthIn) {
      double sum = 0;
      for (int pick = 0; pick < 4; ++pick)
        for (int end = 0; end < 4; ++end)
          for (const System system : {System::warp, System::weft}) sum += lengthIn(system, pick, end);
      return sum;
    };
    const double expected = sumOverCells([&](System system, int pick, int end) {
      const CellStrands cell = geometry.strands(geometry.key(system, pick, end));
      return cell.fibresEach * lengthOf(cell);  // a thick place has more fibres, of the yarn's own radius
    });
    std::vector<double> lengths;
    for (int level = 0; level < volume->grid().levels(); ++level) {
      const auto coarse = volume->atLevel(level, Task{});
      lengths.push_back(sumOverCells([&](System system, int pick, int end) {
        return lengthOf(coarse->brick(system, pick, end), coarse->grid());
      }));
    }
    EXPECT_NEAR(lengths[0] / expected, 1, 1e-6);
    EXPECT_NEAR(lengths[1] / expected, 1, 1e-5);
    // One voxel holds all; its rounding is 2.5e-4.
    for (const double length : lengths) EXPECT_NEAR(length / expected, 1, 2.5e-4);
  }
}

TEST(ClothVolume, EqualKeysHaveEqualContent) {
  for (const Fabric& fabric : {hairyTwill(), slubbyTwill()}) {
    const auto volume = volumeOf(fabric, 9, 40, 4);
    const auto geometry = geometryOf(fabric, 9, 40);  // another object, to have nothing in common
    for (int pick = 0; pick < 40; ++pick)
      for (int end = 0; end < 9; ++end)
        for (const System system : {System::warp, System::weft}) {
          const YarnCellKey key = geometry->key(system, pick, end);
          EXPECT_EQ(voxelise(geometry->strands(key), system, volume->grid()).view(), volume->brick(system, pick, end))
              << pick << " " << end;
        }
  }
}

TEST(ClothVolume, StoresEachKeyOnceAndNoneThatThePieceLacks) {
  for (const int side : {1, 3, 40}) {
    const auto volume = volumeOf(hairyTwill(), side, side + 1, 2);
    std::unordered_map<uint64_t, const BrickBlock*> bricks;
    size_t segments = 0;
    for (int pick = 0; pick <= side; ++pick)
      for (int end = 0; end < side; ++end)
        for (const System system : {System::warp, System::weft}) {
          const YarnCellKey key = volume->geometry().key(system, pick, end);
          const BrickView brick = volume->brick(system, pick, end);
          if (bricks.emplace(hash(key), brick.blocks).second) segments += brick.segments;
          EXPECT_EQ(bricks[hash(key)], brick.blocks);
        }
    EXPECT_EQ(volume->counts().bricks, bricks.size());
    EXPECT_EQ(volume->counts().segments, segments);
  }
}

/// Optical depth of a patch seen from above, averaged over it; fibres of one radius.
double depthFromAbove(const ClothVolume& volume, double fibreRadius_mm) {
  const glm::vec3 upper = volume.upper_mm();
  double depth = 0;
  const int rays = 400;
  for (int y = 0; y < rays; ++y)
    for (int x = 0; x < rays; ++x) {
      const glm::vec3 origin(upper.x * (x + 0.5f) / rays, upper.y * (y + 0.5f) / rays, 1);
      ClothVolume::March march(volume, origin, {0, 0, -1}, 0, 2);
      while (march.next())
        for (int i = 0; i < march.content().count; ++i)
          for (const Component c : march.content().spans[i].components) {
            const FibreDistribution d = c.decode();
            const float sine2 = 1 - d.direction.z * d.direction.z;
            depth += 2 * fibreRadius_mm * d.lengthDensity *
                     TangentSpread::table().projectedLengthOfSquare(sine2, d.spread) * (march.leave() - march.enter());
          }
    }
  return depth / (rays * rays);
}

// 2 G / (pi rho r) of the areal mass G and the fibre's density rho, where all fibres lie flat: straight untwisted
// yarns.
TEST(ClothVolume, OpticalDepthOfAFlatPatchIsThatOfItsMass) {
  Fabric fabric = plainFabric();
  fabric.weave = Weave(std::vector<std::vector<uint8_t>>{{1}});
  fabric.yarns[0].plyTwist_per_m = 0;
  const auto volume = volumeOf(fabric, 4, 4, 8);
  const ClothGeometry& geometry = volume->geometry();
  const double radius = geometry.yarn(System::warp, 0).fibreRadius_mm;
  ASSERT_NEAR(geometry.yarn(System::weft, 0).fibreRadius_mm / radius, 1, 1e-3);
  const double mass = geometry.measure().arealMass_g_m2, density = fabric.fibres[0].density_g_cm3;
  const double expected = 2 * mass * 1e-3 / (kPi * density * radius);  // g/m^2 = 1e-3 (g/cm^3) mm
  EXPECT_NEAR(depthFromAbove(*volume, radius) / expected, 1, 0.005);
}

// Where they climb: 2 r times the projected length of the fibres over the area.
TEST(ClothVolume, OpticalDepthIsThatOfTheProjectedFibres) {
  const Fabric fabric = plainFabric();
  const int side = 4;
  const auto volume = volumeOf(fabric, side, side, 8);
  const ClothGeometry& geometry = volume->geometry();
  double projected = 0;
  for (int pick = 0; pick < side; ++pick)
    for (int end = 0; end < side; ++end)
      for (const System system : {System::warp, System::weft}) {
        const CellStrands strands = geometry.strands(geometry.key(system, pick, end));
        for (const auto& strand : strands.strands)
          for (uint32_t i = strand.first; i + 1 < strand.first + strand.count; ++i) {
            const glm::dvec3 d = glm::dvec3(strands.points[i + 1]) - glm::dvec3(strands.points[i]);
            projected += std::hypot(d.x, d.y);
          }
      }
  const double radius = geometry.yarn(System::warp, 0).fibreRadius_mm;
  const double area = side * side * geometry.warpPitch_mm() * geometry.weftPitch_mm();
  EXPECT_NEAR(depthFromAbove(*volume, radius) / (2 * radius * projected / area), 1, 0.005);
}

TEST(ClothVolume, MemoryIsThatOfDistinctBricks) {
  const Fabric fabric = jacquard(600);
  const VolumeCounts once = volumeOf(fabric, 600, 600, 2)->counts();
  const VolumeCounts hundred = volumeOf(fabric, 6000, 6000, 2)->counts();
  EXPECT_LE(static_cast<double>(hundred.bytes), 1.1 * static_cast<double>(once.bytes));
  EXPECT_NEAR(hundred.segmentsRepresented / once.segmentsRepresented, 100, 1);
  RecordProperty("bytes_once", std::to_string(once.bytes));
  RecordProperty("bytes_hundred_times", std::to_string(hundred.bytes));
  RecordProperty("bricks", std::to_string(hundred.bricks));
}

TEST(ClothVolume, RepresentsTheSegmentsOfItsGeometry) {
  const auto volume = volumeOf(plainFabric(), 40, 40, 2);
  double segments = 0;
  for (int pick = 0; pick < 40; ++pick)
    for (int end = 0; end < 40; ++end)
      for (const System system : {System::warp, System::weft})
        segments += static_cast<double>(volume->brick(system, pick, end).segments);
  EXPECT_NEAR(volume->counts().segmentsRepresented / segments, 1, 0.01);
}

TEST(ClothVolume, ReuseGivesTheSameBytes) {
  const Fabric fabric = hairyTwill();
  const auto before = volumeOf(fabric, 8, 8, 4);
  Fabric edited = fabric;
  edited.weave = fabric.weave.with(1, 2, !fabric.weave.at(1, 2));
  const auto fresh = volumeOf(edited, 8, 8, 4), reused = volumeOf(edited, 8, 8, 4, before.get());
  EXPECT_TRUE(sameVolume(*fresh, *reused));

  // What the edit did not touch is shared, not copied.
  size_t shared = 0;
  for (int pick = 0; pick < 8; ++pick)
    for (int end = 0; end < 8; ++end)
      shared += reused->brick(System::warp, pick, end).blocks == before->brick(System::warp, pick, end).blocks;
  EXPECT_GT(shared, 20u);
  EXPECT_LT(shared, 64u);

  // Of another weave alone; of other yarns; of another grid.
  Fabric twisted = fabric;
  twisted.yarns[1].plyTwist_per_m *= 1.3;
  EXPECT_TRUE(sameVolume(*volumeOf(twisted, 8, 8, 4), *volumeOf(twisted, 8, 8, 4, before.get())));
  Fabric swapped = fabric;  // the same yarns under other numbers
  std::swap(swapped.yarns[0], swapped.yarns[1]);
  swapped.warpSequence = {1};
  swapped.weftSequence = {0};
  EXPECT_TRUE(sameVolume(*volumeOf(swapped, 8, 8, 4), *volumeOf(swapped, 8, 8, 4, before.get())));
  EXPECT_TRUE(sameVolume(*volumeOf(fabric, 8, 8, 2), *volumeOf(fabric, 8, 8, 2, before.get())));
}

TEST(ClothVolume, ThreadsDoNotChangeIt) {
  const auto geometry = geometryOf(hairyTwill(), 70, 70);
  Task one, three;
  one.threads = 1;
  three.threads = 3;
  EXPECT_TRUE(sameVolume(*ClothVolume::build(geometry, 2, one), *ClothVolume::build(geometry, 2, three)));
}

TEST(ClothVolume, StopsAtABrickAndReportsProgress) {
  const auto geometry = geometryOf(hairyTwill(), 20, 20);
  std::stop_source before;
  before.request_stop();
  EXPECT_EQ(ClothVolume::build(geometry, 2, Task{before.get_token(), {}, 1}), nullptr);

  for (const int threads : {1, 2, 3}) {
    std::stop_source midway;
    std::atomic<int> reports{0};
    const Task task{midway.get_token(),
                    [&](double) {
                      if (++reports == 3) midway.request_stop();
                    },
                    threads};
    EXPECT_EQ(ClothVolume::build(geometry, 2, task), nullptr);
    EXPECT_LE(reports, 3 + threads - 1);  // the other threads are each in the middle of a brick
  }

  std::atomic<double> last{0};
  EXPECT_NE(ClothVolume::build(geometry, 2, Task{{}, [&](double f) { last = f; }, 1}), nullptr);
  EXPECT_EQ(last, 1);
}

}  // namespace
}  // namespace loomlight
