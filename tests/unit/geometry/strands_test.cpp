#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <span>

#include "core/geometry/cloth/cloth_geometry.h"
#include "core/geometry/yarn/stations.h"
#include "tests/unit/geometry/cloths.h"
#include "tests/unit/geometry/handedness.h"

namespace loomlight {
namespace {

/// Fibres of a straight yarn: nothing but the twist turns them.
Fabric straightYarn(double plyTwist, TwistDirection ply, int plies, double yarnTwist, TwistDirection yarn) {
  Fabric f = cloths::plain();
  f.weave = Weave(std::vector<std::vector<uint8_t>>{{1}});  // the warp floats over everything
  f.yarns[0].plyTwist_per_m = plyTwist;
  f.yarns[0].plyTwistDirection = ply;
  f.yarns[0].plies = plies;
  f.yarns[0].yarnTwist_per_m = yarnTwist;
  f.yarns[0].yarnTwistDirection = yarn;
  f.yarns[0].flattening = 1;
  return f;
}

TEST(Twist, ZIsRightHandedAndOfTheSizeAsked) {
  for (const TwistDirection direction : {TwistDirection::s, TwistDirection::z}) {
    const ClothGeometry cloth(straightYarn(700, direction, 1, 0, TwistDirection::s), 4, 4);
    const YarnCellKey key = cloth.key(System::warp, 0, 0);
    const double turns_per_mm = handedness(roundStrands(cloth, key), key.here.height_mm);
    const double expected = direction == TwistDirection::z ? 0.7 : -0.7;
    // Met to kTwistTolerance in the tangent at the surface, and by the cell's length against its typical one.
    const YarnGeometry& yarn = cloth.yarn(System::warp, 0);
    const double tolerance =
        kTwistTolerance / (kPi * yarn.diameter_mm()) + 0.7 * (yarn.cellLength_mm / yarn.pitch_mm - 1);
    EXPECT_NEAR(turns_per_mm, expected, tolerance + 0.01);
    EXPECT_EQ(yarn.plyTurns > 0, direction == TwistDirection::z);
  }
}

TEST(Twist, PliesTurnAboutTheYarnTheirOwnWay) {
  const Fabric fabric = straightYarn(0, TwistDirection::z, 2, 500, TwistDirection::s);
  const ClothGeometry cloth(fabric, 4, 4);
  const YarnCellKey key = cloth.key(System::warp, 0, 0);
  EXPECT_LT(handedness(roundStrands(cloth, key), key.here.height_mm), -0.3);
  EXPECT_LT(cloth.yarn(System::warp, 0).yarnTurns, 0);
}

TEST(Twist, BalancedPliesLayTheOuterFibresAlongTheYarn) {
  // Singles Z, two of them plied S with some four fifths of their twist: outermost, the spin of a ply and the swing
  // about the yarn are equal and opposite.
  const Motion outermost = PlyShape(2, 1, false).place(Motion{glm::dvec2(1, 0)}.turning(800));
  const double balance = outermost.velocity.y / outermost.at.x;
  const auto outerSlope = [](double yarnTwist) {
    const Fabric fabric = straightYarn(800, TwistDirection::z, 2, yarnTwist, TwistDirection::s);
    const ClothGeometry cloth(fabric, 4, 4);
    const YarnCellKey key = cloth.key(System::warp, 0, 0);
    const YarnGeometry& yarn = cloth.yarn(System::warp, 0);
    double sum = 0, count = 0;
    const CellStrands cell = roundStrands(cloth, key);
    for (const CellStrands::Strand& strand : cell.strands)
      for (uint32_t i = strand.first; i + 1 < strand.first + strand.count; ++i) {
        const glm::dvec3 p = cell.points[i], d = glm::dvec3(cell.points[i + 1]) - p;
        if (std::hypot(p.x, p.z - key.here.height_mm) < 0.9 * yarn.diameter_mm() / 2) continue;
        sum += std::hypot(d.x, d.z) / d.y;
        ++count;
      }
    return sum / count;
  };
  EXPECT_LT(outerSlope(balance), 0.35 * outerSlope(0));
}

/// The mean place of the points of some singles, by plane of the cell: the axis of what they make.
glm::dvec2 axisAt(const CellStrands& cell, int firstPly, int endPly, bool atEnd) {
  glm::dvec2 sum(0);
  int fibres = 0;
  for (const CellStrands::Strand& strand : cell.strands)
    if (strand.ply >= firstPly && strand.ply < endPly) {
      const glm::vec3 p = cell.points[strand.first + (atEnd ? strand.count - 1 : 0)];
      sum += glm::dvec2(p.z, p.x);
      ++fibres;
    }
  return sum / static_cast<double>(fibres);
}

double turnsBetween(glm::dvec2 from, glm::dvec2 to) {
  return std::atan2(from.x * to.y - from.y * to.x, glm::dot(from, to)) / (2 * kPi);
}

TEST(Twist, CordsPliesAndFibresTurnEachTheirOwnWay) {
  Fabric fabric = straightYarn(240, TwistDirection::z, 2, 150, TwistDirection::s);
  fabric.yarns[0].count_tex = 60;
  fabric.yarns[0].cords = 3;
  fabric.yarns[0].cableTwist_per_m = 90;
  fabric.yarns[0].cableTwistDirection = TwistDirection::z;
  fabric.ends_per_cm = 8;  // room enough to stay round
  const ClothGeometry cloth(fabric, 4, 4);
  const YarnGeometry& yarn = cloth.yarn(System::warp, 0);
  EXPECT_GT(yarn.plyTurns, 0);
  EXPECT_LT(yarn.yarnTurns, 0);
  EXPECT_GT(yarn.cableTurns, 0);

  // How the ply's place in its cord is drawn out by what the cords give way to one another, in the frame of the cord.
  const PlyShape cords = yarn.cordShape(), plies = yarn.plyShape();
  const glm::dvec2 middleOfCord = cords.place(glm::vec2(0));
  const glm::dvec2 drawn(cords.place(glm::vec2(1, 0)).x - middleOfCord.x, cords.place(glm::vec2(0, 1)).y);
  double plyOrbit = 0;  // of the mean of a ply's places, which is not that of its middle
  constexpr int kPlaces = 1000;
  for (int i = 0; i < kPlaces; ++i) {
    const float radius = static_cast<float>(yarn.plyRadius_mm * std::sqrt((i + 0.5) / kPlaces));
    plyOrbit += plies.place(radius * directionOf(i * 618 % kPlaces, kPlaces)).x / kPlaces;
  }
  const YarnCellKey key = cloth.key(System::warp, 0, 0);
  const CellStrands cell = roundStrands(cloth, key);
  const glm::dvec2 middle(key.here.height_mm, 0);
  const double perCell = 1.0 / yarn.period;
  for (int cord = 0; cord < 3; ++cord) {
    const auto cordAt = [&](bool atEnd) { return axisAt(cell, 2 * cord, 2 * cord + 2, atEnd); };
    EXPECT_NEAR(glm::length(cordAt(false) - middle), cords.orbit_mm(), 0.02 * cords.orbit_mm());
    EXPECT_NEAR(turnsBetween(cordAt(false) - middle, cordAt(true) - middle), yarn.cableTurns * perCell, 0.01);
    for (int ply = 2 * cord; ply < 2 * cord + 2; ++ply) {
      const auto plyInCord = [&](bool atEnd) {
        const glm::dvec2 outwards = glm::normalize(cordAt(atEnd) - middle), around(-outwards.y, outwards.x);
        const glm::dvec2 fromCord = axisAt(cell, ply, ply + 1, atEnd) - cordAt(atEnd);
        return glm::dvec2(glm::dot(fromCord, outwards), glm::dot(fromCord, around)) / drawn;
      };
      EXPECT_NEAR(glm::length(plyInCord(false)), plyOrbit, 0.03 * plyOrbit);
      EXPECT_NEAR(turnsBetween(plyInCord(false), plyInCord(true)), yarn.yarnTurns * perCell, 0.01);
    }
  }
}

TEST(Twist, CordsOfSinglesAreAPliedYarn) {
  const Fabric plied = straightYarn(800, TwistDirection::z, 3, 450, TwistDirection::s);
  Fabric corded = straightYarn(800, TwistDirection::z, 1, 0, TwistDirection::s);
  corded.yarns[0].cords = 3;
  corded.yarns[0].cableTwist_per_m = 450;
  corded.yarns[0].cableTwistDirection = TwistDirection::s;
  const ClothGeometry a(plied, 4, 4), b(corded, 4, 4);
  const YarnGeometry &x = a.yarn(System::warp, 0), &y = b.yarn(System::warp, 0);
  EXPECT_EQ(x.fibresPerPly, y.fibresPerPly);
  EXPECT_EQ(x.yarnTurns, y.cableTurns);
  EXPECT_NEAR(x.diameter_mm(), y.diameter_mm(), 1e-12);
  EXPECT_NEAR(x.halfWidth_mm(), y.halfWidth_mm(), 1e-12);
  EXPECT_NEAR(x.fibreRadius_mm / y.fibreRadius_mm, 1, 1e-3) << "take-up by other sections";
}

double distanceToLine(glm::dvec3 p, glm::dvec3 a, glm::dvec3 b) {
  const double t = glm::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
  return glm::distance(p, a + t * (b - a));
}

/// Furthest that any point of one polyline lies from another.
double farthest(std::span<const glm::vec3> points, std::span<const glm::vec3> line) {
  double worst = 0;
  for (const glm::vec3& p : points) {
    double nearest = 1e9;
    for (size_t i = 0; i + 1 < line.size(); ++i) nearest = std::min(nearest, distanceToLine(p, line[i], line[i + 1]));
    worst = std::max(worst, nearest);
  }
  return worst;
}

TEST(Strands, ChordsKeepToTheSagitta) {
  for (const Fabric& fabric : cloths::all()) {
    SCOPED_TRACE(fabric.name);
    const ClothGeometry cloth(fabric, 8, 8);
    for (const System system : {System::warp, System::weft})
      for (int i = 0; i < 2; ++i) {
        const YarnCellKey key = cloth.key(system, i, i);
        const YarnGeometry& geometry = cloth.yarn(system, key.yarn);
        const Yarn& yarn = fabric.yarns[cloth.yarnIndex(system, i)];
        const auto coarse = makeYarnModel(sourceOf(geometry, yarn, fabric.fibres[0]));
        // The same fibres at stations for fibres a hundred times finer: as good as the curves themselves.
        YarnModel fine = *coarse;
        fine.geometry.fibreRadius_mm /= 100;
        // In the middle of a slope: to a slub, and from one side of an uneven sett to the other.
        const bool uneven = coarse->spool != nullptr;
        const CellOfYarn place{uneven ? geometry.period / 2 : key.phase, uneven ? coarse->stretch(2 - i) : Stretch{}};
        const auto lay = [&](const YarnModel& model) {
          return layStrands(model, key.previous, key.here, key.next, place, geometry.pitch_mm);
        };
        const CellStrands chords = lay(*coarse), curves = lay(fine);
        ASSERT_EQ(chords.strands.size(), curves.strands.size());
        EXPECT_GT(curves.points.size(), chords.points.size());
        double worst = 0;
        for (size_t k = 0; k < chords.strands.size(); ++k) {
          const CellStrands::Strand &a = curves.strands[k], &b = chords.strands[k];
          if (a.loose) continue;  // loose fibres are laid more freely
          worst = std::max(worst, farthest({&curves.points[a.first], a.count}, {&chords.points[b.first], b.count}));
        }
        EXPECT_LE(worst, 1.1 * kSagitta * geometry.fibreRadius_mm);
        // And no points are wasted, where fibres are curved all along.
        if (geometry.plyTurns != 0) {
          EXPECT_GE(worst, 0.2 * kSagitta * geometry.fibreRadius_mm);
        }
      }
  }
}

TEST(Strands, StationsAreNoDenserThanTheSagittaNeeds) {
  // A straight monofilament in a float, which nothing presses flat, needs no points but its ends.
  Fabric fabric = straightYarn(0, TwistDirection::z, 1, 0, TwistDirection::s);
  fabric.yarns[0].fibresPerPly = 1;
  const ClothGeometry cloth(fabric, 4, 4);
  const CellStrands cell = cloth.strands(cloth.key(System::warp, 0, 0));
  EXPECT_LE(cell.segments(), 2 * cell.strands.size());
  EXPECT_EQ(cloth.yarn(System::warp, 0).period, 1);
}

TEST(Strands, EqualKeysHaveEqualFibres) {
  const Fabric fabric = cloths::hairy();
  const ClothGeometry cloth(fabric, 64, 64), again(fabric, 64, 64);
  for (int pick = 0; pick < 16; ++pick) {
    const YarnCellKey key = cloth.key(System::weft, pick, 3);
    const CellStrands a = cloth.strands(key), b = again.strands(again.key(System::weft, pick, 3));
    ASSERT_EQ(a.points.size(), b.points.size());
    EXPECT_EQ(0, std::memcmp(a.points.data(), b.points.data(), a.points.size() * sizeof(glm::vec3)));
    EXPECT_EQ(a.fibreRadius_mm, b.fibreRadius_mm);
  }
}

TEST(Strands, StayInTheirCellsAndBetweenTheFaces) {
  for (Fabric fabric : cloths::all()) {
    SCOPED_TRACE(fabric.name);
    fabric.yarns[0].hairiness_per_mm = 10;
    fabric.yarns[0].hairLength_mm = 3;
    const ClothGeometry cloth(fabric, 8, 8);
    for (const System system : {System::warp, System::weft})
      for (int pick = 0; pick < 8; ++pick)
        for (int end = 0; end < 8; ++end) {
          const YarnCellKey key = cloth.key(system, pick, end);
          const YarnGeometry& yarn = cloth.yarn(system, key.yarn);
          const CellStrands cell = cloth.strands(key);
          ASSERT_GE(cell.strands.size(), static_cast<size_t>(yarn.singles() * yarn.fibresPerPly));
          size_t points = 0;
          for (const CellStrands::Strand& strand : cell.strands) {
            ASSERT_GE(strand.count, 2u);
            ASSERT_LT(strand.ply, yarn.singles());
            points += strand.count;
          }
          ASSERT_EQ(points, cell.points.size());
          for (const glm::vec3& p : cell.points) {
            ASSERT_LE(std::abs(p.x), 1.5 * yarn.crossPitch_mm);
            ASSERT_LE(std::abs(p.y), 0.5f * static_cast<float>(yarn.pitch_mm));
            ASSERT_LE(std::abs(p.z), cloth.halfThickness_mm());
          }
        }
  }
}

TEST(Hairs, AreLooseAndReachBeyondTheBody) {
  const ClothGeometry cloth(cloths::hairy(), 16, 16);
  const YarnGeometry& yarn = cloth.yarn(System::warp, 0);
  size_t loose = 0;
  double furthest = 0;
  for (int pick = 0; pick < yarn.period; ++pick) {
    const YarnCellKey key = cloth.key(System::warp, pick, 0);
    const CellStrands cell = cloth.strands(key);
    for (const CellStrands::Strand& strand : cell.strands) {
      if (!strand.loose) continue;
      ++loose;
      for (uint32_t i = strand.first; i < strand.first + strand.count; ++i)
        furthest = std::max<double>(furthest, std::abs(cell.points[i].z - key.here.height_mm));
    }
  }
  // 6 a mm over the period, each in one cell at least.
  EXPECT_GE(loose, static_cast<size_t>(5.5 * yarn.period * yarn.cellLength_mm));
  EXPECT_GT(furthest, yarn.halfHeight_mm() + 0.2);
  EXPECT_LT(furthest, 2 * yarn.halfHeight_mm() + yarn.diameter_mm() + 0.8);
}

TEST(Hairs, NeverOutweighTheYarn) {
  Fabric fabric = cloths::hairy();
  fabric.yarns[0].hairiness_per_mm = 50;
  fabric.yarns[0].hairLength_mm = 3;
  const ClothGeometry cloth(fabric, 16, 16);
  double loose = 0, all = 0;
  for (int pick = 0; pick < cloth.yarn(System::warp, 0).period; ++pick) {
    const CellStrands cell = cloth.strands(cloth.key(System::warp, pick, 0));
    all += cell.length_mm();
    CellStrands hairs;
    hairs.points = cell.points;
    for (const CellStrands::Strand& strand : cell.strands)
      if (strand.loose) hairs.strands.push_back(strand);
    loose += hairs.length_mm();
  }
  EXPECT_LT(loose, 0.4 * all);
  EXPECT_GT(loose, 0.1 * all);
}

}  // namespace
}  // namespace loomlight
