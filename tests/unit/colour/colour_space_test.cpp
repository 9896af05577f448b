#include "render/colour/colour_space.h"

#include <gtest/gtest.h>

#include <random>

namespace loomlight {
namespace {

TEST(ColourSpace, GreysAreNeutralAndWhiteIsHundred) {
  for (const double v : {0.0, 1e-4, 0.18, 0.5, 1.0}) {
    const Lab lab = labFromLinear(glm::dvec3(v));
    EXPECT_NEAR(lab.a, 0, 1e-9);
    EXPECT_NEAR(lab.b, 0, 1e-9);
  }
  EXPECT_NEAR(labFromLinear({1, 1, 1}).L, 100, 1e-9);
  EXPECT_NEAR(labFromLinear({0, 0, 0}).L, 0, 1e-9);
  EXPECT_NEAR(labFromLinear(glm::dvec3(0.184187)).L, 50, 1e-3);  // ((50 + 16) / 116)^3
}

TEST(ColourSpace, PrimariesAreWhereTheyAreKnownToBe) {
  const auto near = [](const Lab& lab, double L, double a, double b) {
    EXPECT_NEAR(lab.L, L, 0.02);
    EXPECT_NEAR(lab.a, a, 0.03);
    EXPECT_NEAR(lab.b, b, 0.03);
  };
  near(labFromLinear({1, 0, 0}), 53.24, 80.09, 67.20);
  near(labFromLinear({0, 1, 0}), 87.73, -86.18, 83.18);
  near(labFromLinear({0, 0, 1}), 32.30, 79.19, -107.86);
}

TEST(ColourSpace, ThereAndBackIsTheSame) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> channel(0, 1);
  for (int i = 0; i < 1000; ++i) {
    const glm::dvec3 colour(channel(random), channel(random), channel(random));
    const glm::dvec3 back = linearFromLab(labFromLinear(colour));
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(back[c], colour[c], 1e-12);
  }
}

struct LabPair {
  Lab one, other;
  double difference;
};

// Sharma, Wu, Dalal 2005, Table 1: all 34, chosen by the authors to catch every wrong branch.
const LabPair kPublished[] = {
    {{50.0000, 2.6772, -79.7751}, {50.0000, 0.0000, -82.7485}, 2.0425},
    {{50.0000, 3.1571, -77.2803}, {50.0000, 0.0000, -82.7485}, 2.8615},
    {{50.0000, 2.8361, -74.0200}, {50.0000, 0.0000, -82.7485}, 3.4412},
    {{50.0000, -1.3802, -84.2814}, {50.0000, 0.0000, -82.7485}, 1.0000},
    {{50.0000, -1.1848, -84.8006}, {50.0000, 0.0000, -82.7485}, 1.0000},
    {{50.0000, -0.9009, -85.5211}, {50.0000, 0.0000, -82.7485}, 1.0000},
    {{50.0000, 0.0000, 0.0000}, {50.0000, -1.0000, 2.0000}, 2.3669},
    {{50.0000, -1.0000, 2.0000}, {50.0000, 0.0000, 0.0000}, 2.3669},
    {{50.0000, 2.4900, -0.0010}, {50.0000, -2.4900, 0.0009}, 7.1792},
    {{50.0000, 2.4900, -0.0010}, {50.0000, -2.4900, 0.0010}, 7.1792},
    {{50.0000, 2.4900, -0.0010}, {50.0000, -2.4900, 0.0011}, 7.2195},
    {{50.0000, 2.4900, -0.0010}, {50.0000, -2.4900, 0.0012}, 7.2195},
    {{50.0000, -0.0010, 2.4900}, {50.0000, 0.0009, -2.4900}, 4.8045},
    {{50.0000, -0.0010, 2.4900}, {50.0000, 0.0010, -2.4900}, 4.8045},
    {{50.0000, -0.0010, 2.4900}, {50.0000, 0.0011, -2.4900}, 4.7461},
    {{50.0000, 2.5000, 0.0000}, {50.0000, 0.0000, -2.5000}, 4.3065},
    {{50.0000, 2.5000, 0.0000}, {73.0000, 25.0000, -18.0000}, 27.1492},
    {{50.0000, 2.5000, 0.0000}, {61.0000, -5.0000, 29.0000}, 22.8977},
    {{50.0000, 2.5000, 0.0000}, {56.0000, -27.0000, -3.0000}, 31.9030},
    {{50.0000, 2.5000, 0.0000}, {58.0000, 24.0000, 15.0000}, 19.4535},
    {{50.0000, 2.5000, 0.0000}, {50.0000, 3.1736, 0.5854}, 1.0000},
    {{50.0000, 2.5000, 0.0000}, {50.0000, 3.2972, 0.0000}, 1.0000},
    {{50.0000, 2.5000, 0.0000}, {50.0000, 1.8634, 0.5757}, 1.0000},
    {{50.0000, 2.5000, 0.0000}, {50.0000, 3.2592, 0.3350}, 1.0000},
    {{60.2574, -34.0099, 36.2677}, {60.4626, -34.1751, 39.4387}, 1.2644},
    {{63.0109, -31.0961, -5.8663}, {62.8187, -29.7946, -4.0864}, 1.2630},
    {{61.2901, 3.7196, -5.3901}, {61.4292, 2.2480, -4.9620}, 1.8731},
    {{35.0831, -44.1164, 3.7933}, {35.0232, -40.0716, 1.5901}, 1.8645},
    {{22.7233, 20.0904, -46.6940}, {23.0331, 14.9730, -42.5619}, 2.0373},
    {{36.4612, 47.8580, 18.3852}, {36.2715, 50.5065, 21.2231}, 1.4146},
    {{90.8027, -2.0831, 1.4410}, {91.1528, -1.6435, 0.0447}, 1.4441},
    {{90.9257, -0.5406, -0.9208}, {88.6381, -0.8985, -0.7239}, 1.5381},
    {{6.7747, -0.2908, -2.4247}, {5.8714, -0.0985, -2.2286}, 0.6377},
    {{2.0776, 0.0795, -1.1350}, {0.9033, -0.0636, -0.5514}, 0.9082},
};

TEST(Ciede2000, AgreesWithThePublishedPairs) {
  for (const LabPair& pair : kPublished) {
    EXPECT_NEAR(ciede2000(pair.one, pair.other), pair.difference, 0.5e-4 + 1e-9) << "pair " << &pair - kPublished + 1;
  }
}

TEST(Ciede2000, IsSymmetricAndZeroForTheSame) {
  for (const LabPair& pair : kPublished) {
    EXPECT_NEAR(ciede2000(pair.other, pair.one), ciede2000(pair.one, pair.other), 1e-9);
    EXPECT_EQ(ciede2000(pair.one, pair.one), 0);
  }
}

}  // namespace
}  // namespace loomlight
