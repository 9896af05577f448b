#include <gtest/gtest.h>

#include <cmath>

#include "core/volume/pool/tangent_spread.h"
#include "render/media/cloth_walk.h"
#include "render/media/fibre_tangent.h"
#include "render/media/volume_medium.h"
#include "render/media/voxel_extinction.h"
#include "tests/statistical/chi_square.h"
#include "tests/support/test_cloth.h"

namespace loomlight {
namespace {

/// Density per solid angle of the Gaussian about a mean, for s so small that no tangent turns beyond a right angle.
double gaussian(const FibreDistribution& fibres, glm::vec3 t) {
  const double theta = std::acos(std::clamp(static_cast<double>(glm::dot(t, fibres.direction)), -1.0, 1.0));
  const double s2 = static_cast<double>(fibres.spread) * fibres.spread;
  return std::exp(-0.5 * theta * theta / s2) / (2 * kPi * s2) * (theta > 1e-6 ? theta / std::sin(theta) : 1.0);
}

const FibreDistribution kFibres[] = {
    {.direction = {0, 0, 1}, .spread = 0.1f},
    {.direction = glm::normalize(glm::vec3(1, 2, -3)), .spread = 0.25f},
    {.direction = glm::normalize(glm::vec3(-1, 0.2f, 0.1f)), .spread = 0.4f},
};

TEST(Tangents, FitTheirGaussian) {
  for (const FibreDistribution& fibres : kFibres) {
    test::ChiSquareSettings settings;
    settings.axis = fibres.direction;
    const auto sampler = [&](Random& random) {
      const float u1 = random.uniform(), u2 = random.uniform();
      return sampleTangent(fibres, u1, u2);
    };
    const auto result = test::chiSquareOnSphere(sampler, [&](glm::vec3 t) { return gaussian(fibres, t); }, settings);
    EXPECT_TRUE(fits(result, std::size(kFibres))) << "spread " << fibres.spread;
  }
}

// The fibres that a ray meets are those it sees: the Gaussian weighted by the sine of the angle to the ray, and
// normalised by the table that extinction is looked up in.
TEST(Tangents, OfFibresThatARayMeetsAreWeightedByTheSine) {
  const double alphas[] = {0.0, 0.2, 1.3};
  const int runs = static_cast<int>(std::size(kFibres) * std::size(alphas));
  for (const FibreDistribution& fibres : kFibres)
    for (const double alpha : alphas) {
      const glm::vec3 m = fibres.direction;
      const glm::vec3 side = glm::normalize(glm::cross(m, glm::vec3(0.3f, 1, 0)));
      const glm::vec3 ray = static_cast<float>(std::cos(alpha)) * m + static_cast<float>(std::sin(alpha)) * side;
      const double seen = TangentSpread::projectedLengthExact(alpha, fibres.spread);
      test::ChiSquareSettings settings;
      settings.axis = m;
      settings.seed = static_cast<uint64_t>(alpha * 10) + 3;
      settings.quadrature = 4;  // at alpha = 0 the density has a cone's tip
      const auto pdf = [&](glm::vec3 t) {
        return gaussian(fibres, t) * glm::length(glm::cross(glm::dvec3(t), glm::dvec3(ray))) / seen;
      };
      const auto result =
          test::chiSquareOnSphere([&](Random& random) { return projectedTangent(fibres, ray, random); }, pdf, settings);
      EXPECT_TRUE(fits(result, runs)) << "spread " << fibres.spread << ", alpha " << alpha;
      EXPECT_NEAR(result.integral, 1, 2e-3);
    }
}

// A flight ends in a voxel with the chance that the extinction on its way says: exp(-depth before) - exp(-depth after).
TEST(FreeFlights, FitTheExtinctionOfTheirWay) {
  for (const DrapeKind drape : {DrapeKind::flat, DrapeKind::cylinder}) {
    Fabric fabric = test::whiteCotton();
    fabric.drape.kind = drape;
    const auto scene = test::sceneOf(fabric);
    const VolumeMedium medium(scene->cloth);
    const glm::vec3 direction = glm::normalize(glm::vec3(0.6f, 0.5f, -1));
    const ScenePoint from{glm::vec3(0.03f, 0.02f, 0) - 20.0f * direction, -1};

    // Optical depth at the end of every voxel on the way.
    std::vector<double> ends, depths;
    ClothWalk walk(*scene->cloth, from, direction, 1000);
    while (walk.next()) {
      const double before = depths.empty() ? 0 : depths.back();
      ends.push_back(walk.leave());
      depths.push_back(before + sumExtinction(scene->cloth->yarns, walk.content(), walk.drape(), direction) *
                                    (walk.leave() - walk.enter()));
    }
    ASSERT_GT(depths.size(), 10u);

    constexpr int kFlights = 100000;
    std::vector<double> expected, counts(depths.size() + 1);
    double before = 0;
    for (const double depth : depths) {
      expected.push_back(kFlights * (std::exp(-before) - std::exp(-depth)));
      before = depth;
    }
    expected.push_back(kFlights * std::exp(-before));  // through
    Random random(29);
    TraceCounts costs;
    for (int i = 0; i < kFlights; ++i) {
      VolumeMedium::Memory none;
      const auto collision = medium.collide(from, none, direction, random, costs);
      const auto end = collision ? std::lower_bound(ends.begin(), ends.end(), collision->distance_mm) : ends.end();
      counts[static_cast<size_t>(end - ends.begin())] += 1;
    }
    EXPECT_TRUE(fits(test::chiSquare(counts, expected), 2));
  }
}

}  // namespace
}  // namespace loomlight
