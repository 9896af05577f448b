#include <gtest/gtest.h>

#include <cmath>

#include "core/volume/pool/tangent_spread.h"
#include "render/media/fibre_tangent.h"
#include "render/media/volume_medium.h"
#include "tests/statistical/chi_square.h"
#include "tests/support/sampled_mean.h"
#include "tests/support/test_cloth.h"
#include "tests/support/voxel_walk.h"

namespace loomlight {
namespace {

Vec3Of<float> numbersOf(glm::vec3 v) {
  return {v.x, v.y, v.z};
}
glm::vec3 vectorOf(const Vec3Of<float>& v) {
  return {v.x, v.y, v.z};
}

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
      RandomLanes<float> numbers(random);
      return vectorOf(anyTangent<float>(numbersOf(fibres.direction), fibres.spread, numbers));
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
      const auto sampler = [&](Random& random) {
        RandomLanes<float> numbers(random);
        return vectorOf(projectedTangent<float>(numbersOf(m), fibres.spread, numbersOf(ray), numbers));
      };
      const auto result = test::chiSquareOnSphere(sampler, pdf, settings);
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
    test::VoxelWalk walk(*scene->cloth, from, direction, 1000);
    while (walk.next()) {
      const double before = depths.empty() ? 0 : depths.back();
      ends.push_back(walk.leave());
      depths.push_back(before + test::sumExtinction(scene->cloth->yarns, walk.content(), walk.drape(), direction) *
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
    MediumPath path = medium.path();
    for (int i = 0; i < kFlights; ++i) {
      path.begin(from);
      const auto collision = path.collide(direction, random, costs);
      const auto end = collision ? std::lower_bound(ends.begin(), ends.end(), collision->distance_mm) : ends.end();
      counts[static_cast<size_t>(end - ends.begin())] += 1;
    }
    EXPECT_TRUE(fits(test::chiSquare(counts, expected), 2));
  }
}

/// How fibres are met: of which yarn, and how they lie to the ray.
struct HowMet {
  test::SampledMean ofWarp, sineSquare;
  void add(System system, glm::vec3 tangent, glm::vec3 direction) {
    const double cosine = glm::dot(tangent, direction);
    ofWarp.add(system == System::warp ? 1 : 0);
    sineSquare.add(1 - cosine * cosine);
  }
};

// Where a voxel holds several components, those that the medium meets have the same means as those that
// chooseComponent() of the tests draws anew in the same voxel. Rays run low over the weft, so the two laws differ.
TEST(Meetings, AreWithTheFibresOfTheirLaw) {
  constexpr int kFlights = 60000;
  Fabric fabric = test::whiteCotton();
  fabric.render.resolution = 2;
  const auto scene = test::sceneOf(fabric);
  const TraceData& cloth = *scene->cloth;
  const glm::vec3 direction = glm::normalize(glm::vec3(1, 0.15f, -0.35f));
  double warp[2] = {0, 0};
  for (const EventLaw law : {EventLaw::projected, EventLaw::report}) {
    const VolumeMedium medium(scene->cloth, law);
    MediumPath path = medium.path();
    Random random(31);
    RandomLanes<float> numbers(random);
    TraceCounts counts;
    HowMet met, expected;
    for (int i = 0; i < kFlights; ++i) {
      const float u = random.uniform(), v = random.uniform();
      path.begin({glm::vec3(u, v, 0.5f) - 3.0f * direction, -1});
      const auto collision = path.collide(direction, random, counts);
      if (!collision) continue;
      VoxelContent content;
      cloth.volume->contentAt(cloth.shell->toCloth(collision->place.tet, collision->place.world), content);
      if (content.count == 0 || !test::hasSeveralComponents(content)) continue;  // or at its very edge
      met.add(collision->yarnId.system, collision->tangent, direction);
      const test::VoxelFibres anew = test::chooseComponent(cloth.yarns, content, {}, direction, random.uniform(), law);
      const Vec3Of<float> mean = numbersOf(anew.fibres.direction);
      const auto tangent = law == EventLaw::report
                               ? anyTangent<float>(mean, anew.fibres.spread, numbers)
                               : projectedTangent<float>(mean, anew.fibres.spread, numbersOf(direction), numbers);
      expected.add(anew.span->system, vectorOf(tangent), direction);
    }
    ASSERT_GT(met.ofWarp.count(), 2000u);
    const auto agree = [](const test::SampledMean& a, const test::SampledMean& b) {
      return test::isWithinNoise(a.mean(), b.mean(), std::hypot(a.standardError(), b.standardError()), 4);
    };
    EXPECT_TRUE(agree(met.ofWarp, expected.ofWarp));
    EXPECT_TRUE(agree(met.sineSquare, expected.sineSquare));
    warp[static_cast<int>(law)] = met.ofWarp.mean();
  }
  EXPECT_GT(warp[0], warp[1] + 0.05) << "the warp is seen side-on, the weft nearly end-on";
}

}  // namespace
}  // namespace loomlight
