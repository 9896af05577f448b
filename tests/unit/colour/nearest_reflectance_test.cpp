#include "render/colour/nearest_reflectance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/random.h"
#include "render/colour/colour_difference.h"

namespace loomlight {
namespace {

TristimulusWeights weightsUnder(const char* lamp) {
  return tristimulusWeights(illuminantNamed(lamp), Observer::degrees10);
}

double distance(const TristimulusWeights& weights, const Spectrum& one, const Spectrum& other) {
  return ciede2000(labUnder(weights, one), labUnder(weights, other));
}

/// A hill of reflectance on a plain.
Spectrum hill(double plain, double height, double centre_nm, double width_nm) {
  Spectrum reflectance;
  for (size_t j = 0; j < kBands; ++j) {
    const double away = (bandWavelength_nm(j) - centre_nm) / width_nm;
    reflectance[j] = static_cast<float>(plain + height * std::exp(-away * away));
  }
  return reflectance;
}

/// What a sheer cloth can be, of a fibre that is a little yellow.
struct Reach {
  Spectrum darkest{}, lightest{};
  Reach() {
    darkest.fill(0.03f);
    for (size_t j = 0; j < kBands; ++j) lightest[j] = static_cast<float>(0.25 + 0.1 * j / kBands);
  }
  Spectrum clipped(Spectrum wanted) const {
    for (size_t j = 0; j < kBands; ++j) wanted[j] = std::clamp(wanted[j], darkest[j], lightest[j]);
    return wanted;
  }
};

const std::vector<Spectrum> kOutOfReach = {hill(0.55, 0.35, 700, 90),   // a pale pink
                                           hill(0.008, 0.06, 450, 35),  // navy
                                           hill(0.008, 0.25, 720, 60),  // maroon
                                           hill(0.02, 0.75, 680, 90),   // orange
                                           hill(0.9, 0, 500, 50),       // white
                                           hill(0.002, 0, 500, 50)};    // black

TEST(NearestReflectance, WhatCanBeHadIsItself) {
  const Reach reach;
  const Spectrum wanted = hill(0.05, 0.15, 520, 60);
  EXPECT_EQ(nearestReflectance(wanted, reach.darkest, reach.lightest, weightsUnder("D65")), wanted);
}

TEST(NearestReflectance, IsWithinReachAndNeverFurtherThanCuttingOff) {
  const Reach reach;
  for (const char* lamp : {"D65", "A", "F11", "LED-B3"})
    for (const Spectrum& wanted : kOutOfReach) {
      const Spectrum nearest = nearestReflectance(wanted, reach.darkest, reach.lightest, weightsUnder(lamp));
      for (size_t j = 0; j < kBands; ++j) {
        EXPECT_GE(nearest[j], reach.darkest[j]);
        EXPECT_LE(nearest[j], reach.lightest[j]);
      }
      EXPECT_LE(distance(weightsUnder(lamp), wanted, nearest),
                distance(weightsUnder(lamp), wanted, reach.clipped(wanted)));
    }
}

/// Others are drawn as a few waves of the logarithm, added to what is wanted. Less than a third of what an eye tells
/// apart may be given away for smoothness.
TEST(NearestReflectance, NoneOfManyOthersIsNearer) {
  const Reach reach;
  Random random(11);
  for (const char* lamp : {"D65", "F11"})
    for (const Spectrum& wanted : kOutOfReach) {
      const TristimulusWeights weights = weightsUnder(lamp);
      const double off = distance(weights, wanted, nearestReflectance(wanted, reach.darkest, reach.lightest, weights));
      for (int i = 0; i < 3000; ++i) {
        std::array<double, 5> waves;
        for (double& wave : waves) wave = 4 * random.uniform() - 2;
        Spectrum other = wanted;
        for (size_t j = 0; j < kBands; ++j)
          for (size_t k = 0; k < waves.size(); ++k)
            other[j] *= static_cast<float>(std::exp(waves[k] * std::cos(3.14159 * double(j * k) / kBands)));
        EXPECT_GE(distance(weights, wanted, reach.clipped(other)), off - 0.3) << lamp;
      }
    }
}

/// A colour that other reflectances have which can be had is reached by one of them.
TEST(NearestReflectance, FindsAnotherSpectrumOfTheSameColour) {
  const Reach reach;
  Spectrum wanted = hill(0.05, 0.15, 600, 80);
  wanted[12] = 0.5f;  // one band alone is out of reach
  EXPECT_LT(distance(weightsUnder("D65"), wanted,
                     nearestReflectance(wanted, reach.darkest, reach.lightest, weightsUnder("D65"))),
            0.05);
  EXPECT_GT(distance(weightsUnder("D65"), wanted, reach.clipped(wanted)), 1);
}

TEST(NearestReflectance, IsAsSmoothAsWhatIsWanted) {
  const Reach reach;
  const Spectrum nearest = nearestReflectance(kOutOfReach[0], reach.darkest, reach.lightest, weightsUnder("F11"));
  for (size_t j = 1; j < kBands; ++j) EXPECT_LT(std::abs(std::log2(nearest[j] / nearest[j - 1])), 1) << j;
}

}  // namespace
}  // namespace loomlight
