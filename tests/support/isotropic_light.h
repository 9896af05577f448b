#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/transport/path_integrator.h"

namespace loomlight::test {

struct EventCount {
  double mean = 0, standardError = 0;
};

/// Scattering events per path of isotropic light that enters a flat, clear cloth through the middle of its upper face:
/// paths start evenly over the whole repeats of the weave within about `reach_mm` of the centre, at least one, and are
/// followed until they leave.
inline EventCount eventsUnderIsotropicLight(const Scene& scene, const Medium& medium, float reach_mm, int paths,
                                            uint64_t seed) {
  Random random(seed);
  double sum = 0, squares = 0;
  const ClothGeometry& geometry = scene.cloth->volume->geometry();
  const auto wholeRepeats = [reach_mm](double repeat_mm) {
    return static_cast<float>(0.5 * repeat_mm * std::max(1.0, std::round(2 * reach_mm / repeat_mm)));
  };
  const glm::vec2 reach(wholeRepeats(geometry.repeatEnds() * geometry.warpPitch_mm()),
                        wholeRepeats(geometry.repeatPicks() * geometry.weftPitch_mm()));
  const auto top = static_cast<float>(geometry.halfThickness_mm()) + 1e-3f;
  PathIntegrator integrator(scene, medium, PathSampling::plain(std::numeric_limits<uint32_t>::max()));
  PathSink nobody;
  for (int i = 0; i < paths; ++i) {
    const float u = random.uniform(), v = random.uniform(), a = random.uniform(), b = random.uniform();
    const float sine = std::sqrt(a), phi = static_cast<float>(2 * kPi) * b;  // cosine-distributed: isotropic light
    const glm::vec3 direction(sine * std::cos(phi), sine * std::sin(phi), -std::sqrt(1 - a));
    TraceCounts counts;
    integrator.follow({{reach.x * (2 * u - 1), reach.y * (2 * v - 1), top}, direction}, random, nobody, counts);
    const auto events = static_cast<double>(counts.events);
    sum += events;
    squares += events * events;
  }
  const double mean = sum / paths;
  return {mean, std::sqrt((squares / paths - mean * mean) / paths)};
}

/// What it must be, whatever the weave and however the fibres are told: their lateral area over the boundary's, which
/// for a sheet of one fibre is areal mass / (density * radius).
inline double lateralOverBoundaryArea(const Scene& scene) {
  const double mass_g_mm2 = scene.cloth->volume->geometry().measure().arealMass_g_m2 * 1e-6;
  return mass_g_mm2 / (scene.fabric->fibres[0].density_g_cm3 * 1e-3 * scene.cloth->yarns[0][0].fibreRadius_mm);
}

}  // namespace loomlight::test
