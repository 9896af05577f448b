#include "core/geometry/yarn/cross_section.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/base/random.h"
#include "tests/support/worst_overlap.h"

namespace loomlight {
namespace {

TEST(PackedSection, FibresDoNotOverlap) {
  for (const double packing : {0.1, 0.4, 0.55, 0.65, 0.75, 0.85})
    for (const int count : {1, 2, 3, 5, 12, 40, 165, 600, 2000}) {
      const double radius = std::sqrt(count / packing);
      const auto fibres = plySection(FibreLayout::packed, count, radius, {1}, 42);
      ASSERT_EQ(fibres.size(), static_cast<size_t>(count));
      EXPECT_LE(test::worstOverlap(fibres, {1}), 0.02) << count << " fibres, packing " << packing;
      for (const glm::dvec2& p : fibres) EXPECT_LE(glm::length(p), radius + 0.2) << packing << " " << count;
    }
}

// Threads that wind about the axis at 45 degrees on the rim, checked in space: from a point of one helix to the nearest
// of another. Sections of round threads, which a slanted one is not, would let them overlap by a third of a radius.
TEST(PackedSection, LeavesRoomForTheSlantOfTwistedFibres) {
  const int count = 120;
  const double radius = std::sqrt(count / 0.5), slope = 1 / radius;
  const auto nearest = [&](glm::dvec2 a, glm::dvec2 b) {
    double least = std::numeric_limits<double>::infinity();
    for (double z = -4; z <= 4; z += 0.01) {
      const double cosine = std::cos(slope * z), sine = std::sin(slope * z);
      const glm::dvec2 turned(cosine * b.x - sine * b.y, sine * b.x + cosine * b.y);
      least = std::min(least, glm::length(glm::dvec3(turned - a, z)));
    }
    return least;
  };
  const auto deepest = [&](double turns_per_mm) {
    const auto fibres = plySection(FibreLayout::packed, count, radius, {1, turns_per_mm}, 8);
    double worst = 0;
    for (size_t i = 0; i < fibres.size(); ++i)
      for (size_t j = 0; j < i; ++j)
        if (glm::distance(fibres[i], fibres[j]) < 4) worst = std::max(worst, 2 - nearest(fibres[i], fibres[j]));
    return worst;
  };
  EXPECT_LT(deepest(slope / (2 * kPi)), 0.05);
  EXPECT_GT(deepest(0), 0.3);
}

// Of n fibres at random in a disc of radius R, each lies in n - 1 others by pi r^2 / pi R^2 on average, less what those
// at the rim lack: some r / R of it.
TEST(MeanOverlap, OfFibresAtRandomIsHowMuchOfTheSectionIsFibre) {
  constexpr int kCount = 2000;
  for (const double filled : {0.1, 0.5, 0.8}) {
    const double radius = std::sqrt(kCount / filled);
    double sum = 0;
    constexpr int kSections = 20;
    for (int i = 0; i < kSections; ++i)
      sum += meanOverlap(plySection(FibreLayout::random, kCount, radius, {1}, 50 + i), {1});
    EXPECT_NEAR(sum / kSections, filled, filled * (0.02 + 1 / radius));
  }
}

TEST(MeanOverlap, CountsWhatFibresShare) {
  // Two circles of radius 1 whose centres are 1 apart share 2 pi / 3 - sqrt(3) / 2.
  const double shared = (2 * kPi / 3 - std::sqrt(3.0) / 2) / kPi;
  EXPECT_NEAR(meanOverlap({{5, 0}, {6, 0}}, {1}), shared, 1e-12);
  EXPECT_NEAR(meanOverlap({{5, 0}, {6, 0}, {9, 0}}, {1}), shared * 2 / 3, 1e-12);
  EXPECT_NEAR(meanOverlap({{50, 0}, {60, 0}}, {10}), shared, 1e-12);
  EXPECT_EQ(meanOverlap({{5, 0}, {7.1, 0}}, {1}), 0);
  EXPECT_EQ(meanOverlap({}, {1}), 0);
  EXPECT_LT(meanOverlap(plySection(FibreLayout::packed, 600, std::sqrt(600 / 0.6), {1}, 3), {1}), 0.01);
}

// However few are looked at: all pairs are found, and none twice.
TEST(MeanOverlap, IsThatOfAllPairs) {
  const double slope = 0.08;
  for (const int count : {2, 7, 60, 500})
    for (const HelicalFibres& fibres :
         {HelicalFibres{1}, HelicalFibres{1, slope}, HelicalFibres{1, slope, {0.7, 1.4}}}) {
      const DiscCentres centres = plySection(FibreLayout::random, count, std::sqrt(count / 0.6), {1}, count);
      double sum = 0;
      for (size_t i = 0; i < centres.size(); ++i)
        for (size_t j = 0; j < i; ++j)
          if (const double half = 0.5 * std::sqrt(fibres.apartSquare(centres[i], centres[j])); half < 1)
            sum += 4 / kPi * (std::acos(half) - half * std::sqrt(1 - half * half));
      EXPECT_NEAR(meanOverlap(centres, fibres), sum / count, 1e-12 * count) << count << " fibres";
    }
}

// Whoever has parted others before finds the neighbours that a first look finds, in the same order, and what is pushed
// apart ends in the same places.
TEST(Parting, WhatLayThereBeforeLeavesNoTrace) {
  const int count = 300;
  for (const HelicalFibres& fibres : {HelicalFibres{1}, HelicalFibres{1, 0.08}, HelicalFibres{1, 0.08, {0.7, 1.4}}}) {
    const DiscCentres before = plySection(FibreLayout::random, count, std::sqrt(count / 0.6), {1}, 5);
    const DiscCentres there = plySection(FibreLayout::random, count, std::sqrt(count / 0.6), {1}, 6);
    Parting used(fibres), fresh(fibres);
    SectionLanes others = sideBySide({&before, 1}), one = sideBySide({&there, 1}), other = one;
    used.sweep(others);
    EXPECT_EQ(used.sweep(one), fresh.sweep(other));
    EXPECT_EQ(sectionOf(one, 0), sectionOf(other, 0));
    EXPECT_NE(sectionOf(one, 0), sectionOf(sideBySide({&there, 1}), 0));
  }
}

// Sections that have nothing to do with each other, one of which has no overlap to begin with and stays as it is.
TEST(Parting, PartsEightSectionsSideBySide) {
  const int count = 120;
  const double radius = std::sqrt(count / 0.3);
  for (const HelicalFibres& fibres : {HelicalFibres{1}, HelicalFibres{1, 0.004, {0.8, 1.25}}}) {
    std::vector<DiscCentres> sections;
    for (int lane = 0; lane < 7; ++lane)
      sections.push_back(plySection(FibreLayout::random, count, radius, {1}, 20 + static_cast<uint64_t>(lane)));
    DiscCentres apart;
    for (int i = 0; i < count; ++i) {
      const int column = i % 11, row = i / 11;
      apart.emplace_back(4.0 * column - 20, 4.0 * row - 20);
    }
    sections.push_back(apart);
    SectionLanes lanes = sideBySide(sections);
    Parting parting(fibres);
    EXPECT_GT(parting.sweep(lanes), 1) << "the deepest of all sections";
    for (int sweep = 0; sweep < 400; ++sweep) parting.sweep(lanes);
    for (int lane = 0; lane < 7; ++lane) EXPECT_LT(test::worstOverlap(sectionOf(lanes, lane), fibres), 0.01) << lane;
    EXPECT_EQ(sectionOf(lanes, 7), apart);
  }
}

// Even if neither of both knows which way.
TEST(Parting, PartsTwoInOnePlace) {
  const DiscCentres two{{3, 1}, {3, 1}};
  SectionLanes lanes = sideBySide({&two, 1});
  Parting parting({1});
  EXPECT_DOUBLE_EQ(parting.sweep(lanes), 2);
  EXPECT_NEAR(glm::distance(sectionOf(lanes, 0)[0], sectionOf(lanes, 0)[1]), 2.004, 1e-5);
}

TEST(PackedSection, FillsItsDiscEvenly) {
  // Within a disc of half the area lie half the fibres, within 4 sigma of a uniform scatter (packing makes it less).
  const int count = 600;
  const double radius = std::sqrt(count / 0.55);
  int inside = 0;
  for (const glm::dvec2& p : plySection(FibreLayout::packed, count, radius, {1}, 3))
    inside += glm::length(p) < radius * std::sqrt(0.5);
  EXPECT_NEAR(inside, 300, 4 * std::sqrt(150.0));
}

TEST(RandomSection, IsUniformInTheDisc) {
  // Mean square radius of a uniform disc of radius R is R^2 / 2, of variance R^4 / 12.
  const int count = 2000;
  const double radius = 50, rim = radius - 1;
  double meanSquare = 0;
  for (const glm::dvec2& p : plySection(FibreLayout::random, count, radius, {1}, 9))
    meanSquare += glm::dot(p, p) / count;
  EXPECT_NEAR(meanSquare, rim * rim / 2, 4 * rim * rim / std::sqrt(12.0 * count));
}

TEST(RandomSection, AllowsOverlaps) {
  EXPECT_GT(test::worstOverlap(plySection(FibreLayout::random, 165, std::sqrt(165 / 0.55), {1}, 9), {1}), 0.5);
}

TEST(Section, CentroidIsTheAxis) {
  for (const FibreLayout layout : {FibreLayout::random, FibreLayout::packed}) {
    glm::dvec2 sum(0);
    for (const glm::dvec2& p : plySection(layout, 100, 15, {1}, 5)) sum += p;
    EXPECT_LT(glm::length(sum), 1e-9);
  }
}

TEST(Section, IsAFunctionOfItsSeed) {
  const auto section = [](uint64_t seed) { return plySection(FibreLayout::packed, 60, 11, {1}, seed); };
  EXPECT_EQ(section(1), section(1));
  EXPECT_NE(section(1), section(2));
}

}  // namespace
}  // namespace loomlight
