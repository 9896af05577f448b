#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "tests/support/voxel_march.h"
#include "tests/unit/volume/volume_fixture.h"

namespace loomlight {
namespace {

using namespace volume_test;

struct Visit {
  glm::ivec3 voxel;
  double enter, leave;
  std::vector<uint64_t> components;  ///< sorted: the order of a voxel's parts means nothing
  bool operator==(const Visit&) const = default;
};

/// Every voxel of the piece with content, found through brick() alone.
class AllVoxels {
 public:
  explicit AllVoxels(const ClothVolume& volume) : volume_(volume), level_(volume.grid().level) {
    const VoxelGrid& grid = volume.grid();
    const glm::ivec3 perCell = grid.perCell();
    const ClothGeometry& geometry = volume.geometry();
    for (int pick = 0; pick < geometry.picks(); ++pick)
      for (int end = 0; end < geometry.ends(); ++end)
        for (int z = 0; z < perCell.z; ++z)
          for (int y = 0; y < perCell.y; ++y)
            for (int x = 0; x < perCell.x; ++x) add(pick, end, {x, y, z});
  }

  /// By brute force: each voxel's box against the ray.
  std::vector<Visit> crossed(glm::vec3 origin, glm::vec3 direction, float t0, float t1) const {
    std::vector<Visit> result;
    for (const Voxel& voxel : voxels_) {
      double enter = t0, leave = t1;
      for (int axis = 0; axis < 3; ++axis) {
        const double o = origin[axis], d = direction[axis];
        if (d == 0) {
          if (!(voxel.low[axis] <= o && o < voxel.high[axis])) leave = enter;
          continue;
        }
        const double a = (voxel.low[axis] - o) / d, b = (voxel.high[axis] - o) / d;
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
      }
      if (leave > enter) result.push_back({voxel.voxel, enter, leave, voxel.components});
    }
    std::sort(result.begin(), result.end(), [](const Visit& a, const Visit& b) { return a.enter < b.enter; });
    return result;
  }
  bool anySpilled() const { return spilled_; }

 private:
  struct Voxel {
    glm::ivec3 voxel;
    glm::dvec3 low, high;
    std::vector<uint64_t> components;
  };

  void add(int pick, int end, glm::ivec3 v) {
    const VoxelGrid& grid = volume_.grid();
    const glm::ivec3 perCell = grid.perCell();
    const ClothGeometry& geometry = volume_.geometry();
    Voxel voxel{glm::ivec3(end, pick, 0) * perCell + v, {}, {}, {}};
    for (int side = -1; side <= 1; ++side) {
      if (end + side >= 0 && end + side < geometry.ends())
        append(volume_.brick(System::warp, pick, end + side).at(v - glm::ivec3(side * perCell.x, 0, 0)), side, voxel);
      if (pick + side >= 0 && pick + side < geometry.picks())
        append(volume_.brick(System::weft, pick + side, end).at(v - glm::ivec3(0, side * perCell.y, 0)), side, voxel);
    }
    if (voxel.components.empty()) return;
    std::sort(voxel.components.begin(), voxel.components.end());
    const glm::dvec3 pitch(geometry.warpPitch_mm(), geometry.weftPitch_mm(), -2.0 * grid.zLower_mm);
    const glm::dvec3 corner = glm::dvec3(end, pick, 0) * pitch + glm::dvec3(0, 0, grid.zLower_mm);
    const glm::dvec3 leaf = pitch / glm::dvec3(grid.cell);
    voxel.low = corner + leaf * glm::dvec3(v * (1 << level_));
    voxel.high = corner + leaf * glm::dvec3(glm::min((v + 1) * (1 << level_), grid.cell));
    voxels_.push_back(voxel);
  }
  void append(std::span<const Component> components, int side, Voxel& voxel) {
    for (const Component c : components) voxel.components.push_back(c.bits());
    spilled_ |= side != 0 && !components.empty();
  }

