#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/fabric/model/finish.h"
#include "core/geometry/cloth/cloth_geometry.h"
#include "core/geometry/yarn/flyaways.h"
#include "tests/unit/geometry/cloths.h"

namespace loomlight {
namespace {

constexpr double kNoBudget = 1e9;

YarnGeometry yarnOf(const Fabric& fabric, System system = System::warp) {
  return ClothGeometry(fabric, 4, 4).yarn(system, 0);
}

/// Of many pieces of the yarn, one period each.
std::vector<Flyaway> manyHairs(YarnGeometry yarn, int pieces) {
  std::vector<Flyaway> hairs;
  for (int i = 0; i < pieces; ++i) {
    yarn.seed = static_cast<uint64_t>(i);
    const std::vector<Flyaway> piece = placeFlyaways(yarn, kNoBudget);
    hairs.insert(hairs.end(), piece.begin(), piece.end());
  }
  return hairs;
}

/// Where the yarn lies straight.
SectionScale sectionOf(const YarnGeometry& yarn) {
  return yarn.withinOutline(yarn.usual());
}
/// Of a place in that section, how far from the axis it would be in the round one.
double roundRadius_mm(const YarnGeometry& yarn, const glm::dvec3& p) {
  return std::hypot(p.y / sectionOf(yarn).across, p.z / sectionOf(yarn).up);
}

/// The hair in a cloth that is flat as the yarn lies straight: along it, to its side, up.
glm::dvec3 at(const Flyaway& hair, const YarnGeometry& yarn, double share) {
  const double t = hair.start + (hair.end - hair.start) * (hair.backwards ? 1 - share : share);
  const glm::dvec2 offset = flyawayOffset(hair, yarn, t, {0, 0, 0, sectionOf(yarn)});
  return {t * yarn.cellLength_mm, offset.x, offset.y};
}

double length_mm(const Flyaway& hair, const YarnGeometry& yarn) {
  constexpr int kSteps = 60;
  double length = 0;
  for (int i = 0; i < kSteps; ++i)
    length += glm::length(at(hair, yarn, (i + 1.0) / kSteps) - at(hair, yarn, 1.0 * i / kSteps));
  return length;
}

double lengthOfAll_mm(const std::vector<Flyaway>& hairs, const YarnGeometry& yarn) {
  double sum = 0;
  for (const Flyaway& hair : hairs) sum += length_mm(hair, yarn);
  return sum;
}

Fabric hairy(double hairs_per_mm, double hairLength_mm, double count_tex) {
  Fabric f = cloths::hairy();
  f.yarns[0].hairiness_per_mm = hairs_per_mm;
  f.yarns[0].hairLength_mm = hairLength_mm;
  f.yarns[0].count_tex = count_tex;
  f.ends_per_cm = f.picks_per_cm = 110 / std::sqrt(count_tex);
  return f;
}

TEST(Hairs, AreAsLongInAllAsHairinessSays) {
  constexpr int kPieces = 100;
  for (const double count_tex : {12.0, 30.0, 84.0}) {
    Fabric fabric = hairy(5, 0.5, count_tex);
    YarnGeometry yarn = yarnOf(fabric);
    for (const double diameters : {1.0, 2.0, 4.0}) {  // longer ones are folded to stay near their yarn
      SCOPED_TRACE(testing::Message() << count_tex << " tex, hairs of " << diameters << " diameters");
      yarn.hairLength_mm = fabric.yarns[0].hairLength_mm = diameters * yarn.diameter_mm();
      const std::vector<Flyaway> hairs = manyHairs(yarn, kPieces);
      const double all_mm = lengthOfAll_mm(hairs, yarn);
      const double mean_mm = all_mm / static_cast<double>(hairs.size());
      EXPECT_NEAR(mean_mm / meanHairLength_mm(yarn.hairLength_mm, yarn.diameter_mm()), 1, 0.1);
      const double simulated = all_mm / (kPieces * yarn.period * yarn.cellLength_mm);
      EXPECT_NEAR(simulated / hairinessH(fabric.yarns[0], fabric.fibres[0]), 1, 0.1);
    }
  }
}

TEST(Hairs, LeaveTheYarnAtItsSurface) {
  const YarnGeometry yarn = yarnOf(hairy(6, 0.8, 30));
  const auto radius = [&](const glm::dvec3& p) { return roundRadius_mm(yarn, p) / (0.5 * yarn.diameter_mm()); };
  for (const Flyaway& hair : manyHairs(yarn, 20)) {
    const double root = radius(at(hair, yarn, 0));
    ASSERT_GE(root, 0.59);
    ASSERT_LE(root, 0.96);
    double furthest = 0;
    for (int i = 0; i <= 40; ++i) furthest = std::max(furthest, radius(at(hair, yarn, i / 40.0)));
    ASSERT_GT(furthest, root);
  }
}

TEST(Hairs, LieInAnyDirectionAndOneInFiveStands) {
  const YarnGeometry yarn = yarnOf(hairy(6, 0.4, 30));
  const std::vector<Flyaway> hairs = manyHairs(yarn, 300);
  double ends = 0, standing = 0, lying = 0, faces = 0;
  glm::dvec2 heading(0), twice(0);  // means of the heading, and of its double: 0 where no direction is preferred
  for (const Flyaway& hair : hairs) {
    if (hair.loop) continue;
    ++ends;
    standing += hair.lies ? 0 : 1;
    if (!hair.lies) continue;
    const glm::dvec3 root = at(hair, yarn, 0), tip = at(hair, yarn, 1);
    // It lies on the crowns, up to a few of its own radii above them.
    const double above = std::abs(tip.z) - yarn.halfHeight_mm();
    ASSERT_GT(above, 0);
    ASSERT_LT(above, 7 * yarn.fibreRadius_mm);
    ++lying;
    faces += tip.z > 0 ? 1 : -1;
    const double angle = std::atan2(tip.y - root.y, tip.x - root.x);
    heading += glm::dvec2(std::cos(angle), std::sin(angle));
    twice += glm::dvec2(std::cos(2 * angle), std::sin(2 * angle));
  }
  const double chance = 4 / std::sqrt(lying);  // four standard deviations of a mean of unit vectors
  EXPECT_NEAR(standing / ends, 0.2, 0.4 * chance);
  EXPECT_NEAR(faces / lying, 0, chance);
  EXPECT_LT(glm::length(heading) / lying, chance);
  EXPECT_LT(glm::length(twice) / lying, 0.15);  // roots lie beside the axis, which favours the way across a little
}

TEST(Finish, SingeingLeavesFewAndShortHairsAndTheYarn) {
  Fabric fabric = cloths::hairy();
  const YarnGeometry asWoven = yarnOf(fabric);
  fabric.singed = true;
  YarnGeometry singed = yarnOf(fabric);
  const double before = lengthOfAll_mm(manyHairs(asWoven, 100), asWoven);
  const double after = lengthOfAll_mm(manyHairs(singed, 100), singed);
  EXPECT_LT(after, 0.3 * before);
  EXPECT_GT(after, 0.05 * before);
  EXPECT_NEAR(singed.count_tex / asWoven.count_tex, 1, 1e-12);
  EXPECT_EQ(singed.hairLie, asWoven.hairLie);
  EXPECT_EQ(singed.plyRadius_mm, asWoven.plyRadius_mm);
  EXPECT_EQ(singed.plyTurns, asWoven.plyTurns);
  EXPECT_EQ(singed.pressed, asWoven.pressed);
}

TEST(Finish, BrushingRaisesLongerHairsOnTheFaceOneWay) {
  Fabric fabric = cloths::hairy();
  fabric.press = 0;
  const YarnGeometry asWoven = yarnOf(fabric);
  fabric.brushed = true;
  for (const System system : {System::warp, System::weft}) {
    const YarnGeometry yarn = yarnOf(fabric, system);
    const std::vector<Flyaway> hairs = manyHairs(yarn, 60);
    double ends = 0, along = 0, across = 0, rise = 0;
    for (const Flyaway& hair : hairs) {
      if (hair.loop) continue;
      const glm::dvec3 way = at(hair, yarn, 1) - at(hair, yarn, 0);
      ASSERT_GT(at(hair, yarn, 1).z, yarn.halfHeight_mm());
      ++ends;
      along += system == System::warp ? way.x : -way.y;  // towards the higher picks
      across += system == System::warp ? way.y : way.x;
      rise += way.z;
    }
    EXPECT_GT(along / ends, 0.2);
    EXPECT_LT(std::abs(across / ends), 0.1 * along / ends);
    EXPECT_GT(rise / ends, 0.1);
    EXPECT_GT(lengthOfAll_mm(hairs, yarn), 1.5 * lengthOfAll_mm(manyHairs(asWoven, 60), asWoven));
    EXPECT_EQ(yarn.plyRadius_mm, asWoven.plyRadius_mm);
    EXPECT_EQ(yarn.pressed, asWoven.pressed);
  }
}

TEST(Finish, CalenderingLaysTheLastHair) {
  Fabric fabric = cloths::hairy();
  const auto standing = [&](double press) {
    fabric.press = press;
    const std::vector<Flyaway> hairs = manyHairs(yarnOf(fabric), 50);
    return std::count_if(hairs.begin(), hairs.end(), [](const Flyaway& f) { return !f.loop && !f.lies; });
  };
  EXPECT_GT(standing(0), 0);
  EXPECT_EQ(standing(0.5), standing(0));
  EXPECT_EQ(standing(1), 0);
}

TEST(WrapperFibres, TurnTightlyAroundTheBodyAsOftenAsAsked) {
  Fabric fabric = cloths::hairy();
  fabric.yarns[0].hairiness_per_mm = 0;
  const YarnGeometry without = yarnOf(fabric);
  fabric.yarns[0].wrappers_per_cm = 20;
  const YarnGeometry yarn = yarnOf(fabric);
  EXPECT_EQ(yarn.plyRadius_mm, without.plyRadius_mm);
  EXPECT_EQ(yarn.plyTurns, without.plyTurns);
  constexpr int kPieces = 50;
  const std::vector<Flyaway> wrappers = manyHairs(yarn, kPieces);
  const double wanted = 2 * kPieces * yarn.period * yarn.cellLength_mm;
  EXPECT_NEAR(static_cast<double>(wrappers.size()) / wanted, 1, 0.1);
  const double radius = 0.5 * yarn.diameter_mm();
  for (const Flyaway& wrapper : wrappers) {
    EXPECT_GE(std::abs(wrapper.angleSpan), 2 * kPi);
    for (int i = 0; i <= 20; ++i) {
      const glm::dvec3 p = at(wrapper, yarn, i / 20.0);
      EXPECT_NEAR(roundRadius_mm(yarn, p), radius + yarn.fibreRadius_mm, 0.02 * radius);
    }
  }
}

// What is laid in the cells: as round as it is wound, between stations too.
TEST(WrapperFibres, AreLaidAroundTheYarn) {
  Fabric fabric = cloths::hairy();
  fabric.yarns[0].hairiness_per_mm = 0;
  fabric.yarns[0].wrappers_per_cm = 30;
  const ClothGeometry cloth(fabric, 4, 16);
  size_t pieces = 0;
  for (int pick = 0; pick < 16; ++pick) {
    const YarnCellKey key = cloth.key(System::warp, pick, 0);
    const YarnGeometry& yarn = cloth.yarn(System::warp, key.yarn);
    const CellStrands cell = cloth.strands(key);
    const double core = 0.8 * 0.5 * yarn.diameter_mm() * std::min(key.here.across, key.here.up);
    for (const CellStrands::Strand& strand : cell.strands) {
      if (!strand.loose) continue;
      ++pieces;
      for (uint32_t i = strand.first; i + 1 < strand.first + strand.count; ++i) {
        const glm::vec3 middle = 0.5f * (cell.points[i] + cell.points[i + 1]);
        if (std::abs(middle.y) > 0.1 * yarn.pitch_mm) continue;  // elsewhere the yarn is on its way up or down
        EXPECT_GT(std::hypot(middle.x, middle.z - key.here.height_mm), core);
      }
    }
  }
  EXPECT_GT(pieces, 16u);
}

}  // namespace
}  // namespace loomlight
