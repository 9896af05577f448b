#include "core/volume/pool/voxel_box.h"

#include <gtest/gtest.h>

#include <set>

#include "core/base/random.h"

namespace loomlight {
namespace {

constexpr int kParts = VoxelBox::kParts;

Float32x4 lanes(glm::vec3 v) {
  return Float32x4{v.x, v.y, v.z, 0};
}

VoxelBox ofSevenths(glm::ivec3 lower, glm::ivec3 upper) {
  return VoxelBox::nearest(lanes(glm::vec3(lower) / 7.0f), lanes(glm::vec3(upper) / 7.0f));
}

TEST(VoxelBox, IsTheWholeVoxelIfNothingIsSaid) {
  EXPECT_EQ(VoxelBox().lower(), glm::ivec3(0));
  EXPECT_EQ(VoxelBox().upper(), glm::ivec3(kParts));
  EXPECT_EQ(VoxelBox().lowerCorner(), glm::vec3(0));
  EXPECT_EQ(VoxelBox().upperCorner(), glm::vec3(1));  // to the bit: walks clip at the very face of the voxel
  EXPECT_EQ(VoxelBox().crowding(), 1);
}

TEST(VoxelBox, OfSeventhsIsKeptExactly) {
  std::set<uint16_t> codes;
  int boxes = 0;
  for (int axis = 0; axis < 3; ++axis)
    for (int from = 0; from < kParts; ++from)
      for (int to = from + 1; to <= kParts; ++to) {
        glm::ivec3 lower(1, 2, 3), upper(2, 7, 5);
        lower[axis] = from;
        upper[axis] = to;
        const VoxelBox box = ofSevenths(lower, upper);
        EXPECT_EQ(box.lower(), lower);
        EXPECT_EQ(box.upper(), upper);
        EXPECT_EQ(box, VoxelBox::of(box.code()));
        const glm::vec3 size = glm::vec3(upper - lower) / 7.0f;
        EXPECT_NEAR(box.crowding() * size.x * size.y * size.z, 1, 1e-5);
        codes.insert(box.code());
        ++boxes;
      }
  EXPECT_EQ(codes.size(), static_cast<size_t>(boxes - 2));  // the box that all three axes begin with is counted thrice
}

TEST(VoxelBox, IsTheNearestAndNeverEmpty) {
  Random random(3);
  for (int i = 0; i < 20000; ++i) {
    glm::vec3 lower, upper;
    for (int axis = 0; axis < 3; ++axis) {
      const float a = 1.2f * random.uniform() - 0.1f, b = a + random.uniform() * random.uniform();
      lower[axis] = a;
      upper[axis] = b;
    }
    const VoxelBox box = VoxelBox::nearest(lanes(lower), lanes(upper));
    for (int axis = 0; axis < 3; ++axis) {
      ASSERT_LT(box.lower()[axis], box.upper()[axis]);
      const float from = std::clamp(lower[axis], 0.0f, 1.0f), to = std::clamp(upper[axis], 0.0f, 1.0f);
      if (to - from > 1.0f / kParts) {
        ASSERT_NEAR(box.lowerCorner()[axis], from, 0.5 / kParts + 1e-6);
        ASSERT_NEAR(box.upperCorner()[axis], to, 0.5 / kParts + 1e-6);
      } else {  // its middle is inside
        ASSERT_LE(box.lowerCorner()[axis], 0.5f * (from + to) + 1e-6f);
        ASSERT_GE(box.upperCorner()[axis], 0.5f * (from + to) - 1e-6f);
      }
    }
  }
}

TEST(VoxelBox, AroundTwoHoldsBoth) {
  const VoxelBox both = around(ofSevenths({0, 3, 5}, {2, 4, 7}), ofSevenths({1, 1, 6}, {5, 2, 7}));
  EXPECT_EQ(both.lower(), glm::ivec3(0, 1, 5));
  EXPECT_EQ(both.upper(), glm::ivec3(5, 4, 7));
}

}  // namespace
}  // namespace loomlight
