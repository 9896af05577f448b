#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/volume/pool/tangent_spread.h"
#include "tests/support/sample_tangent.h"

namespace loomlight {
namespace {

struct Estimate {
  double mean, error;  ///< standard error of the mean
};

/// The table-free reference: collisions with the majorant 2 r lambda, accepted with |sin angle(d, t)|. What share is
/// real is I(alpha, s), with no table and no quadrature.
Estimate acceptedShare(const FibreDistribution& fibres, glm::vec3 d, int trials, Random& random) {
  int accepted = 0;
  for (int i = 0; i < trials; ++i) {
    const float u1 = random.uniform(), u2 = random.uniform(), u3 = random.uniform();
    accepted += u3 < glm::length(glm::cross(test::sampleTangent(fibres, u1, u2), d));
  }
  const double share = static_cast<double>(accepted) / trials;
  return {share, std::sqrt(std::max(share * (1 - share), 1.0 / trials) / trials)};
}

TEST(TableFree, AcceptsAtTheRateOfTheTable) {
  Random random(41);
  for (const float s : {0.0f, 0.03f, 0.1f, 0.3f, 0.6f, 1.0f})
    for (const float alpha : {0.0f, 0.02f, 0.1f, 0.3f, 0.8f, 1.2f, 1.5707f}) {
      // About a mean that is no axis, seen in a direction at angle alpha from it.
      const glm::vec3 m = glm::normalize(glm::vec3(0.3f, -0.5f, 0.7f));
      const glm::vec3 side = glm::normalize(glm::cross(m, glm::vec3(1, 0, 0)));
      const glm::vec3 d = std::cos(alpha) * m + std::sin(alpha) * side;
      const auto [share, error] = acceptedShare({.direction = m, .spread = s}, d, 400000, random);
      const double table = TangentSpread::table().projectedLength(std::sin(alpha), s);
      EXPECT_NEAR(share, table, 4 * error + 2e-3 * table) << "s " << s << " alpha " << alpha;
    }
}

/// A free flight by delta tracking through one voxel's fibres, against the exponential of the tabulated extinction.
TEST(TableFree, TransmitsAsTheTableDoes) {
  Random random(43);
  const float radius = 0.006f, length = 0.4f;
  const FibreDistribution fibres{.direction = {0, 1, 0}, .spread = 0.25f, .lengthDensity = 600};
  const float majorant = 2 * radius * fibres.lengthDensity;
  for (const float alpha : {0.05f, 0.4f, 1.4f}) {
    const glm::vec3 d(0, std::cos(alpha), std::sin(alpha));
    const int flights = 200000;
    int through = 0;
    for (int i = 0; i < flights; ++i) {
      float t = 0;
      for (;;) {
        t -= std::log1p(-random.uniform()) / majorant;
        if (t >= length) {
          ++through;
          break;
        }
        const float u1 = random.uniform(), u2 = random.uniform(), u3 = random.uniform();
        if (u3 < glm::length(glm::cross(test::sampleTangent(fibres, u1, u2), d))) break;
      }
    }
    const double sigma = majorant * TangentSpread::table().projectedLength(std::sin(alpha), fibres.spread);
    const double expected = std::exp(-sigma * length);
    const double error = std::sqrt(expected * (1 - expected) / flights);
    EXPECT_NEAR(static_cast<double>(through) / flights, expected, 4 * error + 2e-3 * sigma * length * expected)
        << alpha;
  }
}

TEST(TableFree, TangentsHaveTheirMeanAndSpread) {
  Random random(47);
  for (const glm::vec3 m : {glm::vec3(0, 0, 1), glm::vec3(0, 0, -1), glm::normalize(glm::vec3(1, 2, -3))}) {
    const FibreDistribution fibres{.direction = m, .spread = 0.2f};
    const int n = 200000;
    double square = 0;
    glm::dvec3 sum(0);
    for (int i = 0; i < n; ++i) {
      const float u1 = random.uniform(), u2 = random.uniform();
      const glm::vec3 t = test::sampleTangent(fibres, u1, u2);
      ASSERT_NEAR(glm::length(t), 1, 1e-5);
      const double c = glm::dot(t, m);
      square += 1 - c * c;
      sum += glm::dvec3(t);
    }
    EXPECT_NEAR(square / n, TangentSpread::meanSquareSine(0.2), 5e-4);
    EXPECT_LT(glm::length(glm::cross(sum / static_cast<double>(n), glm::dvec3(m))), 2.5e-3);
  }
}

}  // namespace
}  // namespace loomlight
