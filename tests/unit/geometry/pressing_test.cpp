#include "core/geometry/yarn/pressing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/fabric/model/finish.h"
#include "core/geometry/cloth/cloth_geometry.h"
#include "tests/unit/geometry/cloths.h"

namespace loomlight {
namespace {

TEST(Pressing, LeavesAirBetweenTheFibres) {
  // Disordered threads cannot be packed closer than 0.82; a pressed yarn is nowhere closer than 0.8.
  for (const double press : {0.0, 0.3, 0.5, 1.0})
    for (const double packing : {0.05, 0.4, 0.5, 0.55, 0.6, 0.7, 0.85})
      for (int state = 0; state < kFloatStates; ++state) {
        const SectionOutline section = yieldingOf(press, packing, state).section;
        EXPECT_LT(packingAtCrossings(packing) / (section.up * section.across), 0.8) << press << " " << packing;
      }
}

TEST(Pressing, FeltedYarnsSwellAtTheirCrossings) {
  for (const double packing : {0.1, 0.3, 0.45}) {
    double before = packingAtCrossings(packing);
    for (const double felting : {0.25, 0.5, 0.75, 1.0}) {
      EXPECT_LT(packingAtCrossings(packing, felting), before) << packing << " " << felting;
      before = packingAtCrossings(packing, felting);
    }
    EXPECT_NEAR(before, packing, 1e-12) << "as open as between crossings";
  }
  for (const double packing : {0.5, 0.6, 0.7, 0.85})
    EXPECT_EQ(packingAtCrossings(packing, 1), packingAtCrossings(packing)) << "nothing is closed by milling";
}

TEST(Pressing, YarnsLieNoNearerThanTheyAreHigh) {
  for (const double press : {0.0, 0.5, 1.0})
    for (const double packing : {0.5, 0.6, 0.7})
      for (int state = 0; state < kFloatStates; ++state) {
        const Yielding yielding = yieldingOf(press, packing, state);
        EXPECT_GE(yielding.apart, yielding.section.up);
      }
}

TEST(Pressing, FlattensMoreTheMoreItIsPressedAndTheMoreYarnsBend) {
  for (int state = 0; state < kFloatStates; ++state)
    for (const double press : {0.1, 0.4, 0.6, 0.9})
      EXPECT_GT(yieldingOf(press - 0.1, 0.5, state).section.up, yieldingOf(press, 0.5, state).section.up);
  for (int state = 1; state < kFloatStates; ++state)
    EXPECT_GT(yieldingOf(0.5, 0.5, state).section.up, yieldingOf(0.5, 0.5, state - 1).section.up);
}

// Slopes and bends by differences of a hundredth are below the second derivative's bound times that.
TEST(SectionEasing, KeepsItsBounds) {
  const SectionEasing<SectionOutline> easing({0.65, 1.16}, {0.75, 1.03}, {0.92, 0.97});
  double slope = 0, bend = 0;
  for (int i = 1; i < 100; ++i) {
    const SectionOutline before = easing.at(0.01 * (i - 1)), here = easing.at(0.01 * i),
                         after = easing.at(0.01 * (i + 1));
    slope = std::max({slope, 50 * std::abs(after.up - before.up), 50 * std::abs(after.across - before.across)});
    bend = std::max({bend, 1e4 * std::abs(after.up - 2 * here.up + before.up),
                     1e4 * std::abs(after.across - 2 * here.across + before.across)});
  }
  EXPECT_LE(slope, easing.slope());
  EXPECT_LE(bend, easing.bend());
  EXPECT_GT(slope, 0.4 * easing.slope());
  EXPECT_GT(bend, 0.4 * easing.bend());
}

TEST(PressedYarn, AMonofilamentStaysRound) {
  Fabric fabric = cloths::plain();
  fabric.picks_per_cm = fabric.ends_per_cm;
  fabric.yarns[0].fibresPerPly = 1;
  fabric.fibres[0].radius_um = 100;
  const ClothGeometry cloth(fabric, 4, 4);
  EXPECT_NEAR(cloth.measure().thickness_mm, 0.4, 1e-6);  // two diameters
  const YarnCellKey key = cloth.key(System::warp, 0, 0);
  EXPECT_EQ(key.here.up, 1);
  EXPECT_EQ(key.here.across, 1);
}

TEST(PressedYarn, FlatteningWidensAndLowers) {
  Fabric fabric = cloths::plain();
  fabric.ends_per_cm = fabric.picks_per_cm = 12;
  const YarnGeometry usual = ClothGeometry(fabric, 4, 4).yarn(System::warp, 0);
  fabric.yarns[0].flattening = 2.4;
  const YarnGeometry flat = ClothGeometry(fabric, 4, 4).yarn(System::warp, 0);
  EXPECT_NEAR(flat.halfWidth_mm() / usual.halfWidth_mm(), std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(flat.halfHeight_mm() * flat.halfWidth_mm(), usual.halfHeight_mm() * usual.halfWidth_mm(), 1e-9);
}

// Milling changes neither setts nor counts, so mass changes only with crimp. Sections grow as the packing falls, and
// reach into the gaps between the yarns.
TEST(MilledCloth, IsThickerAndCoversMoreAndWeighsWhatItsYarnsDo) {
  Fabric fabric = cloths::twill();
  fabric.ends_per_cm = fabric.picks_per_cm = 12;
  fabric.yarns[0].packing = 0.4;
  fabric.yarns[0].hairiness_per_mm = 8;
  const auto straightMass = [](const ClothMeasures& of) {
    return of.arealMass_g_m2 / (2 + of.crimpWarp + of.crimpWeft);
  };
  const ClothGeometry clear(fabric, 4, 4);
  const YarnGeometry& clearYarn = clear.yarn(System::warp, 0);
  const double halfPitch_mm = 0.5 * 10 / 12;
  ASSERT_LT(1.3 * clearYarn.halfWidth_mm(), halfPitch_mm) << "there are gaps, however loose the yarns";
  ClothMeasures before = clear.measure();
  for (const double milling : {0.3, 0.6, 1.0}) {
    fabric.milling = milling;
    const ClothGeometry milled(fabric, 4, 4);
    const ClothMeasures measures = milled.measure();
    EXPECT_GT(measures.thickness_mm, before.thickness_mm) << milling;
    EXPECT_GT(measures.cover, before.cover) << milling;
    EXPECT_NEAR(straightMass(measures) / straightMass(before), 1, 0.001) << milling;
    const double packing = packingAtCrossings(withFinish(fabric.yarns[0], fabric).packing, milling);
    const double looser = std::sqrt(packingAtCrossings(0.4) / packing);
    const YarnGeometry& yarn = milled.yarn(System::warp, 0);
    EXPECT_NEAR(yarn.halfHeight_mm(), looser * clearYarn.halfHeight_mm(), 1e-9) << milling;
    const double apart_mm = halfPitch_mm - looser * clearYarn.halfWidth_mm();
    EXPECT_NEAR(halfPitch_mm - yarn.halfWidth_mm(), (1 - milling) * apart_mm, 1e-9) << milling;
    const auto freeApart_mm = [&](const SectionOutline& free) { return halfPitch_mm - free.across * yarn.radius_mm; };
    EXPECT_NEAR(freeApart_mm(yarn.free), (1 - milling) * freeApart_mm(clearYarn.free), 1e-9) << milling;
    before = measures;
  }
}

}  // namespace
}  // namespace loomlight
