#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>

#include "render/optics/bcsdf.h"
#include "render/optics/dielectric_cylinder.h"

namespace loomlight {
namespace {

glm::vec3 directionAt(double theta_deg, double phi) {
  const double t = theta_deg * kPi / 180;
  return glm::vec3(std::sin(t), std::cos(t) * std::cos(phi), std::cos(t) * std::sin(phi));
}

FibreBcsdf clearFibre(double index = 1.55) {
  Fibre fibre;
  fibre.refractiveIndex = index;
  return FibreBcsdf(fibre);
}

/// Mean over the offset h in [-1, 1], by the midpoint rule in its arcsine.
template <class Function>
double meanOverOffset(Function&& f) {
  constexpr int kPoints = 400;
  double sum = 0;
  for (int k = 0; k < kPoints; ++k) {
    const double gamma = kPi * ((k + 0.5) / kPoints - 0.5);
    sum += f(static_cast<float>(std::sin(gamma))) * std::cos(gamma) * 0.5 * kPi / kPoints;
  }
  return sum;
}

/// Geometrical optics of a smooth cylinder in three dimensions, vector by vector: knows nothing of the Bravais index.
struct TracedCylinder {
  std::array<glm::dvec3, 3> leaving;  ///< directionAt after R, TT, TRT
  std::array<double, 3> share;
  double chord_radii = 0;

  TracedCylinder(glm::dvec3 wo, double h, double index) {
    const double azimuth = std::atan2(wo.z, wo.y) - std::asin(h);
    const glm::dvec3 normal(0, std::cos(azimuth), std::sin(azimuth));
    const glm::dvec3 along = -wo;
    const double cosine = glm::dot(wo, normal);
    leaving[0] = glm::reflect(along, normal);
    const glm::dvec3 inside = glm::refract(along, normal, 1 / index);
    const double f = reflectance(cosine, -glm::dot(inside, normal), index);
    const glm::dvec3 second = next(normal, inside);
    leaving[1] = glm::refract(inside, -second, index);
    const glm::dvec3 bounced = glm::reflect(inside, -second);
    leaving[2] = glm::refract(bounced, -next(second, bounced), index);
    share = {f, (1 - f) * (1 - f), (1 - f) * (1 - f) * f};
  }

 private:
  /// Where a ray from one point of the unit cylinder meets it again: the point is also the outward normal there.
  glm::dvec3 next(glm::dvec3 point, glm::dvec3 d) {
    const double across2 = d.y * d.y + d.z * d.z;
    chord_radii = -2 * (point.y * d.y + point.z * d.z) / across2;
    const glm::dvec3 met = point + chord_radii * d;
    return {0, met.y, met.z};
  }
  static double reflectance(double outer, double inner, double index) {
    const double s = (outer - index * inner) / (outer + index * inner);
    const double p = (index * outer - inner) / (index * outer + inner);
    return 0.5 * (s * s + p * p);
  }
};

TEST(DielectricCylinder, AgreesWithTracingRaysThroughIt) {
  for (const double index : {1.05, 1.35, 1.55, 2.5}) {
    for (const double theta : {-80.0, -30.0, 0.0, 45.0, 75.0}) {
      for (const double h : {-0.99, -0.6, 0.0, 0.2, 0.9}) {
        const glm::vec3 wo = directionAt(theta, 0.7);
        const TracedCylinder traced(wo, h, index);
        const optics::CylinderHit<float> hit({wo.x, wo.y, wo.z}, static_cast<float>(h), static_cast<float>(index));
        EXPECT_NEAR(hit.chord_radii / traced.chord_radii, 1, 1e-5);
        for (size_t mode = 0; mode < 3; ++mode) {
          EXPECT_NEAR(hit.share[mode], traced.share[mode], 1e-5);
          EXPECT_NEAR(traced.leaving[mode].x, -wo.x, 1e-6);
          const std::complex<double> out(wo.y, wo.z), in(traced.leaving[mode].y, traced.leaving[mode].z);
          const std::complex<double> turn = in / out / std::abs(in / out);
          EXPECT_NEAR(turn.real(), hit.turnCosine[mode], 2e-5) << index << " " << theta << " " << h << " " << mode;
          EXPECT_NEAR(-turn.imag(), hit.turnSine[mode], 2e-5) << index << " " << theta << " " << h << " " << mode;
        }
      }
    }
  }
}

TEST(DielectricCylinder, FresnelAtNormalIncidenceAndAtBrewstersAngle) {
  const float n = 1.5f;
  EXPECT_NEAR(optics::fresnel<float>(1, n, n), 0.04, 1e-7);
  const float cosine = 1 / std::sqrt(1 + n * n);  // there the reflection is all s-polarised: ((n^2 - 1) / (n^2 + 1))^2
  const float s = (n * n - 1) / (n * n + 1);
  EXPECT_NEAR(optics::fresnel<float>(cosine, std::sqrt(n * n - 1 + cosine * cosine), n), 0.5f * s * s, 1e-6);
  EXPECT_EQ(optics::fresnel<float>(0, 1, n), 1.0f);
}

TEST(FibreBcsdf, SharesOfASmoothFibreAreThoseOfABruteForceTrace) {
  const FibreBcsdf fibre = clearFibre();
  // Index 1.55, mean over h: R, TT, TRT, rest by tracing rays (two independent programs, agreeing to 5e-4).
  const struct {
    double theta_deg;
    std::array<double, 4> share;
  } references[] = {
      {0, {0.0749, 0.8618, 0.0557, 0.0076}}, {45, {0.110, 0.803, 0.074, 0.014}}, {75, {0.360, 0.425, 0.137, 0.078}}};
  for (const auto& reference : references) {
    for (size_t mode = 0; mode < 4; ++mode) {
      const double share =
          meanOverOffset([&](float h) { return fibre.modes(directionAt(reference.theta_deg, 1), h).share[mode]; });
      EXPECT_NEAR(share, reference.share[mode], 1e-3) << reference.theta_deg << " mode " << mode;
    }
  }
}

TEST(FibreBcsdf, AlbedoFollowsFromTheLengthsInside) {
  const FibreBcsdf fibre = clearFibre();
  // Absorption times radius, and the albedo of one fibre seen at a right angle, by tracing rays.
  const double references[][2] = {{0.01, 0.9817}, {0.1, 0.8334}, {1, 0.2113}, {1e4, 0.0749}};
  for (const auto& [absorption, albedo] : references) {
    const double sigma = absorption;
    const double mean = meanOverOffset([&](float h) {
      const FibreBcsdf::Modes m = fibre.modes(directionAt(0, 0), h);
      const double t = std::exp(-sigma * m.chord_radii);
      return m.share[0] + m.share[1] * t + m.share[2] * t * t +
             m.share[3] * (1 - m.internalReflectance) * t * t * t / (1 - m.internalReflectance * t);
    });
    EXPECT_NEAR(mean, albedo, 5e-4) << sigma;
  }
}

TEST(FibreBcsdf, SharesAddUpToOne) {
  for (const double index : {1.01, 1.55, 3.0}) {
    const FibreBcsdf fibre = clearFibre(index);
    for (const double theta : {0.0, 60.0, 89.9, 90.0}) {
      for (const float h : {-1.0f, -0.5f, 0.0f, 0.99f, 1.0f}) {
        const FibreBcsdf::Modes m = fibre.modes(directionAt(theta, 2), h);
        EXPECT_NEAR(m.share[0] + m.share[1] + m.share[2] + m.share[3], 1, 1e-6);
        for (const float share : m.share) EXPECT_GE(share, 0);
      }
    }
  }
}

}  // namespace
}  // namespace loomlight