  const ClothVolume& volume_;
  int level_;
  bool spilled_ = false;
  std::vector<Voxel> voxels_;
};

Visit visitOf(const ClothVolume::March& march) {
  Visit visit{march.content().voxel, march.enter(), march.leave(), {}};
  for (int i = 0; i < march.content().count; ++i)
    for (const Component c : march.content().spans[i].components) visit.components.push_back(c.bits());
  std::sort(visit.components.begin(), visit.components.end());
  return visit;
}

std::vector<Visit> marched(const ClothVolume& volume, glm::vec3 origin, glm::vec3 direction, float t0, float t1) {
  std::vector<Visit> result;
  ClothVolume::March march(volume, origin, direction, t0, t1);
  while (march.next()) result.push_back(visitOf(march));
  EXPECT_FALSE(march.next()) << "what is over stays over";
  return result;
}

/// Rounding decides whether a ray cuts the very edge of a voxel.
void dropSlivers(std::vector<Visit>& visits, double least) {
  std::erase_if(visits, [=](const Visit& v) { return v.leave - v.enter < least; });
}

void expectSame(std::vector<Visit> found, std::vector<Visit> expected, double speed) {
  const double tolerance = 2e-6 / speed;
  for (size_t i = 0; i + 1 < found.size(); ++i) ASSERT_LE(found[i].leave, found[i + 1].enter);
  double foundLength = 0, expectedLength = 0;
  for (const Visit& v : found) foundLength += v.leave - v.enter;
  for (const Visit& v : expected) expectedLength += v.leave - v.enter;
  EXPECT_NEAR(foundLength, expectedLength, 10 * tolerance);
  dropSlivers(found, 2 * tolerance);
  dropSlivers(expected, 2 * tolerance);
  ASSERT_EQ(found.size(), expected.size());
  for (size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(found[i].voxel, expected[i].voxel);
    EXPECT_NEAR(found[i].enter, expected[i].enter, tolerance);
    EXPECT_NEAR(found[i].leave, expected[i].leave, tolerance);
    EXPECT_EQ(found[i].components, expected[i].components);
  }
}

class MarchTest : public testing::TestWithParam<int> {};

TEST_P(MarchTest, VisitsWhatBruteForceFinds) {
  const int level = GetParam();
  const auto volume = volumeOf(hairyTwill(), 5, 4, 4)->atLevel(level, Task{});
  const AllVoxels all(*volume);
  ASSERT_TRUE(all.anySpilled());
  const glm::vec3 low = volume->lower_mm(), size = volume->upper_mm() - low;
  Random random(3);
  const auto vector = [&] {
    const float x = random.uniform(), y = random.uniform(), z = random.uniform();
    return glm::vec3(x, y, z);
  };
  for (int i = 0; i < 400; ++i) {
    glm::vec3 origin = low + size * (2.0f * vector() - 0.5f);
    glm::vec3 direction = vector() - 0.5f;
    if (i % 4 == 0) direction[i / 4 % 3] = 0;
    if (i % 8 == 0) direction[(i / 8 + 1) % 3] = 0;
    if (direction == glm::vec3(0)) direction.z = -1;
    if (i % 5 == 0) origin = low + size * vector();                    // inside
    if (i % 3 == 0) direction *= std::exp2(8 * random.uniform() - 4);  // of any length
    const float t0 = i % 7 == 0 ? 0.3f * random.uniform() : 0.0f;
    const float t1 = i % 2 == 0 ? std::numeric_limits<float>::infinity() : t0 + random.uniform();
    SCOPED_TRACE(i);
    expectSame(marched(*volume, origin, direction, t0, t1), all.crossed(origin, direction, t0, t1),
               glm::length(direction));
  }
}

TEST_P(MarchTest, RaysOnFacesAndThroughEdgesSeeTheUpperVoxels) {
  const int level = GetParam();
  const auto volume = volumeOf(plainFabric(), 4, 4, 4)->atLevel(level, Task{});
  const AllVoxels all(*volume);
  const VoxelGrid& grid = volume->grid();
  const glm::dvec3 leaf(volume->geometry().warpPitch_mm() / grid.cell.x,
                        volume->geometry().weftPitch_mm() / grid.cell.y, grid.size_mm.z);
  for (int x = 0; x < 2 * grid.cell.x; x += 1 << level)
    for (int z = 0; z < grid.cell.z; z += 1 << level) {
      // Along y through an edge of voxels, up and down. Which voxel a face is in is for its float to say.
      const glm::vec3 origin(x * leaf.x, 0, grid.zLower_mm + z * leaf.z);
      const double wide = 1e-4, t1 = 1.0;
      const auto up = marched(*volume, origin, {0, 1, 0}, 0, 1);
      const auto down = marched(*volume, origin + glm::vec3(0, 1, 0), {0, -1, 0}, 0, 1);
      auto expected = all.crossed(origin, {0, 1, 0}, 0, 1);
      dropSlivers(expected, wide);
      auto seen = up;
      dropSlivers(seen, wide);
      ASSERT_EQ(seen.size(), expected.size());
      for (size_t i = 0; i < seen.size(); ++i) EXPECT_EQ(seen[i].voxel, expected[i].voxel);
      ASSERT_EQ(up.size(), down.size());
      for (size_t i = 0; i < up.size(); ++i) {
        EXPECT_EQ(up[i].voxel, down[down.size() - 1 - i].voxel);
        EXPECT_NEAR(up[i].enter, t1 - down[down.size() - 1 - i].leave, 1e-5);
      }
    }
}

INSTANTIATE_TEST_SUITE_P(Level, MarchTest, testing::Values(0, 1, 2));

TEST(March, StartingOnAFaceSeesWhatLiesAhead) {
  const auto volume = volumeOf(plainFabric(), 3, 3, 4);
  const glm::vec3 top(0.5f * volume->upper_mm().x, 0.5f * volume->upper_mm().y, volume->upper_mm().z);
  const auto from = [&](float lift) { return marched(*volume, top + glm::vec3(0, 0, lift), {0, 0, -1}, 0, 9); };
  const auto above = from(0.5f), onFace = from(0);
  ASSERT_FALSE(above.empty());
  ASSERT_EQ(onFace.size(), above.size());
  for (size_t i = 0; i < above.size(); ++i) {
    EXPECT_EQ(onFace[i].voxel, above[i].voxel);
    EXPECT_NEAR(onFace[i].enter, above[i].enter - 0.5, 1e-6);
  }
  EXPECT_TRUE(marched(*volume, top, {0, 0, 1}, 0, 9).empty());
}

TEST(March, NothingOutsideThePieceNorInNoTime) {
  const auto volume = volumeOf(plainFabric(), 3, 3, 4);
  const glm::vec3 low = volume->lower_mm(), high = volume->upper_mm(), middle = 0.5f * (low + high);
  EXPECT_FALSE(marched(*volume, middle, {1, 0, 0}, -1, 1).empty());
  EXPECT_TRUE(marched(*volume, middle, {1, 0, 0}, 0.1f, 0.1f).empty());
  EXPECT_TRUE(marched(*volume, middle, {1, 0, 0}, 0.2f, 0.1f).empty());
  EXPECT_TRUE(marched(*volume, {high.x, middle.y, middle.z}, {0, 1, 0}, -9, 9).empty()) << "the far face is outside";
  EXPECT_TRUE(marched(*volume, {middle.x, middle.y, high.z + 1}, {1, 0, 0}, -9, 9).empty());
}

TEST(March, WhatIsNotFiniteEnds) {
  const auto volume = volumeOf(plainFabric(), 3, 3, 2);
  const float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
  const glm::vec3 middle = 0.5f * (volume->lower_mm() + volume->upper_mm());
  for (const float bad : {inf, -inf, nan}) {
    for (int axis = 0; axis < 3; ++axis) {
      glm::vec3 v(0.1f);
      v[axis] = bad;
      EXPECT_TRUE(marched(*volume, v, {0, 0, 1}, 0, 1).empty());
      EXPECT_TRUE(marched(*volume, middle, v, 0, 1).empty());
    }
  }
  EXPECT_TRUE(marched(*volume, middle, {0, 0, 1}, nan, 1).empty());
  EXPECT_TRUE(marched(*volume, middle, {0, 0, 1}, 0, nan).empty());
  // All of a line, and a ray that does not move.
  EXPECT_FALSE(marched(*volume, middle, {1, 0, 0}, -inf, inf).empty());
  EXPECT_LE(marched(*volume, middle, {0, 0, 0}, 0, inf).size(), 1u);
  EXPECT_LE(marched(*volume, middle, {1e-44f, 0, 0}, 0, 1).size(), 1u);
}

TEST(March, GoesOnFromWhereItStands) {
  const auto volume = volumeOf(hairyTwill(), 5, 4, 4);
  const glm::vec3 low = volume->lower_mm(), high = volume->upper_mm();
  const glm::vec3 there = glm::normalize(high - low), back = -there;
  const std::vector<Visit> ahead = marched(*volume, low, there, 0, 9), behind = marched(*volume, high, back, 0, 9);
  ASSERT_GT(ahead.size(), 10u);
  ASSERT_GT(behind.size(), 10u);
  // Two rays take turns, and from each place a copy goes on alone.
  ClothVolume::March first(*volume, low, there, 0, 9), second(*volume, high, back, 0, 9);
  for (size_t i = 0; i < ahead.size() || i < behind.size(); ++i) {
    ASSERT_EQ(first.next(), i < ahead.size());
    ASSERT_EQ(second.next(), i < behind.size());
    if (i >= ahead.size()) continue;
    EXPECT_EQ(visitOf(first), ahead[i]);
    ClothVolume::March copy = first;
    for (size_t j = i + 1; j < ahead.size(); ++j) {
      ASSERT_TRUE(copy.next());
      ASSERT_EQ(visitOf(copy), ahead[j]);
    }
    EXPECT_FALSE(copy.next());
    EXPECT_EQ(visitOf(first), ahead[i]) << "the one that was copied stands where it stood";
  }
}

TEST(March, NamesTheYarnAndTheCell) {
  const auto volume = volumeOf(slubbyTwill(), 6, 6, 4);
  const ClothGeometry& geometry = volume->geometry();
  const VoxelGrid& grid = volume->grid();
  int warp = 0, weft = 0, neighbours = 0;
  for (int i = 0; i < 20; ++i) {
    const float y = volume->upper_mm().y * (static_cast<float>(i) + 0.37f) / 20;
    ClothVolume::March march(*volume, {0, y, -0.04f}, {1, 0, 0.01f}, 0, 9);
    while (march.next()) {
      const VoxelContent& content = march.content();
      EXPECT_EQ(content.end, static_cast<int>(0.5f * (march.enter() + march.leave()) / geometry.warpPitch_mm()));
      EXPECT_EQ(content.pick, static_cast<int>(y / geometry.weftPitch_mm()));
      EXPECT_EQ(content.voxel.x / grid.cell.x, content.end);
      EXPECT_EQ(content.voxel.y / grid.cell.y, content.pick);
      for (int p = 0; p < content.count; ++p) {
        const VoxelContent::YarnSpan& span = content.spans[p];
        const bool isWarp = span.system == System::warp;
        const int own = isWarp ? content.end : content.pick;
        EXPECT_LE(std::abs(span.index - own), 1);
        const BrickView brick =
            volume->brick(span.system, isWarp ? content.pick : span.index, isWarp ? span.index : content.end);
        const Component* first = brick.components.data();
        EXPECT_GE(span.components.data(), first) << "of the yarn that it names";
        EXPECT_LT(span.components.data(), first + brick.components.size());
        neighbours += span.index != own;
        ++(isWarp ? warp : weft);
      }
    }
  }
  EXPECT_GT(warp, 0);
  EXPECT_GT(weft, 0);
  EXPECT_GT(neighbours, 0);
}

TEST(March, ContentAtAPointIsThatOfTheVoxelAroundIt) {
  const auto volume = volumeOf(hairyTwill(), 5, 4, 4);
  Random random(8);
  int found = 0;
  for (int i = 0; i < 300; ++i) {
    const float y = random.uniform(), z = random.uniform();
    const glm::vec3 size = volume->upper_mm() - volume->lower_mm();
    const glm::vec3 origin = volume->lower_mm() + size * glm::vec3(0, y, z);
    ClothVolume::March march(*volume, origin, {1, 0, 0}, 0, size.x);
    while (march.next()) {
      if (march.leave() - march.enter() < 1e-4f) continue;
      const VoxelContent& content = march.content();
      VoxelContent at;
      volume->contentAt(origin + glm::vec3(0.5f * (march.enter() + march.leave()), 0, 0), at);
      EXPECT_EQ(at.voxel, content.voxel);
      EXPECT_EQ(at.count, content.count);
      for (int p = 0; p < at.count; ++p) EXPECT_EQ(at.spans[p].components.data(), content.spans[p].components.data());
      ++found;
    }
  }
  EXPECT_GT(found, 1000);
  VoxelContent outside;
  volume->contentAt(volume->upper_mm(), outside);
  EXPECT_EQ(outside.count, 0);
  volume->contentAt(glm::vec3(std::numeric_limits<float>::quiet_NaN()), outside);
  EXPECT_EQ(outside.count, 0);
}

}  // namespace
}  // namespace loomlight
