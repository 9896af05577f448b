#include "render/optics/bcsdf.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/statistical/chi_square.h"

namespace loomlight {
namespace {

using test::integrate;

constexpr double radians(double degrees) {
  return degrees * kPi / 180;
}

glm::vec3 direction(double theta, double phi) {
  return glm::vec3(std::sin(theta), std::cos(theta) * std::cos(phi), std::cos(theta) * std::sin(phi));
}

Fibre fibreOf(double along, double about, double index = 1.55, double tilt_deg = 0) {
  Fibre fibre;
  fibre.longitudinalRoughness = along;
  fibre.azimuthalRoughness = about;
  fibre.refractiveIndex = index;
  fibre.scaleTilt_deg = tilt_deg;
  return fibre;
}

/// Integral over wi of the sum of all modes.
double furnace(const FibreBcsdf& bcsdf, glm::vec3 wo, float h, int rows, int columns) {
  const auto ring = [&](double theta) {
    const auto point = [&](double phi) {
      return static_cast<double>(bcsdf.evaluate(wo, direction(theta, phi), h).sum());
    };
    return std::cos(theta) * integrate(point, -kPi, kPi, columns);
  };
  return integrate(ring, -kPi / 2, kPi / 2, rows);
}

/// Mean over h, integral over azimuth, of the light that goes from inclination o to i; all of it depends only on
/// differences of azimuth. Midpoint rules in arcsine h and azimuth, both periodic.
double transfer(const FibreBcsdf& bcsdf, double o, double i) {
  constexpr int kOffsets = 24, kAzimuths = 64;
  double sum = 0;
  for (int j = 0; j < kOffsets; ++j) {
    const double gamma = 0.5 * kPi * (j + 0.5) / kOffsets;  // the other half, h < 0, is its mirror image
    double ring = 0;
    for (int k = 0; k < kAzimuths; ++k)
      ring +=
          bcsdf.evaluate(direction(o, 0), direction(i, 2 * kPi * k / kAzimuths), static_cast<float>(std::sin(gamma)))
              .sum();
    sum += std::cos(gamma) * ring;
  }
  return sum * (0.5 * kPi / kOffsets) * (2 * kPi / kAzimuths);
}

/// Rays that come from everywhere, side by side.
struct EightRays {
  std::vector<glm::vec3> wo, wi;
  std::vector<float> h;
  Vec3Of<Float32x8> woLanes{}, wiLanes{};
  Float32x8 hLanes{};

