#include <gtest/gtest.h>

#include <cmath>

#include "render/optics/bcsdf.h"
#include "tests/statistical/chi_square.h"

namespace loomlight {
namespace {

using namespace test;

glm::vec3 direction(double theta_deg, double phi) {
  const double t = theta_deg * kPi / 180;
  return glm::vec3(std::sin(t), std::cos(t) * std::cos(phi), std::cos(t) * std::sin(phi));
}

struct Case {
  double along, about, index, tilt_deg;
  FibreSection section = FibreSection::round;
};

TEST(FibreBcsdf, SamplesFollowTheirDensity) {
  const Case cases[] = {
      {0.05, 0.05, 1.55, 0}, {0.05, 0.3, 1.35, 3},  {0.1, 0.1, 1.55, 0},
      {0.3, 0.3, 1.55, 0},   {0.3, 0.05, 1.7, -10}, {0.3, 0.3, 1.55, 0, FibreSection::kidney},
      {0.6, 0.3, 1.35, 2},   {1.0, 1.0, 1.55, 0},   {1.0, 0.1, 3.0, 10, FibreSection::trilobal},
  };
  const double thetas[] = {0, 50, -85};
  const float offsets[] = {0.1f, -0.8f, 1.0f};
  const int runs = static_cast<int>(std::size(cases) * std::size(thetas));
  uint64_t seed = 0;
  for (const Case& c : cases) {
    Fibre fibre;
    fibre.longitudinalRoughness = c.along;
    fibre.azimuthalRoughness = c.about;
    fibre.refractiveIndex = c.index;
    fibre.scaleTilt_deg = c.tilt_deg;
    fibre.section = c.section;
    const FibreBcsdf bcsdf(fibre);
    for (const double theta : thetas) {
      const glm::vec3 wo = direction(theta, 0.4);
      const float h = offsets[seed % 3];
      ChiSquareSettings settings;
      settings.axis = {1, 0, 0};  // lobes are rings about the fibre
      settings.seed = ++seed;
      settings.quadrature = std::min(c.along, c.about) < 0.2 ? 6 : 2;
      const ChiSquare test = chiSquareOnSphere([&](Random& random) { return bcsdf.sample(wo, h, random).wi; },
                                               [&](glm::vec3 wi) { return bcsdf.evaluate(wo, wi, h).sum(); }, settings);
      EXPECT_TRUE(fits(test, runs)) << "case " << (seed - 1) / 3 << ", theta " << theta << ", h " << h;
      EXPECT_NEAR(test.integral, 1, 1e-3);
    }
  }
}

TEST(FibreBcsdf, OrdersFollowTheSharesAndTheResidualIsGeometric) {
  const FibreBcsdf bcsdf((Fibre()));
  const struct {
    double theta_deg;
    float h;
  } cases[] = {{0, 0.3f}, {60, 0.95f}, {80, -0.5f}, {88, 0.9f}};
  for (const auto& c : cases) {
    const glm::vec3 wo = direction(c.theta_deg, 1);
    const FibreBcsdf::Modes modes = bcsdf.modes(wo, c.h);
    constexpr int kSamples = 100000, kOrders = 40;
    std::vector<double> expected(modes.share.begin(), modes.share.begin() + 3), counts(kOrders + 1);
    double residual = modes.share[3];
    for (; expected.size() < kOrders; residual *= modes.internalReflectance)
      expected.push_back(residual * (1 - modes.internalReflectance));
    expected.push_back(residual);
    for (double& e : expected) e *= kSamples;
    Random random(11);
    for (int k = 0; k < kSamples; ++k)
      counts[static_cast<size_t>(std::min(bcsdf.sample(wo, c.h, random).order, kOrders))] += 1;
    EXPECT_TRUE(fits(chiSquare(counts, expected), static_cast<int>(std::size(cases)))) << c.theta_deg << " " << c.h;
  }
}

TEST(FibreBcsdf, WhiteFurnaceByUniformDirections) {
  // Not the sampler's own directions, whose weight is one whatever they are.
  for (const double theta : {20.0, 80.0}) {
    const FibreBcsdf bcsdf((Fibre()));
    Random random(17);
    constexpr int kSamples = 1000000;
    double sum = 0, squares = 0;
    for (int k = 0; k < kSamples; ++k) {
      const double x = 2 * random.uniformDouble() - 1, phi = 2 * kPi * random.uniformDouble(), r = std::sqrt(1 - x * x);
      const glm::vec3 wi(x, r * std::cos(phi), r * std::sin(phi));
      const double value = 4 * kPi * bcsdf.evaluate(direction(theta, 0), wi, 2 * random.uniform() - 1).sum();
      sum += value;
      squares += value * value;
    }
    const double mean = sum / kSamples, deviation = std::sqrt((squares / kSamples - mean * mean) / kSamples);
    EXPECT_NEAR(mean, 1, 4 * deviation);
    EXPECT_LT(deviation, 8e-3);
  }
}

}  // namespace
}  // namespace loomlight
