#include "render/light/daylight.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/colour/spectrum.h"
#include "render/light/lat_long.h"

// How it works. Luminance and chromaticity of the sky are Perez functions of the angles to zenith and sun, with the
// coefficients that the paper fits to turbidity. The sun is a black body behind air that absorbs wavelength by
// wavelength. The ground is grey and lit by both.
//
// The model of Hosek and Wilkie (2012) is truer near the horizon and under a low sun. Its coefficients are tables of
// some thousands of fitted numbers that are not in the paper but came as a download; no package of Debian 12 or 13
// holds them, and nothing here is downloaded. Every number of the model here is printed in its paper.

namespace loomlight {
namespace {

/// Radiance of ours for 1 kcd/m2: the exposure and white balance that make white paper under the default sky (1, 1, 1),
/// as a photographer would set them. A test holds them to that.
constexpr Rgb kRadiancePerKcd(1 / 29.617f, 1 / 27.586f, 1 / 29.085f);
constexpr double kGroundAlbedo = 0.2;
constexpr double kTwilight_deg = 6.0;

/// Ozone's absorption, 1/cm, every 20 nm from 380 nm (Preetham 1999, table 2, after Iqbal 1983).
double ozoneAbsorption(double nm) {
  static constexpr std::array<double, 20> k{0,    0,     0,     0.001, 0.006, 0.014, 0.03,  0.048, 0.075, 0.103,
                                            0.12, 0.125, 0.105, 0.079, 0.057, 0.036, 0.023, 0.014, 0.01,  0.008};
  const double x = std::clamp((nm - 380) / 20, 0.0, k.size() - 1.001);
  const auto i = static_cast<size_t>(x);
  return k[i] + (x - static_cast<double>(i)) * (k[i + 1] - k[i]);
}

/// Share of sunlight that the air lets through (Preetham 1999, appendix 1): Rayleigh, aerosol, ozone. Water vapour and
/// mixed gases absorb where the eye hardly sees.
double transmittance(double nm, double turbidity, double airMass) {
  const double um = nm * 1e-3;
  const double rayleigh = 0.008735 * std::pow(um, -4.08);
  const double aerosol = (0.04608 * turbidity - 0.04586) * std::pow(um, -1.3);
  const double ozone = 0.35 * ozoneAbsorption(nm);
  return std::exp(-(rayleigh + aerosol + ozone) * airMass);
}

/// Of the disc, linear Rec. 709, in kcd/m2. The sun outside of the air is a black body of 5778 K that gives 133.3 klx.
Rgb sunInKcd(double turbidity, double zenithAngle) {
  const double airMass = 1 / (std::cos(zenithAngle) + 0.15 * std::pow(93.885 - zenithAngle * 180 / kPi, -1.253));
  glm::dvec3 outside(0), inside(0);
  for (double nm = 380; nm <= 760; nm += 5) {
    const glm::dvec3 power = planck(nm, 5778) * colourMatching(nm);
    outside += power;
    inside += power * transmittance(nm, turbidity, airMass);
  }
  const double halfAngle = Daylight::sunHalfAngle_deg * kPi / 180;
  const double solidAngle = 4 * kPi * std::pow(std::sin(halfAngle / 2), 2);
  return rgbFromXyz(inside / outside.y * (133.3 / solidAngle));
}

/// Y in kcd/m2, x, y (Preetham 1999, appendix 2).
glm::dvec3 zenith(double t, double thetaSun) {
  const double chi = (4.0 / 9 - t / 120) * (kPi - 2 * thetaSun);
  const double s1 = thetaSun, s2 = s1 * s1, s3 = s2 * s1;
  const auto chromaticity = [&](std::array<double, 4> square, std::array<double, 4> linear,
                                std::array<double, 4> constant) {
    const auto cubic = [&](const std::array<double, 4>& k) { return k[0] * s3 + k[1] * s2 + k[2] * s1 + k[3]; };
    return (cubic(square) * t + cubic(linear)) * t + cubic(constant);
  };
  return {(4.0453 * t - 4.9710) * std::tan(chi) - 0.2155 * t + 2.4192,
          chromaticity({0.00166, -0.00375, 0.00209, 0}, {-0.02903, 0.06377, -0.03202, 0.00394},
                       {0.11693, -0.21196, 0.06052, 0.25886}),
          chromaticity({0.00275, -0.00610, 0.00317, 0}, {-0.04214, 0.08970, -0.04153, 0.00516},
                       {0.15346, -0.26756, 0.06670, 0.26688})};
}

}  // namespace

Daylight::Daylight(double turbidity, double azimuth_deg, double elevation_deg)
    : sunDirection_(directionOf(azimuth_deg, elevation_deg)),
      glowDirection_(directionOf(azimuth_deg, std::max(0.0, elevation_deg))) {
  const auto t = static_cast<float>(std::clamp(turbidity, 2.0, 10.0));
  a_ = {0.1787f * t - 1.4630f, -0.0193f * t - 0.2592f, -0.0167f * t - 0.2608f};
  b_ = {-0.3554f * t + 0.4275f, -0.0665f * t + 0.0008f, -0.0950f * t + 0.0092f};
  c_ = {-0.0227f * t + 5.3251f, -0.0004f * t + 0.2125f, -0.0079f * t + 0.2102f};
  d_ = {0.1206f * t - 2.5771f, -0.0641f * t - 0.8989f, -0.0441f * t - 1.6537f};
  e_ = {-0.0670f * t + 0.3703f, -0.0033f * t + 0.0452f, -0.0109f * t + 0.0529f};

  const double thetaSun = (90 - std::max(0.0, elevation_deg)) * kPi / 180;
  const double dusk = std::clamp(1 + elevation_deg / kTwilight_deg, 0.0, 1.0);
  glm::dvec3 zenithYxy = zenith(t, thetaSun);
  zenithYxy.x *= dusk * dusk;
  scale_ = glm::vec3(zenithYxy) / perez(1, static_cast<float>(thetaSun), static_cast<float>(std::cos(thetaSun)));
  if (elevation_deg > -sunHalfAngle_deg) sunRadiance_ = kRadiancePerKcd * sunInKcd(t, thetaSun);

  // Irradiance of the ground: midpoints of a grid that is even in cos^2 theta, so that every cell counts the same.
  constexpr int kRows = 32, kColumns = 64;
  glm::dvec3 irradiance(0);
  for (int y = 0; y < kRows; ++y) {
    for (int x = 0; x < kColumns; ++x)
      irradiance += glm::dvec3(sky(latLongDirection((x + 0.5f) / kColumns, std::sqrt((y + 0.5f) / kRows))));
  }
  irradiance *= kPi / (kRows * kColumns);
  const double half = std::sin(sunHalfAngle_deg * kPi / 180);
  irradiance += glm::dvec3(sunRadiance_) * (kPi * half * half * std::max(0.0f, sunDirection_.z));
  groundRadiance_ = irradiance * (kGroundAlbedo / kPi);
}

glm::vec3 Daylight::perez(float cosTheta, float gamma, float cosGamma) const {
  return (1.0f + a_ * glm::exp(b_ / cosTheta)) * (1.0f + c_ * glm::exp(d_ * gamma) + e_ * (cosGamma * cosGamma));
}

Rgb Daylight::sky(glm::vec3 d) const {
  const float cosGamma = std::clamp(glm::dot(d, glowDirection_), -1.0f, 1.0f);
  const glm::vec3 yxy = scale_ * perez(std::max(d.z, 1e-3f), std::acos(cosGamma), cosGamma);
  const float y = std::max(0.0f, yxy.x) / std::max(yxy.z, 1e-3f);
  return kRadiancePerKcd * rgbFromXyz({yxy.y * y, std::max(0.0f, yxy.x), std::max(0.0f, 1 - yxy.y - yxy.z) * y});
}

Rgb Daylight::radiance(glm::vec3 d) const {
  return d.z > 0 ? sky(d) : groundRadiance_;
}

}  // namespace loomlight
