#include "app/export/handover/side_maps.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "core/base/error.h"
#include "tests/support/scratch_folder.h"
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

/// What lies where on either side: paths need not go on from the fibre that they meet first.
class BothSides : public testing::Test {
 protected:
  static const TileSides& sides() {
    static const TileSides sides = [] {
      Fabric fabric = test::twoSidedCloth();
      fabric.render.samplesPerPixel = 48;  // a hole is small, and either side has noise of its own
      fabric.render.maxDepth = 1;
      return sidesOf(fabric, 96);
    }();
    return sides;
  }
  static size_t pixel(int x, int y) {
    return static_cast<size_t>(y) * static_cast<size_t>(sides().front.tile.width) + static_cast<size_t>(x);
  }
  /// The share of pixels whose yarns differ from what is behind them, of those where neither side has a hole.
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

TEST(SideMaps, TheDarkWarpIsOnTheFaceAndTheWhiteWeftOnTheBack) {
  Fabric fabric = test::twoSidedCloth();
  fabric.render.samplesPerPixel = 8;
  const TileSides sides = sidesOf(fabric, 64);
  EXPECT_LT(meanOf(sides.front.reflected), 0.8 * meanOf(sides.back.reflected));
  // Paths may be walked either way, so beam for beam as much comes through from one side as from the other. What is
  // compared here is the light from a whole hemisphere into one direction, which for unlike sides is alike, not equal.
  const double front = meanOf(sides.front.transmitted), back = meanOf(sides.back.transmitted);
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

/// The slopes of the normals are differences of the pixels on both sides, smoothed across (Sobel), which multiplies
/// each wave of the heights by (1 + cos) / 2. That is nowhere below 0, so neither is the sum over the tile of their
/// products with the plain differences; where yarns rise and fall it is above. Normals lean the other way than slopes
/// rise.
TEST_F(BothSides, NormalsLeanAwayFromHigherGroundToTheRightAndUpThePicture) {
  for (const SideMaps* side : {&sides().front, &sides().back}) {
    const TileMaps& map = side->tile;
    const auto height = [&](int x, int y) {  // the tile goes on beyond its edges
      return map.height_mm[pixel((x + map.width) % map.width, (y + map.height) % map.height)];
    };
    double right = 0, up = 0;
    for (int y = 0; y < map.height; ++y)
      for (int x = 0; x < map.width; ++x) {
        const glm::vec3 normal = map.normal[pixel(x, y)];
        right += normal.x / normal.z * (height(x + 1, y) - height(x - 1, y));
        up += normal.y / normal.z * (height(x, y - 1) - height(x, y + 1));
      }
    EXPECT_LT(right, 0);
    EXPECT_LT(up, 0);
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

/// A map as columns, or as rows: their number, and how to read pixel `along` of line `line`.
struct Lines {
  int count, length;
  std::function<double(int line, int along)> at;
};

/// Mean difference of a line and the next, beyond the last the first.
double stepAfter(int line, const Lines& lines) {
  double sum = 0;
  for (int i = 0; i < lines.length; ++i) sum += std::abs(lines.at((line + 1) % lines.count, i) - lines.at(line, i));
  return sum / lines.length;
}

/// How much larger the step across the seam is than those between the threads within, in their standard deviation: the
/// seam lies between two threads as well.
double seamAmongThreads(const Lines& lines, int threads) {
  double sum = 0, squares = 0;
  for (int thread = 1; thread < threads; ++thread) {
    const double step = stepAfter(static_cast<int>(std::lround(1.0 * thread * lines.count / threads)) - 1, lines);
    sum += step;
    squares += step * step;
  }
  const double mean = sum / (threads - 1), variance = squares / (threads - 1) - mean * mean;
  return (stepAfter(lines.count - 1, lines) - mean) / std::sqrt(variance);
}

/// Beside a deviate of a normal distribution in units of the deviation of a dozen others, four is met once in a
/// thousand; there are some thirty here.
TEST(SideMaps, NoSeamOfEitherSideIsSeenAmongItsThreads) {
  constexpr double kMostDeviations = 4;
  Fabric fabric = test::twoSidedCloth();
  fabric.render.samplesPerPixel = 16;
  const TileExtent extent = tileExtent(fabric);
  const TileSides sides = *tileSides(fabric, extent, 128, 1e9, {});
  for (const SideMaps* side : {&sides.front, &sides.back}) {
    const int width = side->tile.width, height = side->tile.height;
    const auto meets = [&](const char* map, const auto& value) {
      const auto at = [&](int x, int y) {
        return static_cast<double>(value(static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x)));
      };
      const Lines columns{width, height, at};
      const Lines rows{height, width, [&](int line, int along) { return at(along, line); }};
      EXPECT_LE(seamAmongThreads(columns, extent.ends), kMostDeviations) << map << ", columns";
      EXPECT_LE(seamAmongThreads(rows, extent.picks), kMostDeviations) << map << ", rows";
    };
    meets("base", [&](size_t i) { return side->reflected[i].x; });
    meets("transmitted", [&](size_t i) { return side->transmitted[i].x; });
    meets("height", [&](size_t i) { return side->tile.height_mm[i]; });
    meets("normal", [&](size_t i) { return side->tile.normal[i].x; });
    meets("normal, y", [&](size_t i) { return side->tile.normal[i].y; });
    meets("opacity", [&](size_t i) { return side->tile.opacity[i]; });
    // An axis has no ends: with its angle doubled, what turns a little changes a little.
    const auto doubled = [&](size_t i) {
      return glm::vec2(side->along[i].x * side->along[i].x - side->along[i].y * side->along[i].y,
                       2 * side->along[i].x * side->along[i].y);
    };
    meets("along", [&](size_t i) { return doubled(i).x; });
    meets("along, y", [&](size_t i) { return doubled(i).y; });
  }
}

TEST(SideMaps, OfTooLargeATileAreRefusedByTheFabricsName) {
  Fabric fabric = test::twoSidedCloth();
  fabric.name = "Scrim";
  fabric.ends_per_cm = fabric.picks_per_cm = 1;
  EXPECT_THAT(test::messageOf<InputError>([&] { tileSides(fabric, {1200, 1200, false}, 64, 1e9, {}); }),
              testing::StartsWith("Scrim: the tile: drape.width_mm: expected"));
}

TEST(SideMaps, NothingComesOfAStoppedOne) {
  const Fabric fabric = test::twoSidedCloth();
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(tileSides(fabric, tileExtent(fabric, false), 64, 1e9, {stop.get_token(), {}, 0}));
}

}  // namespace
}  // namespace loomlight