  explicit EightRays(Random& random) {
    for (int i = 0; i < 8; ++i) {
      wo.push_back(direction(3 * (random.uniform() - 0.5), 6.28 * random.uniform()));
      wi.push_back(direction(3 * (random.uniform() - 0.5), 6.28 * random.uniform()));
      h.push_back(2 * random.uniform() - 1);
      put(woLanes, i, wo.back());
      put(wiLanes, i, wi.back());
      hLanes[i] = h.back();
    }
  }
  static void put(Vec3Of<Float32x8>& lanes, int i, glm::vec3 v) {
    lanes.x[i] = v.x;
    lanes.y[i] = v.y;
    lanes.z[i] = v.z;
  }
};

TEST(FibreBcsdf, ValuesOfManyRaysAtManyOffsetsAreToTheBitThoseOfEachAlone) {
  Random random(3);
  for (const double tilt_deg : {0.0, 3.0}) {
    const FibreBcsdf bcsdf(fibreOf(0.2, 0.3, 1.55, tilt_deg));
    for (int i = 0; i < 200; ++i) {
      const EightRays rays(random);
      const std::array<Float32x8, 2> offsets{rays.hLanes, -rays.hLanes};
      std::array<FibreBcsdf::ValueOf<Float32x8>, 2> values;
      bcsdf.evaluate(rays.woLanes, rays.wiLanes, offsets, values);
      for (size_t at = 0; at < 2; ++at)
        for (size_t lane = 0; lane < 8; ++lane) {
          const auto alone = bcsdf.evaluate(rays.wo[lane], rays.wi[lane], at == 0 ? rays.h[lane] : -rays.h[lane]);
          for (size_t mode = 0; mode < FibreBcsdf::kModes; ++mode)
            ASSERT_EQ(values[at].q[mode][lane], alone.q[mode]) << lane << " " << mode;
          ASSERT_EQ(values[at].chord_radii[lane], alone.chord_radii);
          ASSERT_EQ(values[at].internalReflectance[lane], alone.internalReflectance);
        }
    }
  }
}

TEST(FibreBcsdf, SamplesOfManyRaysAreToTheBitThoseOfEachAlone) {
  Random random(4);
  std::array<int, FibreBcsdf::kModes> modes{};
  for (const double tilt_deg : {0.0, 3.0}) {
    const FibreBcsdf bcsdf(fibreOf(0.4, 0.3, 1.55, tilt_deg));
    for (int i = 0; i < 500; ++i) {
      EightRays rays(random);
      EightRays::put(rays.woLanes, 7, {1, 0, 0});  // nothing would be accepted there, and nobody is to wait for it
      std::vector<Random> own, alone;
      for (uint64_t lane = 0; lane < 8; ++lane) own.emplace_back(hashCombine(lane, static_cast<uint64_t>(i)));
      alone = own;
      RandomLanes<Float32x8> numbers(std::array<Random*, 8>{&own[0], &own[1], &own[2], &own[3], &own[4], &own[5],
                                                            &own[6], nullptr});  // a lane that is not in use
      const auto together = bcsdf.sample(rays.woLanes, rays.hLanes, numbers, true);
      for (size_t lane = 0; lane < 7; ++lane) {
        const FibreBcsdf::Sample one = bcsdf.sample(rays.wo[lane], rays.h[lane], alone[lane]);
        ASSERT_EQ(together.wi.x[lane], one.wi.x);
        ASSERT_EQ(together.wi.y[lane], one.wi.y);
        ASSERT_EQ(together.wi.z[lane], one.wi.z);
        ASSERT_EQ(together.order[lane], one.order);
        ASSERT_EQ(together.length_radii[lane], one.length_radii);
        ASSERT_EQ(together.pdf[lane], one.pdf);
        ASSERT_EQ(own[lane].next(), alone[lane].next()) << "each has drawn as many numbers";
        ++modes[static_cast<size_t>(std::min(one.order, 3))];
      }
    }
  }
  for (const int count : modes) EXPECT_GT(count, 0) << "every mode was drawn";
}

TEST(FibreBcsdf, WhiteFurnace) {
  for (const double along : {0.05, 0.1, 0.3, 0.6, 1.0}) {
    for (const double about : {0.2, 1.0}) {
      for (const double index : {1.01, 1.35, 1.7}) {
        const FibreBcsdf bcsdf(fibreOf(along, about, index));
        for (const double theta : {0.0, -40.0, 75.0, 85.0, 89.0, 90.0}) {
          for (const float h : {-1.0f, 0.35f, 0.9f}) {
            const double sum =
                furnace(bcsdf, direction(radians(theta), 0.4), h, along < 0.2 ? 100 : 24, about < 0.5 ? 60 : 24);
            EXPECT_NEAR(sum, 1, 3e-4) << along << " " << about << " " << index << " " << theta << " " << h;
          }
        }
      }
    }
  }
}

TEST(FibreBcsdf, WhiteFurnaceOfNarrowAzimuthsTiltedScalesAndOtherSections) {
  for (const FibreSection section : {FibreSection::round, FibreSection::kidney, FibreSection::trilobal}) {
    for (const double tilt : {-10.0, 3.0}) {
      Fibre fibre = fibreOf(0.15, 0.05, 1.55, tilt);
      fibre.section = section;
      const FibreBcsdf bcsdf(fibre);
      for (const double theta : {-88.0, 10.0, 70.0}) {
        EXPECT_NEAR(furnace(bcsdf, direction(radians(theta), 0.4), 0.6f, 60, 200), 1, 1e-3) << tilt << " " << theta;
      }
    }
  }
}

TEST(FibreBcsdf, LightIsKeptFromBothSides) {
  for (const double roughness : {0.2, 0.3, 0.6, 1.0}) {
    for (const double index : {1.35, 1.55}) {
      const FibreBcsdf bcsdf(fibreOf(roughness, 0.5, index));
      for (const double i : {0.0, 45.0, 75.0, 85.0}) {
        const auto arriving = [&](double o) { return transfer(bcsdf, o, radians(i)) * std::cos(o) * std::cos(o); };
        EXPECT_NEAR(integrate(arriving, -kPi / 2, kPi / 2, 24) / std::cos(radians(i)), 1, 3e-3)
            << roughness << " " << index << " " << i;
      }
    }
  }
}

TEST(FibreBcsdf, LongitudinallyReciprocal) {
  for (const double roughness : {0.2, 0.5}) {
    const FibreBcsdf bcsdf(fibreOf(roughness, 0.5));
    for (const double o : {0.0, 30.0, 60.0, 80.0, 88.0}) {
      for (const double i : {-85.0, -50.0, -10.0, 25.0}) {
        const double there = std::cos(radians(o)) * transfer(bcsdf, radians(o), radians(i));
        const double back = std::cos(radians(i)) * transfer(bcsdf, radians(i), radians(o));
        EXPECT_NEAR(there, back, 3e-3 * back + 1e-9) << roughness << " " << o << " " << i;
      }
    }
  }
}

TEST(FibreBcsdf, SamplesHaveWeightOne) {
  for (const double roughness : {0.05, 0.3, 1.0}) {
    for (const double tilt : {0.0, 3.0}) {
      const FibreBcsdf bcsdf(fibreOf(roughness, roughness, 1.55, tilt));
      Random random(3);
      for (int k = 0; k < 4000; ++k) {
        const glm::vec3 wo = direction(std::asin(2 * random.uniformDouble() - 1), 2 * kPi * random.uniformDouble());
        const float h = 2 * random.uniform() - 1;
        const FibreBcsdf::Sample sample = bcsdf.sample(wo, h, random);
        EXPECT_NEAR(glm::length(sample.wi), 1, 1e-5);
        EXPECT_NEAR(bcsdf.evaluate(wo, sample.wi, h).sum() / sample.pdf, 1, 3e-4);
        EXPECT_EQ(sample.length_radii, static_cast<float>(sample.order) * bcsdf.modes(wo, h).chord_radii);
      }
    }
  }
}

TEST(FibreBcsdf, LeavingOutThePdfChangesNothingElse) {
  const FibreBcsdf bcsdf(fibreOf(0.3, 0.3));
  Random one(9), two(9);
  for (int k = 0; k < 200; ++k) {
    const glm::vec3 wo = direction(0.015 * (k - 100), 0.1 * k);
    const FibreBcsdf::Sample with = bcsdf.sample(wo, 0.4f, one), without = bcsdf.sampleWithoutPdf(wo, 0.4f, two);
    EXPECT_LT(glm::distance(with.wi, without.wi), 1e-6f);
    EXPECT_EQ(with.order, without.order);
    EXPECT_EQ(without.pdf, 0);
  }
}

TEST(FibreBcsdf, ReflectsAndTransmitsWhereASmoothFibreWould) {
  const FibreBcsdf bcsdf(fibreOf(0.05, 0.05));
  const double theta = radians(30), phi = 0.4, gamma = std::asin(0.5);
  const glm::vec3 wo = direction(theta, phi);
  // R leaves at 2 gamma_o from wo, on the other side of the normal plane.
  const auto atMirror = bcsdf.evaluate(wo, direction(-theta, phi - 2 * gamma), 0.5f);
  EXPECT_GT(atMirror.q[0], 50 * bcsdf.evaluate(wo, direction(-theta, phi + 2 * gamma), 0.5f).q[0]);
  EXPECT_GT(atMirror.q[0], 50 * bcsdf.evaluate(wo, direction(theta, phi - 2 * gamma), 0.5f).q[0]);
  // Through the axis, TT goes straight on.
  EXPECT_GT(bcsdf.evaluate(wo, -wo, 0).q[1], 100 * bcsdf.evaluate(wo, direction(-theta, phi), 0).q[1]);
}

TEST(FibreBcsdf, ScaleTiltTurnsTheConeOfReflectionByTwiceItsAngle) {
  const auto meanInclination = [](double tilt_deg) {
    const FibreBcsdf bcsdf(fibreOf(0.1, 0.3, 1.55, tilt_deg));
    const auto moment = [&](int power) {
      return integrate(
          [&](double i) {
            return std::pow(i, power) * std::cos(i) *
                   bcsdf.evaluate(direction(radians(20), 0), direction(i, 0), 0).q[0];
          },
          -kPi / 2, kPi / 2, 200);
    };
    return moment(1) / moment(0);
  };
  EXPECT_NEAR(meanInclination(3) - meanInclination(0), radians(6), radians(0.1));
}

TEST(FibreBcsdf, OtherSectionsBroadenTheAzimuthOnly) {
  Fibre fibre = fibreOf(0.3, 0.1);
  const FibreBcsdf round(fibre);
  const glm::vec3 wo = direction(0.2, 0), mirror = direction(-0.2, 0);
  for (const FibreSection section : {FibreSection::kidney, FibreSection::triangle, FibreSection::trilobal,
                                     FibreSection::serrated, FibreSection::polygon}) {
    fibre.section = section;
    const FibreBcsdf shaped(fibre);
    EXPECT_LT(shaped.evaluate(wo, mirror, 0).q[0], 0.7f * round.evaluate(wo, mirror, 0).q[0]);
    EXPECT_EQ(shaped.modes(wo, 0.3f).share, round.modes(wo, 0.3f).share);
  }
}

TEST(FibreBcsdf, EdgesOfTheFibreGiveNumbers) {
  for (const double along : {0.05, 1.0}) {
    for (const double about : {0.05, 1.0}) {
      for (const double index : {1.01, 3.0}) {
        for (const double tilt : {0.0, 10.0}) {
          const FibreBcsdf bcsdf(fibreOf(along, about, index, tilt));
          Random random(5);
          for (const glm::vec3 wo :
               {direction(radians(90), 0), glm::vec3(1, 0, 0), glm::vec3(-1, 0, 0), glm::vec3(0, 0, -1),
                direction(radians(-89.99), 1), glm::vec3(1.0000001f, 1e-20f, 0)}) {
            for (const float h : {-1.0f, 0.0f, 1.0f}) {
              for (int k = 0; k < 50; ++k) {
                const FibreBcsdf::Sample sample = bcsdf.sample(wo, h, random);
                EXPECT_TRUE(std::isfinite(sample.wi.x + sample.wi.y + sample.wi.z));
                EXPECT_TRUE(std::isfinite(sample.pdf) && sample.pdf > 0) << sample.pdf;
                EXPECT_TRUE(std::isfinite(sample.length_radii) && sample.order >= 0);
              }
              for (const glm::vec3 wi : {wo, -wo, glm::vec3(1, 0, 0), glm::vec3(0, 1, 0)}) {
                const float sum = bcsdf.evaluate(wo, wi, h).sum();
                EXPECT_TRUE(std::isfinite(sum) && sum >= 0) << sum;
              }
            }
          }
        }
      }
    }
  }
}

TEST(FibreBcsdf, NotANumberNeitherHangsNorCrashes) {
  const FibreBcsdf bcsdf(fibreOf(0.3, 0.3));
  const float bad = std::nanf("");
  Random random(1);
  EXPECT_GE(bcsdf.sample(glm::vec3(bad), 0.5f, random).order, 0);
  EXPECT_GE(bcsdf.sample(glm::vec3(0, 1, 0), bad, random).order, 0);
  EXPECT_TRUE(std::isfinite(bcsdf.evaluate(glm::vec3(bad), glm::vec3(bad), bad).chord_radii));
}

}  // namespace
}  // namespace loomlight
