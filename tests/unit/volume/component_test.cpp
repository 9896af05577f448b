#include "core/volume/pool/component.h"

#include <gtest/gtest.h>

#include "core/base/random.h"
#include "tests/support/any_direction.h"

namespace loomlight {
namespace {

Component ofDirection(glm::vec3 m) {
  return Component::encode({.direction = m, .lengthDensity = 1});
}

double sineBetween(glm::vec3 a, glm::vec3 b) {
  return glm::length(glm::cross(glm::dvec3(a), glm::dvec3(b)));
}

TEST(Component, DirectionIsWithinItsGrid) {
  // Half a step in both coordinates moves a point by sqrt(2) / 4094 within a face of the octahedron, which is no nearer
  // to its centre than 1 / sqrt(3).
  const double kHalfDiagonal = std::sqrt(2.0 * 3.0) / 4094;
  Random random(1);
  for (int i = 0; i < 200000; ++i) {
    const glm::vec3 m = test::anyDirection(random), back = ofDirection(m).decode().direction;
    ASSERT_NEAR(glm::length(back), 1, 1e-6);
    ASSERT_LT(sineBetween(m, back), kHalfDiagonal) << m.x << " " << m.y << " " << m.z;
  }
}

TEST(Component, ALineHasOneCode) {
  Random random(2);
  for (int i = 0; i < 100000; ++i) {
    glm::vec3 m = test::anyDirection(random);
    if (i % 3 == 0) m = glm::normalize(glm::vec3(m.x, m.y, 0));
    if (i % 7 == 0) m = glm::normalize(glm::vec3(m.x, m.y, 1e-5f * m.z));
    const Component code = ofDirection(m);
    ASSERT_EQ(code, ofDirection(-m));
    // What was decoded encodes to itself, so copying through files or merges does not drift.
    ASSERT_EQ(code, ofDirection(code.decode().direction));
  }
}

TEST(Component, AxesAreExact) {
  for (int axis = 0; axis < 3; ++axis) {
    glm::vec3 m(0);
    m[axis] = -1;
    EXPECT_EQ(glm::abs(ofDirection(m).decode().direction), -m);
  }
}

TEST(Component, LengthDensityIsWithinAQuarterOfAThousandth) {
  Random random(3);
  for (int i = 0; i < 200000; ++i) {
    const float density = std::exp2(-11.99f + 31.98f * random.uniform());
    const Component c = Component::encode({.lengthDensity = density});
    ASSERT_NEAR(c.lengthDensity() / density, 1, 2.5e-4) << density;
    ASSERT_EQ(c.lengthDensity(), c.decode().lengthDensity);
  }
}

TEST(Component, LengthDensityIsMonotoneAndCoversItsRange) {
  float before = -1;
  for (float density = 1e-6f; density < 1e8f; density *= 1.0002f) {
    const float now = Component::encode({.lengthDensity = density}).lengthDensity();
    ASSERT_GE(now, before);
    before = now;
  }
  EXPECT_EQ(Component::encode({.lengthDensity = 0}).lengthDensity(), 0);
  EXPECT_EQ(Component::encode({.lengthDensity = 1e-5f}).lengthDensity(), 0);
  EXPECT_NEAR(Component::encode({.lengthDensity = 2.5e-4f}).lengthDensity(), 2.5e-4, 1e-6);
  EXPECT_NEAR(before, 0x1p20, 1e3) << "beyond the range: the largest";
}

TEST(Component, SpreadIsKept) {
  for (int i = 0; i <= 1000; ++i) {
    const float x = static_cast<float>(i) / 1000;
    const FibreDistribution d = Component::encode({.spread = x, .lengthDensity = 5}).decode();
    // The step of the square root is 1/255.
    EXPECT_NEAR(d.spread, x, std::sqrt(x) / 255 + 1e-5);
  }
  EXPECT_EQ(Component::encode({.spread = 0}).decode().spread, 0);
  EXPECT_EQ(Component::encode({.spread = 1}).decode().spread, 1);
}

}  // namespace
}  // namespace loomlight
