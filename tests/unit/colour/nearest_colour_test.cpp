#include "render/colour/nearest_colour.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/random.h"
#include "render/colour/colour_space.h"

namespace loomlight {
namespace {

const Rgb kDarkest(0.015f), kLightest(0.65f, 0.64f, 0.6f);

double distance(const Rgb& one, const Rgb& other) {
  return ciede2000(labFromLinear(glm::dvec3(one)), labFromLinear(glm::dvec3(other)), 2);
}

TEST(NearestColour, WhatCanBeHadIsItself) {
  for (const Rgb& wanted : {Rgb(0.3f, 0.2f, 0.1f), kDarkest, kLightest})
    EXPECT_EQ(nearestColour(wanted, kDarkest, kLightest), wanted);
}

TEST(NearestColour, NoneOfManyOthersIsNearer) {
  Random random(7);
  for (const Rgb& wanted : {Rgb(1.0f), Rgb(0.0f), Rgb(1.0f, 0.67f, 0.72f), Rgb(0.63f, 1.0f, 0.75f), Rgb(1, 0, 0),
                            Rgb(0.04f, 1.0f, 0.01f), Rgb(0, 0, 0.22f), Rgb(0.8f, 0.8f, 0.95f)}) {
    const Rgb nearest = nearestColour(wanted, kDarkest, kLightest);
    for (int c = 0; c < 3; ++c) {
      EXPECT_GE(nearest[c], kDarkest[c]);
      EXPECT_LE(nearest[c], kLightest[c]);
    }
    const double off = distance(nearest, wanted);
    for (int i = 0; i < 2000; ++i) {
      const Rgb at(random.uniform(), random.uniform(), random.uniform());
      EXPECT_GE(distance(glm::mix(kDarkest, kLightest, at * at), wanted), off - 0.02);
    }
  }
}

TEST(NearestColour, APastelKeepsItsHue) {
  const Rgb lightest(0.25f);
  for (const Rgb& wanted : {Rgb(1.0f, 0.58f, 0.58f), Rgb(0.63f, 1.0f, 0.75f), Rgb(0.24f, 0.62f, 0.83f)}) {
    const Lab asked = labFromLinear(glm::dvec3(wanted));
    const Lab had = labFromLinear(glm::dvec3(nearestColour(wanted, kDarkest, lightest)));
    const double cosine =
        (asked.a * had.a + asked.b * had.b) / (std::hypot(asked.a, asked.b) * std::hypot(had.a, had.b));
    EXPECT_GT(cosine, std::cos(15 * 3.14159 / 180)) << "within 15 degrees of hue";
    EXPECT_GT(std::hypot(had.a, had.b), 0.4 * std::hypot(asked.a, asked.b)) << "not grey";
  }
}

}  // namespace
}  // namespace loomlight
