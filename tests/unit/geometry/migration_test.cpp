#include "core/geometry/yarn/migration.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/geometry/yarn/cross_section.h"
#include "tests/support/worst_overlap.h"

namespace loomlight {
namespace {

constexpr int kFibres = 45;
constexpr double kAmount = 0.25;

DiscCentres section(FibreLayout layout, double packing) {
  return plySection(layout, kFibres, std::sqrt(kFibres / packing), {1}, 7);
}

DiscCentres placesAt(const Migration& ply, double migrations) {
  DiscCentres places;
  for (int i = 0; i < ply.fibres(); ++i) places.emplace_back(ply.place(i, ply.at(migrations)));
  return places;
}

TEST(Migration, OfPackedFibresHasThemGoRoundOneAnother) {
  const Migration ply(section(FibreLayout::packed, 0.5), FibreLayout::packed, kAmount, {1}, 11);
  const Migration alone(section(FibreLayout::packed, 0.5), FibreLayout::random, kAmount, {1}, 11);
  double worst = 0, worstAlone = 0;
  for (int i = 0; i < 100; ++i) {  // at the stages and between them
    worst = std::max(worst, test::worstOverlap(placesAt(ply, 0.01 * i), {1}));
    worstAlone = std::max(worstAlone, test::worstOverlap(placesAt(alone, 0.01 * i), {1}));
  }
  EXPECT_LT(worst, 0.1);
  EXPECT_GT(worstAlone, 1);
}

/// Of every fibre with the one that it is deepest in, on average; in radii.
double meanOverlap(const DiscCentres& centres) {
  double sum = 0;
  for (size_t i = 0; i < centres.size(); ++i) {
    double deepest = 0;
    for (size_t j = 0; j < centres.size(); ++j)
      if (j != i) deepest = std::max(deepest, 2 - glm::length(centres[i] - centres[j]));
    sum += deepest;
  }
  return sum / static_cast<double>(centres.size());
}

TEST(Migration, OfManyFibresHasMostGoRoundOneAnother) {
  constexpr int kMany = 1000;
  const DiscCentres start = plySection(FibreLayout::packed, kMany, std::sqrt(kMany / 0.5), {1}, 7);
  const Migration ply(start, FibreLayout::packed, kAmount, {1}, 11);
  const Migration alone(start, FibreLayout::random, kAmount, {1}, 11);
  for (const double migrations : {0.0, 0.33, 0.71})
    EXPECT_LT(meanOverlap(placesAt(ply, migrations)), 0.125 * meanOverlap(placesAt(alone, migrations)));
}

TEST(Migration, StopsWhenItIsTold) {
  std::stop_source stop;
  stop.request_stop();
  Task stopped = oneThread();
  stopped.stop = stop.get_token();
  const DiscCentres start = section(FibreLayout::packed, 0.5);
  const Migration ply(start, FibreLayout::packed, kAmount, {1}, 11, stopped);
  const Migration unparted(start, FibreLayout::random, kAmount, {1}, 11);
  for (int i = 0; i < kFibres; ++i) EXPECT_EQ(ply.place(i, ply.at(0.3)), unparted.place(i, unparted.at(0.3)));
}

TEST(Migration, TakesFibresInAndOutAsFarAsItIsTold) {
  const DiscCentres start = section(FibreLayout::random, 0.5);
  const Migration ply(start, FibreLayout::random, kAmount, {1}, 11);
  for (int i = 0; i < kFibres; ++i) {
    double nearest = 1e9, furthest = 0;
    for (int k = 0; k < 240; ++k) {
      const double reach = glm::length(ply.place(i, ply.at(k / 240.0)));
      nearest = std::min(nearest, reach);
      furthest = std::max(furthest, reach);
    }
    // The cubic through 24 stages is off by a part in a thousand, and the extremes lie within half a stage of one.
    EXPECT_NEAR(furthest / glm::length(start[i]), 1, 0.004);
    EXPECT_NEAR(nearest / glm::length(start[i]), 1 - kAmount, 0.004);
  }
}

TEST(Migration, RepeatsWithoutAStep) {
  const Migration ply(section(FibreLayout::packed, 0.5), FibreLayout::packed, kAmount, {1}, 11);
  for (int i = 0; i < kFibres; ++i) {
    EXPECT_LT(glm::distance(ply.place(i, ply.at(0.9999999)), ply.place(i, ply.at(1))), 1e-5);
    EXPECT_LE(glm::length(ply.place(i, ply.at(0.37))), ply.reach_mm());
  }
}

TEST(Migration, OfNothingIsTheSection) {
  const DiscCentres places = section(FibreLayout::packed, 0.5);
  const Migration ply(places);
  EXPECT_FALSE(ply.moves());
  for (int i = 0; i < kFibres; ++i) EXPECT_LT(glm::distance(glm::dvec2(ply.place(i)), places[i]), 1e-6);
}

/// RMS slope along an axis of the section over all fibres of a ply that does nothing but stray.
double rmsSlope(double asked, double migration_mm, double plyRadius_mm, uint64_t seed) {
  constexpr int kMany = 400, kSteps = 480;
  const Migration ply(DiscCentres(kMany, glm::dvec2(0)), FibreLayout::packed, 0, {0.001}, seed, oneThread(),
                      {asked, migration_mm, plyRadius_mm});
  double squares = 0;
  for (int i = 0; i < kMany; ++i)
    for (int step = 0; step < kSteps; ++step) {
      const glm::vec2 from = ply.place(i, ply.at(static_cast<double>(step) / kSteps));
      const glm::vec2 to = ply.place(i, ply.at((step + 1.0) / kSteps));
      const glm::vec2 slope = (to - from) * static_cast<float>(kSteps / migration_mm);
      squares += 0.5 * glm::dot(slope, slope);
    }
  return std::sqrt(squares / (kMany * kSteps));
}

// 400 fibres with six waves each: the mean square is known to some 6 %, of which loops are half, the RMS to 3 %.
TEST(FibreDisorder, HasTheSlopeThatIsAsked) {
  for (const double slope : {0.02, 0.1, 0.2}) {
    EXPECT_NEAR(rmsSlope(slope, 3.1, 0.18, 3) / slope, 1, 0.1);
    EXPECT_NEAR(rmsSlope(slope, 1.0, 0.18, 5) / slope, 1, 0.1);
  }
}

TEST(FibreDisorder, StraysNoWiderWhereTwistIsLow) {
  constexpr double kSlope = 0.1, kRadius = 0.1;
  const Migration ply(DiscCentres(400, glm::dvec2(0)), FibreLayout::packed, 0, {0.001}, 3, oneThread(),
                      {kSlope, 50, kRadius});
  // Three waves along either axis, each of sqrt(2 / 3) of the slope and nine radii long, of a fibre that strays more
  // than twice as far; and (2 pi / 3)^2 / 8 of it that a cubic may swing beyond stages, three to a wave.
  const double wave_mm = std::sqrt(2.0 / 3) * kSlope * 9 * kRadius / (2 * kPi);
  EXPECT_LT(ply.reach_mm(), 1.55 * std::sqrt(2.0) * 3 * 2.2 * wave_mm);
  EXPECT_GT(ply.reach_mm(), 0.1 * kRadius);
}

TEST(FibreDisorder, LeavesFibresWhereTheyAreOnAverage) {
  const DiscCentres section = plySection(FibreLayout::packed, kFibres, std::sqrt(kFibres / 0.5), {1}, 7);
  const Migration ply(section, FibreLayout::packed, 0, {1}, 11, oneThread(), {0.1, 100, std::sqrt(kFibres / 0.5)});
  for (int i = 0; i < kFibres; ++i) {
    glm::dvec2 mean(0);
    double strays = 0;
    for (int k = 0; k < Migration::kStages; ++k) {
      const glm::dvec2 at(ply.place(i, ply.at(static_cast<double>(k) / Migration::kStages)));
      mean += at / static_cast<double>(Migration::kStages);
      strays = std::max(strays, glm::length(at - section[static_cast<size_t>(i)]));
    }
    EXPECT_LT(glm::length(mean - section[static_cast<size_t>(i)]), 1e-5);
    EXPECT_GT(strays, 0.1);
  }
}

// A section turns within its pressed outline: no fibre may run into another, wherever it is on its way.
TEST(PressedSection, PackedFibresDoNotOverlapHoweverItTurns) {
  const SectionScale pressed = {0.7, 1.15};  // packing 0.62
  const HelicalFibres fibres{1, 0, pressed};
  const double plyRadius = std::sqrt(80 / 0.5);
  const DiscCentres start = plySection(FibreLayout::packed, 80, plyRadius, {1 / std::sqrt(0.7 * 1.15)}, 7);
  const auto worst = [&](const Migration& ply, int turns) {
    double most = 0;
    for (int i = 0; i < 96; ++i) {  // at the stages and between them
      const double share = i / 96.0, angle = 2 * kPi * turns * share;
      DiscCentres places;
      for (int k = 0; k < ply.fibres(); ++k) {
        const glm::dvec2 p(ply.place(k, ply.at(share)));
        places.emplace_back(pressed.up * (std::cos(angle) * p.x - std::sin(angle) * p.y),
                            pressed.across * (std::sin(angle) * p.x + std::cos(angle) * p.y));
      }
      most = std::max(most, test::worstOverlap(places, {1}));
    }
    return most;
  };
  for (const int turns : {1, -2}) {
    const FibrePattern pattern{2, turns};
    const Migration ply(start, FibreLayout::packed, 0, fibres, 11, oneThread(), {}, pattern);
    EXPECT_LT(worst(ply, turns), 0.1) << turns;
    EXPECT_GT(worst(ply, -turns), 0.3) << "parted for the other way";
  }
}

}  // namespace
}  // namespace loomlight
