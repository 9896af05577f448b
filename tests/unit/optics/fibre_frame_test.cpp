#include "render/optics/fibre_frame.h"

#include <gtest/gtest.h>

#include "core/base/random.h"

namespace loomlight {
namespace {

/// Orthonormal and right-handed to rounding, and goes there and back.
void expectFrame(glm::vec3 tangent) {
  const FibreFrame frame(tangent);
  constexpr float kRounding = 1e-6f;
  EXPECT_EQ(frame.x, tangent);
  EXPECT_NEAR(glm::length(frame.y), 1, kRounding);
  EXPECT_NEAR(glm::length(frame.z), 1, kRounding);
  EXPECT_NEAR(glm::distance(glm::cross(frame.y, frame.z), tangent), 0, kRounding);
  const glm::vec3 v(0.3f, -0.5f, 0.8f);
  EXPECT_NEAR(glm::distance(frame.toWorld(frame.toLocal(v)), v), 0, 2 * kRounding);
}

TEST(FibreFrame, IsOrthonormalForAnyTangent) {
  Random random(5);
  for (int i = 0; i < 2000; ++i) {
    const float z = 2 * random.uniform() - 1, azimuth = 6.2831853f * random.uniform(), r = std::sqrt(1 - z * z);
    expectFrame({r * std::cos(azimuth), r * std::sin(azimuth), z});
  }
}

TEST(FibreFrame, IsOrthonormalAlongTheAxesAndBesideThem) {
  for (int axis = 0; axis < 3; ++axis)
    for (const float side : {-1.0f, 1.0f})
      for (const float beside : {0.0f, -0.0f, 1e-7f, -1e-4f, 1e-3f}) {
        glm::vec3 tangent(beside);
        tangent[axis] = side;
        expectFrame(glm::normalize(tangent));
      }
}

}  // namespace
}  // namespace loomlight
