#include "core/geometry/yarn/ply_shape.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/random.h"
#include "core/geometry/yarn/turning.h"

namespace loomlight {
namespace {

constexpr double kRadius = 0.07;

glm::dvec2 placed(const PlyShape& shape, glm::dvec2 inPly) {
  return shape.place(Motion{inPly}).at;
}

/// Calls visit(place) with places spread over the round ply.
template <class Visit>
void forEachPlace(const Visit& visit) {
  Random random(7);
  for (int i = 0; i < 2000; ++i) {
    const double radius = kRadius * std::sqrt(random.uniformDouble()), angle = 2 * kPi * random.uniformDouble();
    visit(radius * glm::dvec2(std::cos(angle), std::sin(angle)));
  }
}

TEST(PlyShape, OfASingleLeavesPlacesAsTheyAre) {
  const PlyShape shape(1, kRadius, false);
  EXPECT_EQ(shape.place(glm::vec2(0.03f, -0.05f)), glm::vec2(0.03f, -0.05f));
  EXPECT_EQ(shape.reach_mm(0.05), 0.05);
  EXPECT_EQ(shape.silhouette_mm(0.05), 0.05);
}

TEST(PlyShape, PlacesWhatMovesWhereItPlacesWhatRests) {
  for (const bool areWires : {false, true})
    for (int plies = 2; plies <= 8; ++plies) {
      const PlyShape shape(plies, kRadius, areWires);
      forEachPlace([&](glm::dvec2 p) {
        EXPECT_LT(glm::distance(placed(shape, p), glm::dvec2(shape.place(glm::vec2(p)))), 1e-6 * kRadius);
      });
    }
}

TEST(PlyShape, KeepsAreas) {
  constexpr double kStep = 1e-4 * kRadius;
  for (int plies = 2; plies <= 8; ++plies) {
    const PlyShape shape(plies, kRadius, false);
    forEachPlace([&](glm::dvec2 p) {
      const glm::dvec2 x = placed(shape, p + glm::dvec2(kStep, 0)) - placed(shape, p - glm::dvec2(kStep, 0));
      const glm::dvec2 y = placed(shape, p + glm::dvec2(0, kStep)) - placed(shape, p - glm::dvec2(0, kStep));
      EXPECT_NEAR((x.x * y.y - x.y * y.x) / (4 * kStep * kStep), 1, 1e-6) << plies;
    });
  }
}

// Nothing of a ply lies beyond the planes that part it from those beside.
TEST(PlyShape, PliesTouchAndDoNotRunThroughOneAnother) {
  for (const bool areWires : {false, true})
    for (int plies = 2; plies <= 8; ++plies) {
      const PlyShape shape(plies, kRadius, areWires);
      double least = kRadius;
      forEachPlace([&](glm::dvec2 p) {
        const glm::dvec2 at = placed(shape, p);
        const double half = kPi / plies;
        least = std::min(least, at.x * std::sin(half) - std::abs(at.y) * std::cos(half));
      });
      EXPECT_GT(least, -1e-6 * kRadius) << plies;
      EXPECT_LT(least, 0.05 * kRadius) << plies;
    }
}

// Yarns of plies that flatten lie between those of round plies and a single of all their fibres.
TEST(PlyShape, PliesThatGiveWayAreSmallerThanRoundOnes) {
  for (int plies = 2; plies <= 8; ++plies) {
    const PlyShape shape(plies, kRadius, false), round(plies, kRadius, true);
    EXPECT_LE(shape.reach_mm(kRadius), round.reach_mm(kRadius)) << plies;
    EXPECT_LE(shape.silhouette_mm(kRadius), round.silhouette_mm(kRadius)) << plies;
    EXPECT_GT(shape.silhouette_mm(kRadius), std::sqrt(static_cast<double>(plies)) * kRadius) << plies;
    EXPECT_LT(shape.silhouette_mm(kRadius), shape.reach_mm(kRadius)) << plies;
  }
  EXPECT_LT(PlyShape(2, kRadius, false).silhouette_mm(kRadius), 1.03 * std::sqrt(2.0) * kRadius);
}

// Circles side by side, seen from a side as they turn: a radius, and the mean of what the middle of the topmost of n
// stands up, which is n / pi sin(pi / n) of the orbit.
TEST(PlyShape, OfWiresIsSeenAsWideAsCirclesAre) {
  for (int plies = 2; plies <= 8; ++plies)
    EXPECT_NEAR(PlyShape(plies, kRadius, true).silhouette_mm(kRadius), (1 + plies / kPi) * kRadius, 0.005 * kRadius);
}

// The side that faces the other ply is flat over most of its width, where an ellipse would leave a gap.
TEST(PlyShape, LeavesNoGapBetweenTwo) {
  const PlyShape shape(2, kRadius, false);
  for (const double share : {0.0, 0.3, 0.6}) {
    const glm::dvec2 inner(-std::sqrt(1 - share * share) * kRadius, share * kRadius);
    EXPECT_LT(placed(shape, inner).x, 0.03 * kRadius) << share;
  }
}

TEST(PlyShape, MovesAsItsPlacesDo) {
  constexpr double kStep = 1e-4;
  for (const int plies : {2, 3}) {
    const PlyShape shape(plies, kRadius, false);
    // A fibre that turns in its ply, which turns the other way: as the motion says, and place by place.
    const glm::dvec2 start(0.05, 0.02);
    const Motion motion = shape.place(Motion{start}.turning(3)).turning(-2);
    const auto placeAt = [&](double t) {
      const auto direction = [](double angle) { return glm::dvec2(std::cos(angle), std::sin(angle)); };
      return turned(direction(-2 * t), placed(shape, turned(direction(3 * t), start)));
    };
    const glm::dvec2 velocity = (placeAt(kStep) - placeAt(-kStep)) / (2 * kStep);
    const glm::dvec2 acceleration = (placeAt(kStep) - 2.0 * placeAt(0) + placeAt(-kStep)) / (kStep * kStep);
    EXPECT_LT(glm::length(motion.velocity - velocity), 1e-6);
    EXPECT_LT(glm::length(motion.acceleration - acceleration), 1e-5);
  }
}

TEST(PlyShape, StretchesNoMoreThanItSays) {
  constexpr double kStep = 1e-4 * kRadius;
  for (const int plies : {2, 4}) {
    const PlyShape shape(plies, kRadius, false);
    const double most = shape.stretch(kRadius);
    double found = 0;
    forEachPlace([&](glm::dvec2 p) {
      for (int i = 0; i < 16; ++i) {
        const glm::dvec2 step = kStep * glm::dvec2(directionOf(i, 32));
        found = std::max(found, glm::distance(placed(shape, p + step), placed(shape, p - step)) / (2 * kStep));
      }
    });
    EXPECT_LT(found, most + 1e-6) << plies;
    EXPECT_GT(found, 0.95 * most) << plies;
  }
}

}  // namespace
}  // namespace loomlight
