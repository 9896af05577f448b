#include "core/fabric/weave/structures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "core/fabric/weave/jacquard.h"
#include "core/fabric/yarn/derived.h"

namespace loomlight {
namespace {

/// As drawn: top pick first.
std::vector<std::string> picture(const Weave& weave) {
  std::vector<std::string> rows;
  for (int p = weave.picks() - 1; p >= 0; --p) {
    std::string row;
    for (int e = 0; e < weave.ends(); ++e) row += weave.at(p, e) ? '#' : '.';
    rows.push_back(row);
  }
  return rows;
}

using testing::ElementsAre;

TEST(Structures, AsAWeaverDrawsThem) {
  EXPECT_THAT(picture(plainWeave()), ElementsAre(".#", "#."));
  EXPECT_THAT(picture(basket(2, 2)), ElementsAre("..##", "..##", "##..", "##.."));
  EXPECT_THAT(picture(basket(1, 2)), ElementsAre(".#", ".#", "#.", "#."));
  EXPECT_THAT(picture(basket(2, 1)), ElementsAre("..##", "##.."));
  EXPECT_THAT(picture(twill(2, 2)), ElementsAre("#..#", "..##", ".##.", "##..")) << "a Z line climbs to the right";
  EXPECT_THAT(picture(twill(3, 1)), ElementsAre("##.#", "#.##", ".###", "###."));
  EXPECT_THAT(picture(brokenTwill(1)), ElementsAre("..#.", "...#", ".#..", "#..."));
  EXPECT_THAT(picture(satin(5, 2, Face::weft)), ElementsAre("...#.", ".#...", "....#", "..#..", "#...."));
}

TEST(Structures, SlantMirrorsTheTwill) {
  const Weave z = twill(3, 2), s = twill(3, 2, Slant::s);
  for (int p = 0; p < 5; ++p)
    for (int e = 0; e < 5; ++e) EXPECT_EQ(z.warpOver(p, e), s.warpOver(-p, e));
}

TEST(Structures, TwillFloatsAreItsNumbers) {
  for (int over = 1; over <= 6; ++over)
    for (int under = 1; under <= 6; ++under) {
      const Floats f = floats(twill(over, under));
      EXPECT_EQ(f.warpFace, over);
      EXPECT_EQ(f.warpBack, under);
    }
}

TEST(Structures, SatinBindsEveryEndOncePerRepeat) {
  for (int n = 5; n <= 24; ++n)
    for (const int step : satinSteps(n)) {
      const Floats f = floats(satin(n, step));
      EXPECT_EQ(f.warpFace, n - 1);
      EXPECT_EQ(f.warpBack, 1);
      EXPECT_EQ(f.idleEnds + f.idlePicks, 0);
      EXPECT_EQ(binding(satin(n, step, Face::weft)).warpUpCells, n);
    }
}

TEST(Structures, SatinStepsOfTheBooks) {
  EXPECT_TRUE(satinSteps(4).empty());
  EXPECT_TRUE(satinSteps(6).empty());
  EXPECT_THAT(satinSteps(5), ElementsAre(2, 3));
  EXPECT_THAT(satinSteps(8), ElementsAre(3, 5));
  EXPECT_THAT(satinSteps(12), ElementsAre(5, 7));
}

TEST(Structures, HerringboneOpposesItsColoursAtBothBreaks) {
  for (const int over : {1, 2, 3})
    for (const int width : {2, 4, 7, 8, 16}) {
      const Weave weave = herringbone(over, width);
      EXPECT_EQ(weave.ends(), 2 * width);
      for (int p = 0; p < weave.picks(); ++p) {
        EXPECT_NE(weave.at(p, width - 1), weave.at(p, width)) << over << " " << width;
        EXPECT_NE(weave.at(p, 2 * width - 1), weave.at(p, 0)) << over << " " << width;
      }
      EXPECT_EQ(floats(weave).warp(), over);
    }
}

TEST(Structures, PaletteIsNamedAndEveryThreadInterlaces) {
  std::set<std::string> names;
  for (const Structure& structure : structurePalette()) {
    EXPECT_TRUE(names.insert(structure.name).second) << structure.name;
    const Floats f = floats(structure.weave);
    EXPECT_EQ(f.idleEnds + f.idlePicks, 0) << structure.name;
    EXPECT_LE(f.warp(), 7) << structure.name;
  }
}

TEST(Jacquard, HasTheSizeAskedForAndIsReproducible) {
  const Weave weave = damaskJacquard(600, 608);
  EXPECT_EQ(weave.ends(), 600);
  EXPECT_EQ(weave.picks(), 608);
  EXPECT_EQ(weave, damaskJacquard(600, 608));
  EXPECT_EQ(damaskJacquard(8, 8).ends(), 8);
}

TEST(Jacquard, HoldsTogether) {
  // Satin of eight floats over seven; where structures meet a thread may run on from one into the next, not further.
  const Floats f = floats(damaskJacquard(640, 640));
  EXPECT_EQ(f.idleEnds + f.idlePicks, 0);
  EXPECT_GE(f.warpFace, 7);
  EXPECT_LE(f.warp(), 14);
  EXPECT_LE(f.weft(), 14);
}

TEST(Jacquard, ShowsGroundAndFigure) {
  const Weave weave = damaskJacquard(640, 640);
  // Between a quarter and a half of the cloth is figure, which shows the weft.
  const double warp = binding(weave).warpOnFace;
  EXPECT_GT(warp, 0.5);
  EXPECT_LT(warp, 0.8);
}

TEST(Jacquard, FigureIsMirroredAndInHalfDrop) {
  // Warp shown on the face, over 8 x 8 blocks, which hold each structure once.
  const Weave weave = damaskJacquard(640, 640);
  const auto tone = [&](int u, int v) {
    int up = 0;
    for (int p = 0; p < 8; ++p)
      for (int e = 0; e < 8; ++e) up += weave.warpOver(8 * v + p, 8 * u + e);
    return up;
  };
  int mirrored = 0;
  for (int v = 0; v < 80; ++v)
    for (int u = 0; u < 80; ++u) {
      EXPECT_EQ(tone(u, v), tone(u + 40, v + 40));
      mirrored += std::abs(tone(u, v) - tone(79 - u, v)) <= 8;
    }
  EXPECT_GT(mirrored, 6400 * 9 / 10);
}

}  // namespace
}  // namespace loomlight
