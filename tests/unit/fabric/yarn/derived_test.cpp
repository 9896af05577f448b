#include "core/fabric/yarn/derived.h"

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/fabric/model/yarn_count.h"
#include "core/fabric/yarn/long_floats.h"

namespace loomlight {
namespace {

using testing::HasSubstr;

constexpr CountSystem kSystems[] = {CountSystem::tex,    CountSystem::dtex,    CountSystem::denier, CountSystem::metric,
                                    CountSystem::cotton, CountSystem::worsted, CountSystem::linen};

TEST(YarnCount, ConversionsOfTheTrade) {
  EXPECT_NEAR(texFromCount(30, CountSystem::cotton), 19.68, 0.01);
  EXPECT_NEAR(texFromCount(4, CountSystem::cotton), 147.6, 0.05);   // 8/2 cotton
  EXPECT_NEAR(texFromCount(30, CountSystem::metric), 33.33, 0.01);  // 2/60 Nm
  EXPECT_NEAR(texFromCount(21, CountSystem::denier), 2.333, 0.001);
  EXPECT_NEAR(texFromCount(17, CountSystem::dtex), 1.7, 1e-12);
  // Ne * den = 5315
  EXPECT_NEAR(countFromTex(texFromCount(30, CountSystem::cotton), CountSystem::denier) * 30, 5315, 1);
  EXPECT_NEAR(texFromCount(1, CountSystem::worsted), 885.8, 1e-9);
  EXPECT_NEAR(texFromCount(1, CountSystem::linen), 1653.5, 1e-9);
}

TEST(YarnCount, EverySystemGoesThereAndBack) {
  for (const CountSystem system : kSystems)
    for (const double tex : {0.5, 19.7, 5000.0})
      EXPECT_NEAR(texFromCount(countFromTex(tex, system), system) / tex, 1.0, 1e-14) << countUnit(system);
}

TEST(YarnCount, FinenessOfCottonAndBack) {
  Fibre cotton;
  cotton.radius_um = 6;
  cotton.density_g_cm3 = 1.52;
  EXPECT_NEAR(fibreFineness_dtex(cotton), 1.72, 0.005);
  EXPECT_NEAR(fibreRadius_um(fibreFineness_dtex(cotton), 1.52), 6.0, 1e-12);
  // d (um) = 11.28 sqrt(dtex / rho)
  EXPECT_NEAR(2 * fibreRadius_um(1.7, 1.52), 11.28 * std::sqrt(1.7 / 1.52), 0.01);
}

TEST(YarnCount, FollowsFromTheFibresWhereTheyAreCounted) {
  Fibre fibre;
  Yarn yarn;
  yarn.plies = 3;
  yarn.fibresPerPly = 50;
  EXPECT_NEAR(yarnCount_tex(yarn, fibre), 150 * fibreFineness_dtex(fibre) / 10, 1e-12);
  EXPECT_EQ(fibresInYarn(yarn, fibre), 150);
  yarn.fibresPerPly.reset();
  yarn.count_tex = 20;
  EXPECT_EQ(yarnCount_tex(yarn, fibre), 20);
  EXPECT_NEAR(fibresInYarn(yarn, fibre), 200 / fibreFineness_dtex(fibre), 1e-9);
}

TEST(YarnCount, ABlendWeighsAndFillsWhatItsFibresDo) {
  std::vector<Fibre> fibres(2);
  fibres[0].radius_um = 6;
  fibres[0].density_g_cm3 = 1.52;
  fibres[1].radius_um = 10;
  fibres[1].density_g_cm3 = 1.31;
  Yarn yarn;
  yarn.count_tex = 40;
  yarn.blendFibre = 1;
  yarn.blendShare = 0.3;
  const double cotton = 0.7 * 400 / fibreFineness_dtex(fibres[0]), wool = 0.3 * 400 / fibreFineness_dtex(fibres[1]);
  EXPECT_NEAR(blendNumberShare(yarn, fibres), wool / (cotton + wool), 1e-12);
  const Fibre mean = meanFibre(yarn, fibres);
  EXPECT_NEAR(fibresInYarn(yarn, mean), cotton + wool, 1e-9);
  EXPECT_NEAR((cotton + wool) * mean.radius_um * mean.radius_um, cotton * 36 + wool * 100, 1e-6) << "section";
  yarn.blendFibre.reset();
  EXPECT_EQ(meanFibre(yarn, fibres), fibres[0]);
  EXPECT_EQ(blendNumberShare(yarn, fibres), 0);
}

TEST(YarnCount, DiameterOfRingSpunCotton) {
  Fibre cotton;
  Yarn yarn;
  yarn.count_tex = 19.68;
  yarn.packing = 0.60;
  // Peirce: d (mm) = 0.0374 sqrt(T) at packing 0.60.
  EXPECT_NEAR(yarnDiameter_mm(yarn, cotton), 0.0374 * std::sqrt(19.68), 0.002);
  EXPECT_NEAR(yarnDiameter_mm(yarn, cotton), 0.03568 * std::sqrt(19.68 / (1.52 * 0.60)), 1e-4);
}

/// The reference cloth of the trade: Ne 30/1, 76 x 68 to the inch, 5 % crimp both ways.
Fabric printCloth() {
  Fabric fabric;
  fabric.ends_per_cm = 76 / 2.54;
  fabric.picks_per_cm = 68 / 2.54;
  fabric.yarns[0].count_tex = texFromCount(30, CountSystem::cotton);
  return fabric;
}

TEST(Derived, ReferenceClothMassAndCover) {
  const Fabric fabric = printCloth();
  EXPECT_NEAR(arealMass_g_m2(fabric, 0.05, 0.05), 117, 0.5);
  EXPECT_NEAR(arealMass_g_m2(fabric, 0.05, 0.05), 23.25 * (76 * 1.05 / 30 + 68 * 1.05 / 30), 0.1);
  const CoverFactors k = coverFactors(fabric);
  EXPECT_NEAR(k.warp, 13.9, 0.05);
  EXPECT_NEAR(k.weft, 12.4, 0.05);
  EXPECT_NEAR(k.cloth, 20.1, 0.05);
  EXPECT_NEAR(k.fraction, 20.1 / 28, 0.002);
}

TEST(Derived, ClothThatIsClosedGetsNoOpenerWithMoreThreads) {
  Fabric fabric = printCloth();
  fabric.ends_per_cm = 75;  // K1 is 34.8: yarns that lie over each other
  EXPECT_GT(coverFactors(fabric).warp, 28);
  EXPECT_NEAR(coverFactors(fabric).cloth, 28, 1e-9);
  fabric.picks_per_cm = 80;
  EXPECT_NEAR(coverFactors(fabric).cloth, 28, 1e-9);
  EXPECT_NEAR(coverFactors(fabric).fraction, 1, 1e-9);
}

TEST(Derived, SequencesAverageTheirYarns) {
  Fabric fabric = printCloth();
  fabric.yarns.push_back(fabric.yarns[0]);
  fabric.yarns[1].count_tex = 3 * fabric.yarns[0].count_tex;
  fabric.warpSequence = {0, 1};
  EXPECT_NEAR(meanCount_tex(fabric, System::warp), 2 * fabric.yarns[0].count_tex, 1e-9);
  EXPECT_NEAR(meanCount_tex(fabric, System::weft), fabric.yarns[0].count_tex, 1e-9);
}

Weave fromPicture(const std::vector<std::string>& topDown) {
  std::vector<Weave::Row> rows;
  for (auto text = topDown.rbegin(); text != topDown.rend(); ++text) {
    Weave::Row row;
    for (const char c : *text) row.push_back(c == '#');
    rows.push_back(row);
  }
  return Weave(rows);
}

TEST(Floats, OfPlainTwillAndSatin) {
  const Floats plain = floats(Weave());
  EXPECT_EQ(plain.warp(), 1);
  EXPECT_EQ(plain.weft(), 1);
  const Floats twill = floats(fromPicture({"###.", "##.#", "#.##", ".###"}));
  EXPECT_EQ(twill.warpFace, 3);
  EXPECT_EQ(twill.warpBack, 1);
  EXPECT_EQ(twill.weftFace, 1);
  EXPECT_EQ(twill.weftBack, 3);
}

TEST(Floats, RunOnOverTheEdgeOfTheRepeat) {
  // One end: up up down down down up, joined to up up up over the edge.
  const Floats f = floats(fromPicture({"#.", "..", "..", "..", "##", "#."}));
  EXPECT_EQ(f.warpFace, 3);
  EXPECT_EQ(f.warpBack, 5);
}

TEST(Floats, ThreadsThatNeverInterlaceAreCountedApart) {
  const Floats f = floats(fromPicture({"#.#", "#..", "#.#"}));
  EXPECT_EQ(f.idleEnds, 2);
  EXPECT_EQ(f.idlePicks, 0);
  EXPECT_EQ(f.warp(), 2);
  const Floats none = floats(Weave(std::vector<Weave::Row>{{1}}));
  EXPECT_EQ(none.idleEnds, 1);
  EXPECT_EQ(none.idlePicks, 1);
  EXPECT_EQ(none.warp(), 0);
}

TEST(Floats, LengthIsInPitchesOfTheOtherSystem) {
  Fabric fabric;
  fabric.ends_per_cm = 20;
  fabric.picks_per_cm = 10;
  EXPECT_DOUBLE_EQ(floatLength_mm(fabric, System::warp, 5), 5.0);
  EXPECT_DOUBLE_EQ(floatLength_mm(fabric, System::weft, 5), 2.5);
}

TEST(Binding, CountsSidesAndChanges) {
  const Binding plain = binding(Weave());
  EXPECT_EQ(plain.warpUpCells, 2);
  EXPECT_EQ(plain.warpInterlacings, 4);
  EXPECT_EQ(plain.weftInterlacings, 4);
  const Binding twill = binding(fromPicture({"###.", "##.#", "#.##", ".###"}));
  EXPECT_EQ(twill.warpUpCells, 12);
  EXPECT_DOUBLE_EQ(twill.warpOnFace, 0.75);
  EXPECT_EQ(twill.warpInterlacings, 8);
  EXPECT_EQ(twill.weftInterlacings, 8);
}

TEST(Jamming, SquarePlainClothJamsAtPeircesPitch) {
  // Equal round yarns: both terms 1/2 when p = D sqrt(3)/2 with D = 2 d.
  Fabric fabric = printCloth();
  const double d = yarnDiameter_mm(fabric.yarns[0], fabric.fibres[0]);
  const double pitch = 2 * d * std::sqrt(3.0) / 2;
  fabric.ends_per_cm = fabric.picks_per_cm = 10 / pitch;
  EXPECT_NEAR(jamming(fabric), 1.0, 1e-9);
  fabric.ends_per_cm = fabric.picks_per_cm = 10 / (2 * d);
  EXPECT_NEAR(jamming(fabric), 0.0, 1e-6);
}

TEST(Jamming, FloatsLeaveRoomForCloserSetts) {
  Fabric plain = printCloth();
  plain.ends_per_cm = plain.picks_per_cm = 36;
  Fabric twill = plain;
  twill.weave = fromPicture({"##..", "#..#", "..##", ".##."});
  EXPECT_LT(jamming(twill), jamming(plain));
}

/// Ends of a twill that do not even fit side by side are jammed, however far apart its picks are.
TEST(Jamming, EndsThatHaveNoRoomSideBySideAreJammed) {
  Fabric twill = printCloth();
  twill.weave = fromPicture({"##..", "#..#", "..##", ".##."});
  const double d = yarnDiameter_mm(twill.yarns[0], twill.fibres[0]);
  twill.picks_per_cm = 10 / (4 * d);
  twill.ends_per_cm = 10 / (0.75 * d);
  EXPECT_LE(jamming(twill), 1) << "with room for the picks between them they are dense";
  twill.ends_per_cm = 10 / (0.45 * d);
  EXPECT_GT(jamming(twill), 1);
}

std::vector<std::string> warningsOf(const Fabric& fabric, double floatLimit_mm = kUsualFloatLimit_mm) {
  return warnings(fabric, floats(fabric.weave), longFloats(fabric, floatLimit_mm));
}

TEST(Warnings, NoneForTheReferenceCloth) {
  EXPECT_TRUE(warningsOf(printCloth()).empty());
}

TEST(Warnings, SaySlubsThatFindNoRoom) {
  Fabric slubby = printCloth();
  slubby.yarns[0].slubs_per_m = 20;
  slubby.yarns[0].slubLength_mm = 30;
  EXPECT_TRUE(warningsOf(slubby).empty());
  slubby.yarns[0].slubs_per_m = 40;
  EXPECT_THAT(warningsOf(slubby), testing::ElementsAre(HasSubstr("40 slubs per m of 30 mm are 120 % of their yarn")));
  slubby.yarns[0].fibresPerPly = 1;
  EXPECT_TRUE(warningsOf(slubby).empty()) << "a monofilament is drawn without slubs";
}

TEST(YarnCount, FibresLaidAtRandomVaryByTheRootOfTheirNumber) {
  Yarn yarn;
  Fibre fibre;
  yarn.fibresPerPly = 100;
  EXPECT_NEAR(limitCv_percent(yarn, fibre), 10.6, 1e-9);
  yarn.plies = 2;
  EXPECT_NEAR(limitCv_percent(yarn, fibre), 10.6 / std::sqrt(2.0), 1e-9) << "plies are uneven each in its own way";
  fibre.scaleTilt_deg = 2.5;
  EXPECT_NEAR(limitCv_percent(yarn, fibre), 11.2 / std::sqrt(2.0), 1e-9) << "hair varies more in thickness";
}

TEST(Warnings, SayYarnsThatAreMoreEvenThanChance) {
  Fabric fabric = printCloth();
  Yarn& yarn = fabric.yarns[0];
  yarn.fibresPerPly = 100;
  yarn.evennessCv_percent = 10.5;
  EXPECT_TRUE(warningsOf(fabric).empty()) << "filament is as even as it is drawn";
  yarn.migration = 0.25;
  const std::string tooEven = fmt::format(
      "A CVm of 10.5 % is more even than a spun yarn of {:.1f} tex can be: its 100 fibres, laid at random, have 10.6 "
      "%.",
      yarnCount_tex(yarn, fabric.fibres[0]));
  EXPECT_THAT(warningsOf(fabric), testing::ElementsAre(tooEven));
  fabric.yarns.push_back(yarn);
  EXPECT_THAT(warningsOf(fabric), testing::ElementsAre(tooEven)) << "once for yarns that are alike";
  for (Yarn& each : fabric.yarns) each.evennessCv_percent = 10.7;
  EXPECT_TRUE(warningsOf(fabric).empty());
  for (Yarn& each : fabric.yarns) each.evennessCv_percent = 0;
  EXPECT_TRUE(warningsOf(fabric).empty()) << "0 asks for an even yarn";
}

/// The count is that of the list of floats: those that nothing binds are among them.
TEST(Warnings, CountFloatsAsTheListDoes) {
  Fabric loose = printCloth();
  loose.ends_per_cm = loose.picks_per_cm = 4;
  loose.weave =
      fromPicture({"..#######", "..######.", "..#####.#", "..####.##", "..###.###", "..##.####", "..#.#####"});
  EXPECT_THAT(warningsOf(loose), testing::Contains(testing::StartsWith(fmt::format(
                                     "{} floats of a repeat are longer than 4 mm, {} without end, the others up to ",
                                     longFloats(loose, 4).count, floats(loose.weave).idleEnds))));
}

TEST(Warnings, NameJammedSettLongFloatsAndIdleThreads) {
  Fabric jammed = printCloth();
  jammed.ends_per_cm = jammed.picks_per_cm = 60;
  EXPECT_THAT(warningsOf(jammed), testing::Contains(HasSubstr("jammed")));

  Fabric loose = printCloth();
  loose.ends_per_cm = loose.picks_per_cm = 4;
  loose.weave =
      fromPicture({".#######", "#######.", "######.#", "#####.##", "####.###", "###.####", "##.#####", "#.######"});
  EXPECT_THAT(warningsOf(loose),
              testing::Contains(HasSubstr("16 floats of a repeat are longer than 4 mm, up to 17.5 mm")));
  EXPECT_THAT(warningsOf(loose, 17.5), testing::IsEmpty()) << "the limit is the one that is set, and no other";

  Fabric idle = printCloth();
  idle.weave = fromPicture({"#.#", "#..", "#.#"});
  EXPECT_THAT(warningsOf(idle),
              testing::ElementsAre("2 of 3 ends of the repeat never interlace: nothing holds them in the cloth."));
  idle.weave = fromPicture({"#.#", "#.#"});
  EXPECT_EQ(warningsOf(idle).size(), 1u);
}

TEST(CrossingShape, IsThatOfTheSett) {
  Fabric fabric = printCloth();
  fabric.ends_per_cm = 30;
  fabric.picks_per_cm = 20;
  EXPECT_EQ(crossingShape(fabric).width, 1);
  EXPECT_EQ(crossingShape(fabric).height, 1.5);
  std::swap(fabric.ends_per_cm, fabric.picks_per_cm);
  EXPECT_EQ(crossingShape(fabric).width, 1.5);
  EXPECT_EQ(crossingShape(fabric).height, 1);
  fabric.picks_per_cm = 2000;
  EXPECT_EQ(crossingShape(fabric).width, 8) << "flatter ones cannot be drawn";
}

}  // namespace
}  // namespace loomlight
