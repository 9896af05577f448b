#include "core/volume/build/voxelise.h"

#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/volume/pool/tangent_spread.h"
#include "tests/support/sample_tangent.h"

namespace loomlight {
namespace {

/// A cell of 0.4 x 0.5 x 0.3 mm in voxels that are no cubes, nor a power of two a side.
VoxelGrid oddGrid() {
  VoxelGrid grid;
  grid.cell = {11, 13, 6};
  grid.size_mm = {0.4f / 11, 0.5f / 13, 0.05f};
  grid.zLower_mm = -0.15f;
  return grid;
}

VoxelGrid oneVoxel(float side) {
  return {.cell = {1, 1, 1}, .size_mm = glm::vec3(side), .zLower_mm = -side / 2};
}

void addStrand(CellStrands& strands, const std::vector<glm::vec3>& points, int ply = 0) {
  CellStrands::Strand strand;
  strand.first = static_cast<uint32_t>(strands.points.size());
  strand.count = static_cast<uint32_t>(points.size());
  strand.ply = static_cast<uint8_t>(ply);
  strands.points.insert(strands.points.end(), points.begin(), points.end());
  strands.strands.push_back(strand);
}

double fibreLength(const CellStrands& strands) {
  double length = 0;
  for (const auto& strand : strands.strands)
    for (uint32_t i = strand.first; i + 1 < strand.first + strand.count; ++i)
      length += glm::distance(glm::dvec3(strands.points[i]), glm::dvec3(strands.points[i + 1]));
  return length;
}

/// Visits every voxel of a brick that could be occupied: visit(voxel, components).
template <class Visit>
void forEachVoxel(const Brick& brick, const Visit& visit) {
  for (int z = 0; z < brick.cell.z; ++z)
    for (int y = -brick.cell.y; y < 2 * brick.cell.y; ++y)
      for (int x = -brick.cell.x; x < 2 * brick.cell.x; ++x) {
        const glm::ivec3 v(x, y, z);
        if (const auto components = brick.at(v); !components.empty()) visit(v, components);
      }
}

double fibreLength(const Brick& brick, const VoxelGrid& grid) {
  double length = 0;
  forEachVoxel(brick, [&](glm::ivec3 v, std::span<const Component> components) {
    for (const Component c : components) length += c.lengthDensity() * grid.volume_mm3(v);
  });
  return length;
}

/// Wandering fibres that fill a yarn of half-width `halfWidth` in a cell of oddGrid().
CellStrands wanderingFibres(int fibres, float halfWidth, int plies, uint64_t seed, System system = System::warp) {
  Random random(seed);
  CellStrands strands;
  const float half = system == System::warp ? 0.25f : 0.2f;
  for (int f = 0; f < fibres; ++f) {
    std::vector<glm::vec3> points;
    glm::vec2 p((2 * random.uniform() - 1) * halfWidth, (2 * random.uniform() - 1) * 0.15f);
    for (int i = 0; i <= 40; ++i) {
      points.push_back({p.x, half * (static_cast<float>(i) / 20 - 1), p.y});
      p += 0.02f * glm::vec2(random.uniform() - 0.5f, random.uniform() - 0.5f);
      p = glm::clamp(p, glm::vec2(-halfWidth, -0.15f), glm::vec2(halfWidth, 0.15f));
    }
    addStrand(strands, points, f % plies);
  }
  return strands;
}

/// Straight fibres along a warp cell of oddGrid(), which fill it from rim to rim across, and all of its height.
CellStrands sheetOfFibres(float from_mm, float to_mm, int fibres) {
  Random random(12);
  CellStrands strands;
  for (int f = 0; f < fibres; ++f) {
    const float u = from_mm + (to_mm - from_mm) * random.uniform(), z = 0.3f * random.uniform() - 0.15f;
    addStrand(strands, {{u, -0.25f, z}, {u, 0.0f, z}, {u, 0.25f, z}});
  }
  return strands;
}

// At a rim the fibres of a voxel lie in a box that ends where they do; elsewhere they lie in all of it.
TEST(Voxelise, FibresLieInBoxesThatEndAtTheRimOfTheYarn) {
  const VoxelGrid grid = oddGrid();
  const float from = -0.07f, to = 0.05f;
  constexpr int kFibres = 6000;
  const CellStrands sheet = sheetOfFibres(from, to, kFibres);
  const Brick brick = voxelise(sheet, System::warp, grid);
  const float width = grid.size_mm.x, lowerFace = -0.2f;
  // The fibre that lies outermost in a voxel's height is not far from the rim: with that probability all of those boxes
  // are as they should be. And an edge is off by half a seventh.
  const double inVoxel = kFibres / 6.0, gap = (to - from) * std::log(1e6) / inVoxel;
  int rims = 0;
  forEachVoxel(brick, [&](glm::ivec3 v, std::span<const Component> components) {
    ASSERT_EQ(components.size(), 1u);
    const VoxelBox box = components[0].box();
    const float left = lowerFace + static_cast<float>(v.x) * width, right = left + width;
    EXPECT_NEAR(left + width * box.lowerCorner().x, std::max(from, left), gap + width / 14 + 1e-5);
    EXPECT_NEAR(left + width * box.upperCorner().x, std::min(to, right), gap + width / 14 + 1e-5);
    rims += left < from || right > to;
    for (const int axis : {1, 2}) {
      EXPECT_EQ(box.lower()[axis], 0) << axis;
      EXPECT_EQ(box.upper()[axis], VoxelBox::kParts) << axis;
    }
  });
  EXPECT_EQ(rims, 2 * grid.cell.y * grid.cell.z);

  // Fibres of a coarser voxel may lie anywhere in it.
  forEachVoxel(voxelise(sheet, System::warp, grid.atLevel(1)), [](glm::ivec3, std::span<const Component> components) {
    for (const Component c : components) EXPECT_EQ(c.box(), VoxelBox());
  });
}

// A lone fibre has a section: a box about it is no narrower than spreads an even density as far as a disc is spread,
// 3^(1/2) r, and lines that waver on a sphere of (9/8)^(1/2) r about the axis do not make it wider than (4.5 + 3)^(1/2)
// r. In a voxel that is not as wide, it ends at the faces.
TEST(Voxelise, ALoneFibreLiesInABoxOfItsOwnWidth) {
  const float side = 0.05f, half = side / 2;
  Random random(6);
  for (const float radius : {0.1f * side, 0.2f * side, 0.45f * side, 2 * side}) {
    for (int i = 0; i < 500; ++i) {
      const glm::vec2 at = (0.9f * side) * (glm::vec2(random.uniform(), random.uniform()) - 0.5f);
      CellStrands strands;
      strands.fibreRadius_mm = radius;
      addStrand(strands, {{at.x, -half, at.y}, {at.x, 0, at.y}, {at.x, half, at.y}});
      const Brick brick = voxelise(strands, System::warp, oneVoxel(side));
      for (const Component c : brick.at({0, 0, 0})) {
        const glm::vec3 lower = side * (c.box().lowerCorner() - 0.5f), upper = side * (c.box().upperCorner() - 0.5f);
        const float part = side / VoxelBox::kParts;
        for (const int axis : {0, 2}) {
          const float low = lower[axis], high = upper[axis];
          EXPECT_LE(high - low, std::sqrt(7.5f) * radius + part + 1e-6f);
          if (low > -half && high < half) {
            EXPECT_GE(high - low, std::sqrt(3.0f) * radius - part - 1e-6f);
          }
        }
      }
    }
  }
}

// Equation 6 of the report as it must be: 2 r l sin(alpha) / V, whatever the direction of the fibre in the voxel.
TEST(Voxelise, AFibreInAnyDirectionHasItsProjectedAreaOverTheVolume) {
  const float side = 0.2f, radius = 0.006f;
  Random random(5);
  for (int i = 0; i < 2000; ++i) {
    const glm::vec3 t = glm::normalize(glm::vec3(random.uniform(), random.uniform(), random.uniform()) - 0.5f);
    const float length = 0.02f + 0.15f * random.uniform();
    CellStrands strands;
    addStrand(strands, {-0.5f * length * t, 0.5f * length * t});
    const Brick brick = voxelise(strands, System::warp, oneVoxel(side));
    const auto components = brick.at({0, 0, 0});
    ASSERT_EQ(components.size(), 1u);
    const FibreDistribution d = components[0].decode();
    ASSERT_EQ(d.spread, 0);
    for (int j = 0; j < 8; ++j) {
      const glm::vec3 ray = glm::normalize(glm::vec3(random.uniform(), random.uniform(), random.uniform()) - 0.5f);
      const double sine = glm::length(glm::cross(glm::dvec3(ray), glm::dvec3(t)));
      if (sine < 0.07) continue;  // within 4 degrees of the fibre the code of its direction shows
      const float cosine = glm::dot(ray, d.direction);
      const double sigma =
          2 * radius * d.lengthDensity * TangentSpread::table().projectedLengthOfSquare(1 - cosine * cosine, d.spread);
      const double expected = 2 * radius * length * sine / (side * side * side);
      ASSERT_NEAR(sigma / expected, 1, 0.01) << "sine " << sine;
    }
  }
}

TEST(Voxelise, EveryVoxelHasTheLengthClippedToIt) {
  // One long oblique segment against clipping to each box by itself.
  const VoxelGrid grid = oddGrid();
  const glm::vec3 a(-0.19f, -0.25f, -0.149f), b(0.17f, 0.25f, 0.14f);  // (u, s, z)
  CellStrands strands;
  addStrand(strands, {a, b});
  const Brick brick = voxelise(strands, System::warp, grid);
  int visited = 0;
  for (int z = 0; z < grid.cell.z; ++z)
    for (int y = 0; y < grid.cell.y; ++y)
      for (int x = 0; x < grid.cell.x; ++x) {
        const glm::dvec3 size(grid.size_mm);
        const glm::dvec3 low = size * glm::dvec3(x, y, z) - glm::dvec3(0.2, 0.25, 0.15), high = low + size;
        const glm::dvec3 d = glm::dvec3(b) - glm::dvec3(a);
        double enter = 0, leave = 1;
        for (int axis = 0; axis < 3; ++axis) {
          enter = std::max(enter, (low[axis] - a[axis]) / d[axis]);
          leave = std::min(leave, (high[axis] - a[axis]) / d[axis]);
        }
        const double expected = std::max(0.0, leave - enter) * glm::length(d) / (size.x * size.y * size.z);
        const auto components = brick.at({x, y, z});
        const double stored = components.empty() ? 0 : components[0].lengthDensity();
        EXPECT_NEAR(stored, expected, 3e-4 * expected + 0.02) << x << " " << y << " " << z;
        visited += !components.empty();
      }
  EXPECT_GE(visited, 20);
}

TEST(Voxelise, LengthIsConservedAtEveryLevel) {
  for (const System system : {System::warp, System::weft})
    for (const int plies : {1, 2, 5}) {
      const CellStrands strands = wanderingFibres(200, 0.3f, plies, 7, system);
      const double length = fibreLength(strands);
      ASSERT_EQ(oddGrid().levels(), 5);
      for (int level = 0; level < 5; ++level) {
        const VoxelGrid grid = oddGrid().atLevel(level);
        const Brick brick = voxelise(strands, system, grid);
        EXPECT_EQ(brick.cell, grid.perCell());
        // What is left is the rounding of the shortest component of the level.
        const double bound = brick.components.size() > 100 ? 1e-6 : 2.5e-4;
        EXPECT_NEAR(fibreLength(brick, grid) / length, 1, bound) << "level " << level << ", plies " << plies;
      }
    }
}

TEST(Voxelise, YarnsLieInClothAxes) {
  const VoxelGrid grid = oddGrid();
  CellStrands strands;
  addStrand(strands, {{0.15f, -0.1f, 0.12f}, {0.15f, 0.1f, 0.12f}});  // u = +0.15, along s
  const Brick warp = voxelise(strands, System::warp, grid);
  forEachVoxel(warp, [&](glm::ivec3 v, std::span<const Component> components) {
    EXPECT_EQ(v.x, static_cast<int>(0.35f / grid.size_mm.x));  // x = +u
    EXPECT_EQ(v.z, 5);
    EXPECT_EQ(glm::abs(components[0].decode().direction), glm::vec3(0, 1, 0));
  });
  const Brick weft = voxelise(strands, System::weft, grid);
  forEachVoxel(weft, [&](glm::ivec3 v, std::span<const Component> components) {
    EXPECT_EQ(v.y, static_cast<int>(0.1f / grid.size_mm.y));  // y = -u
    EXPECT_EQ(glm::abs(components[0].decode().direction), glm::vec3(1, 0, 0));
  });
  EXPECT_GT(warp.view().voxels(), 4u);
  EXPECT_GT(weft.view().voxels(), 4u);
}

TEST(Voxelise, AYarnSpillsIntoTheCellsBesideIt) {
  const VoxelGrid grid = oddGrid();
  CellStrands strands;
  addStrand(strands, {{-0.6f, 0, 0}, {0.6f, 0, 0}});  // |u| = 1.5 cells: all that a yarn may reach
  const Brick warp = voxelise(strands, System::warp, grid);
  for (int x = -grid.cell.x; x < 2 * grid.cell.x; ++x) EXPECT_EQ(warp.at({x, 6, 3}).size(), 1u) << x;
  EXPECT_EQ(warp.view().voxels(), 3u * grid.cell.x);
  // Coarser voxels begin anew in each cell: 11 leaves are 6, 3, 2, 1 voxels.
  const int perCell[] = {11, 6, 3, 2, 1};
  for (int level = 0; level < grid.levels(); ++level) {
    const Brick coarse = voxelise(strands, System::warp, grid.atLevel(level));
    size_t count = 0;
    forEachVoxel(coarse, [&](glm::ivec3 v, std::span<const Component> components) {
      EXPECT_GE(v.x, -perCell[level]);
      EXPECT_LT(v.x, 2 * perCell[level]);
      // The voxels that the cell's edge cuts have their true volume, so a fibre of one direction has one density.
      EXPECT_NEAR(components[0].lengthDensity() / coarse.at({0, v.y, v.z})[0].lengthDensity(), 1, 2e-3);
      ++count;
    });
    EXPECT_EQ(count, 3u * perCell[level]);
  }
}

TEST(Voxelise, FacesBelongToTheUpperVoxel) {
  // Fibres exactly within a face between voxels, and on the cell's faces.
  VoxelGrid grid{.cell = {4, 4, 4}, .size_mm = glm::vec3(0.25f), .zLower_mm = -0.5f};
  CellStrands strands;
  addStrand(strands, {{0, -0.5f, 0}, {0, 0.5f, 0}});
  const Brick brick = voxelise(strands, System::warp, grid);
  EXPECT_EQ(brick.view().voxels(), 4u);
  for (int y = 0; y < 4; ++y) EXPECT_EQ(brick.at({2, y, 2}).size(), 1u);

  CellStrands top;
  addStrand(top, {{0, -0.5f, 0.5f}, {0, 0.5f, 0.5f}});
  EXPECT_EQ(voxelise(top, System::warp, grid).at({2, 0, 3}).size(), 1u) << "the top layer is the last there is";

  CellStrands back;  // ends on a face, coming from above and from below
  addStrand(back, {{0.25f, 0, 0}, {0, 0, 0}, {0.25f, 0, 0}});
  const Brick there = voxelise(back, System::warp, grid);
  EXPECT_EQ(there.view().voxels(), 1u);
  EXPECT_NEAR(there.at({2, 2, 2})[0].lengthDensity(), 0.5 / (0.25 * 0.25 * 0.25), 0.01);
}

TEST(Voxelise, ComponentsAreThePliesInTheVoxelAndAtMostTwo) {
  VoxelGrid grid = oneVoxel(1);
  CellStrands strands;
  addStrand(strands, {{-0.4f, 0, 0}, {0.4f, 0, 0}}, 0);
  addStrand(strands, {{0, -0.3f, 0}, {0, 0.3f, 0}}, 1);
  const Brick two = voxelise(strands, System::warp, grid);
  auto components = two.at({0, 0, 0});
  ASSERT_EQ(components.size(), 2u);
  EXPECT_NEAR(components[0].decode().lengthDensity, 0.8, 1e-3);
  EXPECT_NEAR(components[1].decode().lengthDensity, 0.6, 1e-3);

  // A third, almost parallel to the first, joins it.
  addStrand(strands, {{-0.2f, 0.02f, 0}, {0.2f, 0, 0}}, 2);
  const Brick three = voxelise(strands, System::warp, grid);
  components = three.at({0, 0, 0});
  ASSERT_EQ(components.size(), 2u);
  EXPECT_NEAR(components[0].decode().lengthDensity, 1.2, 2e-3);
  EXPECT_NEAR(components[1].decode().lengthDensity, 0.6, 2e-3);
  EXPECT_GT(components[0].decode().spread, 0);
  EXPECT_LT(components[0].decode().spread, 0.05);
}

TEST(Voxelise, SpreadIsThatOfTheFibres) {
  Random random(11);
  for (const float s : {0.05f, 0.2f, 0.5f}) {
    CellStrands strands;
    const FibreDistribution truth{.direction = glm::normalize(glm::vec3(1, 2, -0.5f)), .spread = s};
    for (int i = 0; i < 20000; ++i) {
      const float u1 = random.uniform(), u2 = random.uniform();
      const glm::vec3 half = 0.3f * test::sampleTangent(truth, u1, u2);
      addStrand(strands, {-half, half});
    }
    const FibreDistribution d = voxelise(strands, System::warp, oneVoxel(1)).at({0, 0, 0})[0].decode();
    EXPECT_NEAR(d.spread / s, 1, 0.02);
    EXPECT_GT(std::abs(glm::dot(d.direction, truth.direction)), std::cos(0.02f));
  }
}

TEST(Voxelise, IsotropicFibresAreIsotropic) {
  CellStrands strands;
  addStrand(strands, {{-0.4f, 0, 0}, {0.4f, 0, 0}});
  addStrand(strands, {{0, -0.4f, 0}, {0, 0.4f, 0}});
  addStrand(strands, {{0, 0, -0.4f}, {0, 0, 0.4f}});
  const FibreDistribution d = voxelise(strands, System::warp, oneVoxel(1)).at({0, 0, 0})[0].decode();
  EXPECT_EQ(d.spread, 1);
  EXPECT_NEAR(glm::length(d.direction), 1, 1e-6);
}

TEST(Voxelise, SameInputSameBytes) {
  const CellStrands strands = wanderingFibres(150, 0.35f, 3, 9);
  const Brick once = voxelise(strands, System::warp, oddGrid()), again = voxelise(strands, System::warp, oddGrid());
  EXPECT_EQ(once.view(), again.view());
}

TEST(Voxelise, NothingGivesEmptyBricks) {
  for (int level = 0; level < oddGrid().levels(); ++level) {
    const Brick brick = voxelise({}, System::weft, oddGrid().atLevel(level));
    EXPECT_EQ(brick.view().voxels(), 0u);
    EXPECT_TRUE(brick.at({0, 0, 0}).empty());
  }
}

TEST(Voxelise, PointsWithoutLengthOrBeyondTheCellDoNoHarm) {
  CellStrands strands;
  addStrand(strands, {{0, 0, 0}, {0, 0, 0}});
  addStrand(strands, {{-9, 0.26f, -1}, {9, -0.26f, 1}});
  const Brick brick = voxelise(strands, System::warp, oddGrid());
  EXPECT_NEAR(fibreLength(brick, oddGrid()) / fibreLength(strands), 1, 1e-4);
}

}  // namespace
}  // namespace loomlight
