#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "core/base/units.h"
#include "render/media/known_lanes.h"

namespace loomlight {
namespace {

/// One voxel of straight warp (along y) and weft (along x), 1000 / mm^2 each, and rays that come to its middle.
class CrossedVoxel {
 public:
  static constexpr float kDensity = 1000, kRadius_mm = 0.006f;

  /// Where they lie in it.
  explicit CrossedVoxel(VoxelBox weft = {}, VoxelBox warp = {}) {
    components_[0] = Component::encode({{0, 1, 0}, 0.0f, kDensity}).within(warp);
    components_[1] = Component::encode({{1, 0, 0}, 0.0f, kDensity}).within(weft);
    for (uint32_t i = 0; i < 2; ++i) blocks_[i] = {.occupied = 1, .second = 0, .first = i};
    field.blocks = blocks_.data();
    field.components = components_.data();
    field.hotSpot = false;
  }

  WalkField field;

  /// Fills in a lane's place; the first `bricks` from that one on.
  void put(VoxelPlaceLanes& lanes, size_t lane, glm::vec3 direction, int firstBrick = 0, int bricks = 2) const {
    lanes.wanted[lane] = 1;
    loomlight::put(lanes.direction, lane, direction);
    loomlight::put(lanes.inVoxel, lane, glm::vec3(0.5f));
    for (int column = 0; column < 3; ++column) lanes.frame[column][column][lane] = 1;
    lanes.densityScale[lane] = 1;
    lanes.cell.count[lane] = bricks;
    for (int slot = 0; slot < bricks; ++slot) {
      CellLanes::Slot& brick = lanes.cell.slots[slot];
      loomlight::put(brick.size, lane, glm::ivec3(1));
      brick.firstBlock[lane] = firstBrick + slot;
      brick.yarn[lane] = numberOf({firstBrick + slot == 0 ? System::warp : System::weft, 7});
      brick.radius_mm[lane] = kRadius_mm;
      brick.packed[lane] = 1;
    }
  }

  /// Extinction of one yarn, 1/mm, in cloth with that frame.
  float extinction(int brick, glm::vec3 direction, const glm::mat3& frame = glm::mat3(1.0f)) {
    LookLanes looks{};
    put(looks, 3, direction, brick, 1);
    for (int column = 0; column < 3; ++column) loomlight::put(looks.frame[column], 3, frame[column]);
    looks.densityScale[3] = 1 / glm::determinant(frame);
    field.flat = frame == glm::mat3(1.0f);
    look(field, looks);
    return looks.found.whole[3];
  }

  /// How many of many rays choose the warp, of all; `known` of fibres, where the light is in the middle of the voxel.
  double shareOfWarp(glm::vec3 direction, const KnownFibres& known = {}) const {
    constexpr int kRounds = 250;
    int warp = 0;
    for (int round = 0; round < kRounds; ++round) {
      ChoiceLanes choices{};
      for (size_t lane = 0; lane < kWalkLanes; ++lane) {
        put(choices, lane, direction);
        choices.u[lane] = (static_cast<float>(round * kWalkLanes + lane) + 0.5f) / (kRounds * kWalkLanes);
        putPastSegments(choices.known, lane, known, kMiddle);
        choices.known.before.yarn[lane] = numberOf(known.before.yarnId);
        choices.known.before.radius_mm[lane] = known.before.radius_mm;
        loomlight::put(choices.known.before.axis_mm, lane, known.before.axis);
        loomlight::put(choices.known.before.tangent, lane, known.before.tangent);
      }
      chooseComponents(field, choices);
      for (size_t lane = 0; lane < kWalkLanes; ++lane) warp += choices.component[lane] == 0 ? 1 : 0;
    }
    return static_cast<double>(warp) / (kRounds * kWalkLanes);
  }
  static constexpr glm::vec3 kMiddle{0.5f, 0.5f, 0.5f};  ///< voxels are 1 mm wide

