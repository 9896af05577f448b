#include <gtest/gtest.h>

#include <array>

#include "render/colour/primaries.h"
#include "render/colour/tristimulus.h"

namespace loomlight {
namespace {

struct CieDaylight {
  int temperature_K;
  Rgb linear;
  std::array<float, 8> relative;  ///< power over that of D65 at 380, 430, ... 730 nm
};

// Made by tests/references/colour_daylight.py; not by Loomlight.
const CieDaylight kDaylights[] = {
    {4000, {1.3880639, 0.9355160, 0.4956685}, {0.27825, 0.43216, 0.66534, 0.89581, 1.05896, 1.34867, 1.66256, 1.57774}},
    {5000, {1.1763137, 0.9757101, 0.7212431}, {0.49228, 0.67045, 0.82500, 0.95362, 1.03886, 1.15644, 1.27450, 1.24582}},
    {6000, {1.0469164, 0.9945956, 0.9153311}, {0.82688, 0.89718, 0.94858, 0.98786, 1.01289, 1.04121, 1.06743, 1.06189}},
    {8000, {0.9019863, 1.0082125, 1.2073787}, {1.47219, 1.25880, 1.12152, 1.02478, 0.96565, 0.91512, 0.87544, 0.88097}},
    {10000,
     {0.8248439, 1.0112131, 1.4049091},
     {1.96816, 1.51198, 1.23304, 1.04362, 0.93026, 0.84967, 0.79575, 0.79881}},
    {15000,
     {0.7338639, 1.0100579, 1.6843799},
     {2.72163, 1.87765, 1.38607, 1.06495, 0.87722, 0.77434, 0.72663, 0.71755}},
    {25000,
     {0.6716680, 1.0059380, 1.9084269},
     {3.35627, 2.17522, 1.50594, 1.07889, 0.83293, 0.72415, 0.69702, 0.67309}},
};

/// Light from the sky is known by its colour alone; its spectrum is that of daylight of this colour.
TEST(DaylightPrimaries, AgreeWithAnIndependentImplementation) {
  for (const CieDaylight& daylight : kDaylights) {
    const Spectrum mine = mixed(daylightPrimaries(), daylight.linear);
    for (size_t i = 0; i < daylight.relative.size(); ++i)
      EXPECT_NEAR(mine[5 * i], daylight.relative[i], 2e-4 * daylight.relative[i])
          << daylight.temperature_K << " K at " << 380 + 50 * i << " nm";
  }
}

/// And the other way: what the eye makes of the spectrum is the colour.
TEST(DaylightPrimaries, AreSeenInTheColourThatTheyAreMadeOf) {
  const LinearWeights weights = linearWeights(illuminantNamed("D65"), Observer::degrees2);
  for (const CieDaylight& daylight : kDaylights) {
    const glm::dvec3 seen = weighted(weights, mixed(daylightPrimaries(), daylight.linear));
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(seen[c], daylight.linear[c], 1e-5);
  }
}

}  // namespace
}  // namespace loomlight
