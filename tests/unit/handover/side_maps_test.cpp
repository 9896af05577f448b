#include "app/export/handover/side_maps.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/handover/two_sided_cloth.h"

namespace loomlight {
namespace {

TileSides sidesOf(const Fabric& fabric, int side) {
  return *tileSides(fabric, tileExtent(fabric, false), side, 1e9, {});
}

double meanOf(const std::vector<Rgb>& map) {
  double sum = 0;
  for (const Rgb& value : map) sum += value.x;
  return sum / static_cast<double>(map.size());
}

/// Which yarn a pixel shows behind each of another picture: how often one is the warp where the other is not.
class BothSides : public testing::Test {
 protected:
  static const TileSides& sides() {
    static const TileSides sides = [] {
      Fabric fabric = test::twoSidedCloth();
      fabric.render.samplesPerPixel = 128;  // a hole is small, and either side has noise of its own
      return sidesOf(fabric, 96);
    }();
    return sides;
  }
  static size_t pixel(int x, int y) {
    return static_cast<size_t>(y) * static_cast<size_t>(sides().front.tile.width) + static_cast<size_t>(x);
  }
  /// The share of pixels whose yarns differ, of those where neither side has a hole.
  template <class Behind>
  static double differing(const Behind& behind) {
    const TileMaps &front = sides().front.tile, &back = sides().back.tile;
    int differ = 0, all = 0;
    for (int y = 0; y < front.height; ++y)
      for (int x = 0; x < front.width; ++x) {
        const int a = front.yarn[pixel(x, y)], b = back.yarn[behind(x, y)];
        if (a < 0 || b < 0) continue;
        ++all;
        differ += a != b;
      }
    return static_cast<double>(differ) / all;
  }
};

TEST_F(BothSides, BehindAColumnOfTheFrontLiesItsMirrorImage) {
  const int width = sides().front.tile.width, height = sides().front.tile.height;
  // A hole is one from either side.
  double same = 0, unmirrored = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const float front = sides().front.tile.opacity[pixel(x, y)];
      same += std::abs(front - sides().back.tile.opacity[pixel(width - 1 - x, y)]);
      unmirrored += std::abs(front - sides().back.tile.opacity[pixel(x, y)]);
    }
  EXPECT_LT(same, 0.5 * unmirrored);
  // At a crossing the yarn that is not on the face is on the back.
  const double right = differing([&](int x, int y) { return pixel(width - 1 - x, y); });
  EXPECT_GT(right, differing([&](int x, int y) { return pixel(x, y); }) + 0.05);
  EXPECT_GT(right, differing([&](int x, int y) { return pixel(width - 1 - x, height - 1 - y); }) + 0.05);
}

TEST_F(BothSides, TheDarkWarpIsOnTheFaceAndTheWhiteWeftOnTheBack) {
  EXPECT_LT(meanOf(sides().front.reflected), 0.8 * meanOf(sides().back.reflected));
  // Paths may be walked either way, so beam for beam as much comes through from one side as from the other. What is
  // compared here is the light from a whole hemisphere into one direction, which for unlike sides is alike, not equal.
  const double front = meanOf(sides().front.transmitted), back = meanOf(sides().back.transmitted);
  EXPECT_GT(front, 0.02);
  EXPECT_NEAR(front / back, 1, 0.2);
}

TEST_F(BothSides, HeightsRiseTowardsTheEyeOfEitherSide) {
  for (const SideMaps* side : {&sides().front, &sides().back}) {
    double warp = 0, weft = 0;
    int warps = 0, wefts = 0;
    for (size_t i = 0; i < side->tile.yarn.size(); ++i) {
      if (side->tile.yarn[i] == 0) warp += side->tile.height_mm[i], ++warps;
      if (side->tile.yarn[i] == 1) weft += side->tile.height_mm[i], ++wefts;
    }
    // What is seen of a yarn is above the mid-plane more often than not.
    EXPECT_GT(warp / warps + weft / wefts, 0);
  }
}

TEST_F(BothSides, FibresLieAlongTheirYarnsMirroredOnTheBack) {
  double flatness[2] = {0, 0};  // along x, of warp and weft
  int pixels[2] = {0, 0};
  double frontSlant = 0, backSlant = 0;
  for (const SideMaps* side : {&sides().front, &sides().back})
    for (size_t i = 0; i < side->along.size(); ++i) {
      const glm::vec2 axis = side->along[i];
      EXPECT_GE(axis.x, 0);
      EXPECT_LE(glm::length(axis), 1.0001f);
      if (side->tile.yarn[i] < 0) continue;
      const bool isWarp = side->tile.yarn[i] == 0;
      flatness[side->tile.yarn[i]] += axis.x * axis.x - axis.y * axis.y;
      ++pixels[side->tile.yarn[i]];
      // Twist turns the fibres of the warp off its axis, seen from outside to the same hand on both sides.
      if (isWarp) (side == &sides().front ? frontSlant : backSlant) += axis.x * axis.y;
    }
  EXPECT_LT(flatness[0] / pixels[0], -0.3);
  EXPECT_GT(flatness[1] / pixels[1], 0.3);
  EXPECT_GT(frontSlant * backSlant, 0);
}

TEST(SideMaps, AWhiteClothSendsBackAllThatFallsOnItFromBothSides) {
  Fabric fabric = test::twoSidedCloth();
  fabric.fibres[0].absorption_per_mm = Rgb(0);
  fabric.render.samplesPerPixel = 8;
  const TileSides sides = sidesOf(fabric, 64);
  for (const SideMaps* side : {&sides.front, &sides.back}) {
    double sum = 0, opacity = 0;
    for (size_t i = 0; i < side->reflected.size(); ++i) {
      opacity += side->tile.opacity[i];
      sum += side->tile.opacity[i] * (side->reflected[i].x + side->transmitted[i].x);
      EXPECT_EQ(side->tile.baseColour[i], side->reflected[i] + side->transmitted[i]);
    }
    EXPECT_NEAR(sum / opacity, 1, 0.01);
  }
}

/// Mean difference of a column and the next, beyond the last the first, of what a pixel has.
template <class Value>
double stepAfter(int x, int width, int height, const Value& value) {
  double sum = 0;
  for (int y = 0; y < height; ++y) {
    const auto row = static_cast<size_t>(y) * static_cast<size_t>(width);
    sum += std::abs(value(row + static_cast<size_t>((x + 1) % width)) - value(row + static_cast<size_t>(x)));
  }
  return sum / height;
}

TEST(SideMaps, NoSeamOfEitherSideIsSeenAmongItsColumns) {
  Fabric fabric = test::twoSidedCloth();
  fabric.render.samplesPerPixel = 16;
  const TileSides sides = *tileSides(fabric, tileExtent(fabric), 128, 1e9, {});
  for (const SideMaps* side : {&sides.front, &sides.back}) {
    const auto meets = [&](const char* map, const auto& value) {
      const int width = side->tile.width, height = side->tile.height;
      double largest = 0;
      for (int x = 0; x + 1 < width; ++x) largest = std::max(largest, stepAfter(x, width, height, value));
      EXPECT_LE(stepAfter(width - 1, width, height, value), largest) << map;
    };
    meets("base", [&](size_t i) { return side->reflected[i].x; });
    meets("transmitted", [&](size_t i) { return side->transmitted[i].x; });
    meets("height", [&](size_t i) { return side->tile.height_mm[i]; });
    meets("normal", [&](size_t i) { return side->tile.normal[i].x; });
    meets("opacity", [&](size_t i) { return side->tile.opacity[i]; });
  }
}

TEST(SideMaps, NothingComesOfAStoppedOne) {
  const Fabric fabric = test::twoSidedCloth();
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(tileSides(fabric, tileExtent(fabric, false), 64, 1e9, {stop.get_token(), {}, 0}));
}

}  // namespace
}  // namespace loomlight
