#include "core/fabric/yarn/cloth_states.h"

#include <gtest/gtest.h>

namespace loomlight {
namespace {

Fabric shirting() {
  Fabric fabric;
  fabric.ends_per_cm = 42;
  fabric.picks_per_cm = 30;
  return fabric;
}

TEST(ClothStates, KnowNothingBeyondTheClothWhereNothingIsSaid) {
  const ClothStates states = clothStates(shirting(), std::nullopt);
  EXPECT_EQ(states.finished.ends.per_cm, 42);
  EXPECT_EQ(states.finished.picks.per_cm, 30);
  for (const ClothState& state : {states.reed, states.loom, states.washed}) {
    EXPECT_EQ(state.ends.source, SettSource::unknown);
    EXPECT_EQ(state.picks.source, SettSource::unknown);
  }
}

TEST(ClothStates, ThreadsKeepTheirLengthFromTheReedToTheFinishedCloth) {
  // Of weft that is 5 % longer than the cloth is wide, a metre of cloth took 105 cm of the reed.
  const ClothStates states = clothStates(shirting(), Crimps{0.1, 0.05});
  EXPECT_DOUBLE_EQ(states.reed.ends.per_cm, 42 / 1.05);
  EXPECT_DOUBLE_EQ(states.reed.picks.per_cm, 30 / 1.1);
  EXPECT_EQ(states.reed.ends.source, SettSource::crimp);
  EXPECT_DOUBLE_EQ(*reedWidth_cm(shirting(), states, 100), 105);
  EXPECT_NEAR(*shrinkage_percent(states.reed.ends, states.finished.ends), 100 - 100 / 1.05, 1e-12);
  EXPECT_EQ(states.loom.ends.source, SettSource::unknown) << "off the loom cloth lies between the two";
}

TEST(ClothStates, TheReedSaysMoreThanTheCrimp) {
  Fabric fabric = shirting();
  fabric.mill.reed_per_10cm = 190;
  fabric.mill.endsPerDent = {2};
  EXPECT_DOUBLE_EQ(clothStates(fabric, Crimps{0.1, 0.05}).reed.ends.per_cm, 38);
  fabric.mill.endsPerDent = {3, 3, 0};
  const ClothStates states = clothStates(fabric, std::nullopt);
  EXPECT_DOUBLE_EQ(states.reed.ends.per_cm, 38) << "an empty dent takes room";
  EXPECT_EQ(states.reed.ends.source, SettSource::reed);
  EXPECT_EQ(states.reed.picks.source, SettSource::unknown);
}

TEST(ClothStates, SelvedgesTakeRoomInTheReed) {
  Fabric fabric = shirting();
  fabric.mill.reed_per_10cm = 200;
  fabric.mill.selvedgeEnds = 40;
  fabric.mill.selvedgeEndsPerDent = 4;
  // 4200 ends by two in a dent, and 10 dents more on each side, of 20 dents to the cm.
  EXPECT_DOUBLE_EQ(*reedWidth_cm(fabric, clothStates(fabric, std::nullopt), 100), 2100 / 20.0 + 1);
}

/// A cloth that nothing has pressed may shrink in the next wash all the same: 0 % would be a claim.
TEST(ClothStates, NothingIsKnownOfTheWashWhereNobodyHasCounted) {
  Fabric fabric = shirting();
  for (const double press : {0.0, 0.5, 1.0}) {
    fabric.press = press;
    const ClothStates states = clothStates(fabric, Crimps{0.1, 0.05});
    EXPECT_EQ(states.washed.ends.source, SettSource::unknown) << press;
    EXPECT_EQ(states.washed.picks.source, SettSource::unknown) << press;
    EXPECT_EQ(shrinkage_percent(states.finished.ends, states.washed.ends), std::nullopt) << press;
    EXPECT_EQ(shrinkage_percent(states.finished.picks, states.washed.picks), std::nullopt) << press;
  }
}

TEST(ClothStates, TheMillsOwnFiguresComeFirst) {
  Fabric fabric = shirting();
  fabric.mill.washedEnds_per_cm = 43;
  fabric.mill.loomPicks_per_cm = 28;
  const ClothStates states = clothStates(fabric, Crimps{0.1, 0.05});
  EXPECT_EQ(states.washed.ends.source, SettSource::mill);
  EXPECT_EQ(states.washed.ends.per_cm, 43);
  EXPECT_EQ(states.washed.picks.source, SettSource::unknown);
  EXPECT_EQ(states.loom.picks.per_cm, 28);
  EXPECT_EQ(states.loom.ends.source, SettSource::unknown);
}

TEST(ClothStates, WritesWhatIsReckonedOtherwise) {
  EXPECT_EQ(settText({24.54, SettSource::reed}), "24.5");
  EXPECT_EQ(settText({24.54, SettSource::crimp}), "~24.5");
  EXPECT_EQ(settText({}, "-"), "-");
}

TEST(Denting, IsWrittenAndReadAsMillsDo) {
  EXPECT_EQ(dentingFromText("2"), (std::vector<int>{2}));
  EXPECT_EQ(dentingFromText(" 3,3 0 "), (std::vector<int>{3, 3, 0}));
  EXPECT_EQ(dentingText({3, 3, 0}), "3 3 0");
  for (const char* const wrong : {"", "0 0", "2x", "-1", "65", "two", "99999999999"})
    EXPECT_FALSE(dentingFromText(wrong)) << wrong;
}

TEST(Selvedges, AreSaidInOneLine) {
  MillData mill;
  EXPECT_EQ(selvedgeText(mill, "ecru"), "");
  mill.selvedgeEnds = 24;
  mill.selvedgeEndsPerDent = 4;
  mill.selvedgeWeave = "plain";
  EXPECT_EQ(selvedgeText(mill, ""), "24 each side, 4 per dent, plain");
  EXPECT_EQ(selvedgeText(mill, "ecru"), "24 each side, 4 per dent, ecru, plain");
}

}  // namespace
}  // namespace loomlight
