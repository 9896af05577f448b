#include "core/fabric/weave/structure_library.h"

#include <gtest/gtest.h>

#include <numeric>

#include "core/fabric/weave/draft_derivation.h"
#include "core/fabric/yarn/derived.h"

namespace loomlight {
namespace {

MadeStructure made(const std::string& kind, std::vector<int> values) {
  for (const StructureKind& k : structureLibrary())
    if (k.name == kind) {
      EXPECT_EQ(values.size(), k.parameters.size());
      return k.make(values);
    }
  ADD_FAILURE() << "no kind " << kind;
  return {};
}

TEST(StructureLibrary, EveryKindMakesClothThatHoldsTogether) {
  for (const StructureKind& kind : structureLibrary()) {
    // Start values, and each parameter at its ends.
    std::vector<std::vector<int>> cases{kind.startValues()};
    for (size_t i = 0; i < kind.parameters.size(); ++i)
      for (const int value : {kind.parameters[i].min, kind.parameters[i].max}) {
        cases.push_back(kind.startValues());
        cases.back()[i] = value;
      }
    for (const auto& values : cases) {
      const MadeStructure structure = kind.make(values);
      EXPECT_FALSE(structure.name.empty()) << kind.name;
      const Floats f = floats(structure.weave);
      EXPECT_EQ(f.idleEnds, 0) << structure.name;
      EXPECT_EQ(f.idlePicks, 0) << structure.name;
    }
    EXPECT_TRUE(kind.make(kind.startValues()).problem.empty()) << kind.name;
  }
}

TEST(StructureLibrary, TwillsFloatAsTheirFractionSays) {
  for (const auto& [over, under] : {std::pair{2, 2}, {3, 1}, {1, 4}, {5, 3}}) {
    const Weave weave = made("Twill", {over, under, 0}).weave;
    const Floats f = floats(weave);
    EXPECT_EQ(f.warpFace, over);
    EXPECT_EQ(f.warpBack, under);
    EXPECT_EQ(f.weftFace, under);
    EXPECT_EQ(smallestDraft(weave).shafts, over + under);
  }
  EXPECT_EQ(made("Twill", {3, 1, 1}).name, "Twill 3/1 S");
}

TEST(StructureLibrary, ALineClimbsToTheRightForZ) {
  const Weave z = made("Twill", {1, 3, 0}).weave, s = made("Twill", {1, 3, 1}).weave;
  for (int p = 0; p < 8; ++p)
    for (int e = 0; e < 8; ++e) {
      EXPECT_EQ(z.warpOver(p + 1, e + 1), z.warpOver(p, e));
      EXPECT_EQ(s.warpOver(p + 1, e - 1), s.warpOver(p, e));
    }
}

TEST(StructureLibrary, AFancyTwillHasItsRunsAlongTheEndsAndItsStep) {
  const Weave weave = twill({3, 1, 1, 2}, 2, Slant::z);
  EXPECT_EQ(weave.picks(), 7);
  EXPECT_EQ(weave.ends(), 7);
  const std::vector<bool> line{true, true, true, false, true, false, false};
  for (int p = 0; p < 7; ++p) {
    EXPECT_EQ(weave.at(p, 0), line[static_cast<size_t>(p)]);
    for (int e = 0; e < 7; ++e) EXPECT_EQ(weave.warpOver(p + 2, e + 1), weave.warpOver(p, e));
  }
  EXPECT_EQ(twill({2, 2}, 2, Slant::z).ends(), 2);
}

TEST(StructureLibrary, ASatinOnlyTakesMovesThatReachEveryEnd) {
  for (int ends = 5; ends <= 16; ++ends)
    for (int move = 2; move <= 14; ++move) {
      const MadeStructure satin = made("Satin", {ends, move, 0});
      const bool can = move < ends - 1 && std::gcd(move, ends) == 1;
      EXPECT_EQ(satin.problem.empty(), can) << ends << ' ' << move;
      if (can) {
        EXPECT_EQ(floats(satin.weave).warpFace, ends - 1);
      }
    }
  EXPECT_EQ(made("Satin", {6, 2, 0}).problem, "There is no satin of 6 ends.");
  EXPECT_NE(made("Satin", {8, 4, 0}).problem.find("3, 5"), std::string::npos);
}

TEST(StructureLibrary, AShadedSatinRaisesWhatItSays) {
  for (int raised = 1; raised < 8; ++raised)
    EXPECT_EQ(binding(made("Shaded satin", {8, 3, raised}).weave).warpUpCells, 8 * raised);
  EXPECT_EQ(shadedSatin(8, 3, 1), satin(8, 3, Face::weft));
  EXPECT_FALSE(made("Shaded satin", {8, 3, 8}).problem.empty());
}

TEST(StructureLibrary, PointsAndDiamondsTakeTheShaftsOfTheirTwill) {
  EXPECT_EQ(smallestDraft(pointTwill(2, 2)).shafts, 4);
  const Draft point = smallestDraft(pointTwill(1, 3));
  EXPECT_EQ(point.threading, (std::vector<std::vector<int>>{{1}, {2}, {3}, {4}, {3}, {2}}));
  const Draft diamond = smallestDraft(diamondTwill(1, 3));
  EXPECT_EQ(diamond.shafts, 4);
  EXPECT_EQ(diamond.treadles, 4);
  for (int p = 0; p < 6; ++p)
    for (int e = 0; e < 6; ++e) EXPECT_EQ(diamondTwill(1, 3).at(p, e), diamondTwill(1, 3).at(p, (6 - e) % 6));
}

TEST(StructureLibrary, WaffleFloatsGrowByTwo) {
  for (int shafts = 3; shafts <= 8; ++shafts) {
    const Weave weave = waffle(shafts);
    EXPECT_EQ(floats(weave).warpFace, 2 * shafts - 3);
    EXPECT_EQ(smallestDraft(weave).shafts, shafts);
  }
}

TEST(StructureLibrary, CrepeHasShortFloatsOnly) {
  EXPECT_LE(floats(crepe()).warp(), 3);
  EXPECT_LE(floats(crepe()).weft(), 3);
}

TEST(StructureLibrary, OvershotIsWovenOnFourShaftsWithAPlainGround) {
  const Weave weave = overshot(6);
  EXPECT_EQ(smallestDraft(weave).shafts, 4);
  for (int p = 1; p < weave.picks(); p += 2)
    for (int e = 0; e + 1 < weave.ends(); ++e) EXPECT_NE(weave.at(p, e), weave.at(p, e + 1)) << p << ' ' << e;
}

TEST(StructureLibrary, TheClothsOfADoubleClothDoNotMeet) {
  const Weave weave = doubleCloth(2, 2);
  for (int p = 0; p < weave.picks(); ++p)
    for (int e = 0; e < weave.ends(); ++e) {
      if (p % 2 == e % 2) {
        EXPECT_EQ(weave.at(p, e), twill(2, 2).at(p / 2, e / 2));
      } else {
        EXPECT_EQ(weave.at(p, e), p % 2 == 1);
      }
    }
}

TEST(StructureLibrary, AHairlineShowsOneColourAlongEachEnd) {
  // Colour on top: that of the end where the warp is over, that of the pick elsewhere.
  for (const int direction : {0, 1}) {
    const MadeStructure s = made("Hairline", {direction});
    const auto colour = [&](int p, int e) {
      return s.weave.warpOver(p, e) ? s.warpColours[static_cast<size_t>(e % 2)]
                                    : s.weftColours[static_cast<size_t>(p % 2)];
    };
    for (int p = 0; p < 4; ++p)
      for (int e = 0; e < 4; ++e)
        EXPECT_EQ(colour(p, e), direction == 0 ? colour(0, e) : colour(p, 0)) << direction << p << e;
    EXPECT_NE(colour(0, 0), direction == 0 ? colour(0, 1) : colour(1, 0));
  }
}

TEST(StructureLibrary, LogCabinChangesDirectionFromBlockToBlock) {
  const MadeStructure s = made("Log cabin", {4});
  const auto colour = [&](int p, int e) {
    return s.weave.warpOver(p, e) ? s.warpColours[static_cast<size_t>(e % 8)]
                                  : s.weftColours[static_cast<size_t>(p % 8)];
  };
  const bool lengthwise = colour(0, 0) == colour(1, 0);
  EXPECT_NE(colour(0, 4) == colour(1, 4), lengthwise);
  EXPECT_EQ(colour(4, 4) == colour(5, 4), lengthwise);
}

}  // namespace
}  // namespace loomlight