 private:
  std::array<BrickBlock, 2> blocks_;
  std::array<Component, 2> components_;
};

/// Over the warp, along y, at an elevation.
glm::vec3 overTheWarp(double degrees) {
  const double e = degrees * kPi / 180;
  return {0, std::cos(e), -std::sin(e)};
}

TEST(Choices, AreOfYarnsAsARayMeetsThem) {
  // A fibre shows sin(angle) of its length to a ray: of the warp, seen end-on, sin e; of the weft, seen from the side,
  // all. With a black warp and a white weft this share is the colour at grazing angles.
  const CrossedVoxel voxel;
  for (const double degrees : {5.0, 10.0, 20.0, 45.0, 90.0}) {
    const double seen = std::sin(degrees * kPi / 180);
    EXPECT_NEAR(voxel.shareOfWarp(overTheWarp(degrees)), seen / (1 + seen), 0.005) << degrees;
  }
}

TEST(Choices, OfTheReportIgnoreTheAngle) {
  CrossedVoxel voxel;
  voxel.field.byDensity = true;
  for (const double degrees : {5.0, 20.0, 90.0}) EXPECT_NEAR(voxel.shareOfWarp(overTheWarp(degrees)), 0.5, 0.005);
}

TEST(Choices, AreAmongFibresInWhoseBoxesThePlaceIs) {
  // The weft lies in three sevenths of the voxel, so much denser there, or where the place is not.
  const auto box = [](float lower, float upper) {
    return VoxelBox::nearest(Float32x4{0, 0, lower, 0}, Float32x4{1, 1, upper, 1});
  };
  CrossedVoxel around(box(2.0f / 7, 5.0f / 7)), below(box(0, 2.0f / 7));
  EXPECT_NEAR(around.shareOfWarp({0, 0, -1}), 1 / (1 + 7.0 / 3), 0.005);
  EXPECT_EQ(below.shareOfWarp({0, 0, -1}), 1.0);
  below.field.boxes = false;
  EXPECT_NEAR(below.shareOfWarp({0, 0, -1}), 0.5, 0.005);
}

TEST(Choices, LeaveOutWhatWasSeenToBeAbsent) {
  // The path came down half a fibre's radius beside the way by which it goes up again.
  CrossedVoxel voxel;
  KnownFibres known;
  const float beside_mm = 0.5f * CrossedVoxel::kRadius_mm;  // across the warp, along the weft
  known.pastSegments[0] = {CrossedVoxel::kMiddle + glm::vec3(beside_mm, 0, -0.3f), {0, 0, -1}, 0.6f};
  EXPECT_NEAR(voxel.shareOfWarp({0, 0, 1}, known), 0.5, 0.005) << "without the hot spot nothing is known";
  voxel.field.hotSpot = true;
  // Of the warp 1 - beside / 2r = 3/4 is absent; the weft is in line with the flight, so all of it is.
  EXPECT_NEAR(voxel.shareOfWarp({0, 0, 1}, known), 1.0, 0.005);
  known.pastSegments[0].end += glm::vec3(0, beside_mm, 0);
  EXPECT_NEAR(voxel.shareOfWarp({0, 0, 1}, known), 0.5, 0.005) << "both are seen as far off";
  known.pastSegments[0].end.x += beside_mm;
  EXPECT_NEAR(voxel.shareOfWarp({0, 0, 1}, known), 0.5 / (0.5 + 0.25), 0.005);
}

TEST(Choices, LeaveOutTheFibreThatTheLightLastLeft) {
  CrossedVoxel voxel;
  voxel.field.hotSpot = true;
  KnownFibres known;
  known.before = {.axis = CrossedVoxel::kMiddle,
                  .tangent = {0, 1, 0},
                  .radius_mm = CrossedVoxel::kRadius_mm,
                  .yarnId = {System::warp, 7}};
  EXPECT_NEAR(voxel.shareOfWarp({0, 0, 1}, known), 0.5, 0.005) << "one fibre in a thousand";
  // The narrower the voxel, the more of its warp is that fibre: here half of it.
  voxel.field.size_mm[0] = voxel.field.size_mm[2] = std::sqrt(2 / CrossedVoxel::kDensity);
  known.before.axis = 0.5f * glm::vec3(voxel.field.size_mm[0], 1, voxel.field.size_mm[2]);
  EXPECT_NEAR(voxel.shareOfWarp({0, 0, 1}, known), 0.5 / (1 + 0.5), 0.005);
  known.before.yarnId.index = 8;
  EXPECT_NEAR(voxel.shareOfWarp({0, 0, 1}, known), 0.5, 0.005) << "of another end";
}

TEST(Choices, AreOfOneOfThemWhereNothingCounts) {
  const auto below = VoxelBox::nearest(Float32x4{}, Float32x4{1, 1, 2.0f / 7, 1});
  const CrossedVoxel voxel(below, below);
  ChoiceLanes choices{};
  constexpr std::array<float, 3> kNumbers{0.0f, 0.5f, 0x1.fffffep-1f};  // the last is the largest below 1
  for (size_t lane = 0; lane < kNumbers.size(); ++lane) {
    voxel.put(choices, lane, {0, 0, -1});
    choices.u[lane] = kNumbers[lane];
  }
  constexpr size_t kEmpty = 3;
  voxel.put(choices, kEmpty, {0, 0, -1});
  put(choices.voxel, kEmpty, {1, 0, 0});
  chooseComponents(voxel.field, choices);
  for (size_t lane = 0; lane < kNumbers.size(); ++lane)
    EXPECT_TRUE(choices.component[lane] == 0 || choices.component[lane] == 1) << kNumbers[lane];
  EXPECT_EQ(choices.component[kEmpty], FoundLanes::kNone);
}

TEST(Choices, OfWhatCountsNoneIsLeftOutByAnyNumber) {
  // Whatever the number, what lies elsewhere in the voxel is never met.
  const CrossedVoxel voxel(VoxelBox::nearest(Float32x4{}, Float32x4{1, 1, 2.0f / 7, 1}));
  ChoiceLanes choices{};
  for (size_t lane = 0; lane < kWalkLanes; ++lane) {
    voxel.put(choices, lane, {0, 0, -1});
    choices.u[lane] = 1 - std::exp2(-2.0f * static_cast<float>(lane));  // ... 1 - 2^-24, then 1 itself, by rounding
  }
  chooseComponents(voxel.field, choices);
  for (size_t lane = 0; lane < kWalkLanes; ++lane) EXPECT_EQ(choices.component[lane], 0) << lane;
}

TEST(Looks, FindTheProjectedAreaOfFibres) {
  CrossedVoxel voxel;
  const glm::vec3 d = glm::normalize(glm::vec3(0.3f, 0.5f, -0.8f));
  const double expected = 2 * CrossedVoxel::kRadius_mm * CrossedVoxel::kDensity * std::sqrt(1 - d.y * d.y);
  EXPECT_NEAR(voxel.extinction(0, d), expected, 0.01 * expected);
}

TEST(Looks, FindAsManyFibresInStretchedCloth) {
  // Stretched by two along the warp, the same fibres fill twice the room with twice the length: the same density of
  // length, so a ray across meets as many a millimetre as before. The weft keeps its length and is spread over twice
  // the room.
  CrossedVoxel voxel;
  const glm::vec3 down(0, 0, -1);
  const glm::mat3 stretched({1, 0, 0}, {0, 2, 0}, {0, 0, 1});
  EXPECT_NEAR(voxel.extinction(0, down, stretched) / voxel.extinction(0, down), 1.0, 1e-4);
  EXPECT_NEAR(voxel.extinction(1, down, stretched) / voxel.extinction(1, down), 0.5, 1e-4);
}

}  // namespace
}  // namespace loomlight
