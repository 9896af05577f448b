#include "render/bvdf/bvdf.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/random.h"
#include "core/base/units.h"
#include "render/bvdf/bvdf_counts.h"
#include "render/bvdf/bvdf_picture.h"
#include "tests/support/any_direction.h"

namespace loomlight {
namespace {

constexpr BvdfResolution kSmall{4, 4, 8, 8};

Bvdf randomTable(uint64_t seed) {
  Random random(seed);
  std::vector<float> ratios(kSmall.bins());
  for (float& ratio : ratios) ratio = 3 * random.uniform();
  return Bvdf(kSmall, {1.5f, 0.4f}, std::move(ratios));
}

TEST(Bvdf, IsAProbabilityInAllDirections) {
  const Bvdf table = randomTable(1);
  Random random(2);
  for (int i = 0; i < 10000; ++i) {
    const float p = table.occlusion(test::anyDirection(random), test::anyDirection(random));
    ASSERT_GE(p, 0.0f);
    ASSERT_LE(p, 1.0f);
  }
}

TEST(Bvdf, NothingShadowsLightFromTheEye) {
  const Bvdf table = randomTable(3);
  Random random(4);
  for (int i = 0; i < 1000; ++i) {
    const glm::vec3 w = test::anyDirection(random);
    EXPECT_EQ(table.occlusion(w, w), 0.0f);
  }
}

// A fibre has no direction, and a yarn may be turned half about its axis: the frames of t and -t, of n and -n give the
// same p to the same directions of the world.
TEST(Bvdf, SignsOfTangentAndNormalDoNotMatter) {
  const Bvdf table = randomTable(5);
  Random random(6);
  for (int i = 0; i < 1000; ++i) {
    const glm::vec3 n = test::anyDirection(random), t = test::anyDirection(random), wi = test::anyDirection(random),
                    wo = test::anyDirection(random);
    const glm::mat3 frame = eventFrame(n, t);
    const float p = table.occlusion(wi * frame, wo * frame);
    for (const auto& [normal, tangent] : {std::pair{n, -t}, std::pair{-n, t}, std::pair{-n, -t}}) {
      const glm::mat3 other = eventFrame(normal, tangent);
      ASSERT_NEAR(table.occlusion(wi * other, wo * other), p, 2e-4);
    }
  }
}

// Azimuths begin again at phi_i = 0 and, by symmetry, at phi_o = 0 and pi; nothing may be seen of that.
TEST(Bvdf, HasNoSeams) {
  const Bvdf table = randomTable(7);
  Random random(8);
  constexpr float kStep = 1e-3f;
  // Over two steps the place between bins moves by 2 steps / (pi / 4), neighbouring ratios differ by at most 3; the
  // hot-spot law's slope is depth / (2 reach), times a ratio of at most 3.
  constexpr float kBound = 2 * kStep * (3 / 0.785f + 3 * 1.5f / 0.8f);
  const auto at = [](float theta, float phi) {
    return glm::vec3(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
  };
  for (int i = 0; i < 2000; ++i) {
    const float thetaO = 1.5f * random.uniform(), thetaI = 3 * random.uniform(), other = 6 * random.uniform();
    const float seam = i % 2 ? 0.0f : static_cast<float>(kPi);
    ASSERT_NEAR(table.occlusion(at(thetaI, seam - kStep), at(thetaO, other)),
                table.occlusion(at(thetaI, seam + kStep), at(thetaO, other)), kBound);
    ASSERT_NEAR(table.occlusion(at(thetaI, other), at(thetaO, seam - kStep)),
                table.occlusion(at(thetaI, other), at(thetaO, seam + kStep)), kBound);
  }
}

TEST(Bvdf, FramesAreRightHandedAndOrthonormal) {
  Random random(9);
  for (int i = 0; i < 1000; ++i) {
    const glm::vec3 n = test::anyDirection(random);
    const glm::mat3 frame = eventFrame(n, i % 10 ? test::anyDirection(random) : n);  // a fibre that stands up too
    EXPECT_NEAR(glm::determinant(frame), 1.0f, 1e-5);
    EXPECT_NEAR(glm::dot(frame[0], frame[1]), 0.0f, 1e-5);
    EXPECT_EQ(frame[2], n);
  }
}

TEST(HotSpot, GrowsWithTheAngleFromNothing) {
  for (const HotSpot law : {HotSpot{1.5f, 0.4f}, HotSpot{0.2f, 3.0f}, HotSpot{5.0f, 0.05f}}) {
    float last = 0;
    for (int i = 0; i <= 180; ++i) {
      const float angle = static_cast<float>(i * kPi / 180);
      const float p = law.occlusion({std::sin(angle), 0, std::cos(angle)}, {0, 0, 1});
      if (i == 0) {
        EXPECT_EQ(p, 0.0f);
      } else if (i <= 80) {
        EXPECT_GT(p, last);
      } else if (i > 90) {
        EXPECT_NEAR(p, last, 1e-6);
      }
      last = p;
    }
    EXPECT_LT(last, 1.0f);
  }
}

// Whatever was found is found again: rays that are stopped twice as often as the law says give a ratio of two.
TEST(BvdfCounts, GiveBackWhatTheyWereTold) {
  const HotSpot law{0.5f, 0.4f};
  BvdfCounts counts(kSmall);
  Random random(10);
  for (int i = 0; i < 400'000; ++i) {
    const glm::vec3 wi = test::anyDirection(random), wo = test::anyDirection(random);
    const float expected = law.occlusion(wi, wo);
    counts.add(BvdfBin::at(bvdfAngles(wi, wo), kSmall).index(kSmall), random.uniform() < 2 * expected, expected);
  }
  EXPECT_EQ(counts.rays(), 400'000u);
  const Bvdf table = counts.table(law);
  double error = 0;
  for (int i = 0; i < 1000; ++i) {
    const glm::vec3 wi = test::anyDirection(random), wo = test::anyDirection(random);
    const double difference = table.occlusion(wi, wo) - 2 * law.occlusion(wi, wo);
    error += difference * difference / 1000;
  }
  // 400 rays a bin of p (1 - p) <= 1/4 each; the filter and interpolation divide the variance by more than 10.
  EXPECT_LT(std::sqrt(error), std::sqrt(0.25 / 400 / 10));
}

TEST(BvdfCounts, AnEmptyTableIsTheHotSpotLaw) {
  const HotSpot law{1.2f, 0.5f};
  const Bvdf table = BvdfCounts(kSmall).table(law);
  Random random(11);
  for (int i = 0; i < 100; ++i) {
    const glm::vec3 wi = test::anyDirection(random), wo = test::anyDirection(random);
    EXPECT_NEAR(table.occlusion(wi, wo), law.occlusion(wi, wo), 1e-6);
  }
}

TEST(BvdfPicture, IsWhiteWhereEyeAndLightMeet) {
  const BvdfSet set{{randomTable(12), randomTable(13)}, 1, {0, 1}};
  const Pixels8 picture = bvdfPicture(set);
  ASSERT_EQ(picture.bytes.size(), static_cast<size_t>(picture.width) * picture.height * 3);
  // First square of either row: phi_i = phi_o = 0, so white along theta_i = theta_o, half a square in 90 degrees.
  const int row = picture.height / 2;
  for (const int top : {6, row + 3})
    EXPECT_GT(picture.bytes[(static_cast<size_t>(top + 48) * picture.width + 6 + 24) * 3], 240);
  const Image image = bvdfImage(set);
  EXPECT_EQ(image.channels.size(), 2u);
  EXPECT_EQ(static_cast<size_t>(image.width) * image.height, kSmall.bins());
}

}  // namespace
}  // namespace loomlight
