#include "core/geometry/yarn/spool.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <vector>

#include "core/geometry/cloth/cloth_geometry.h"
#include "tests/unit/geometry/cloths.h"
#include "tests/unit/geometry/handedness.h"

namespace loomlight {
namespace {

/// The mass of an end's cells one by one, over that of its count: weighed from the fibres that lie in them.
std::vector<double> massesAlong(const ClothGeometry& cloth, int end, int cells) {
  std::unordered_map<YarnCellKey, double, YarnCellKeyHash> weighed;
  std::vector<double> masses;
  for (int pick = 0; pick < cells; ++pick) {
    const YarnCellKey key = cloth.key(System::warp, pick, end);
    const auto [entry, isNew] = weighed.try_emplace(key);
    if (isNew) {
      const CellStrands cell = cloth.strands(key);
      const YarnGeometry& yarn = cloth.yarn(System::warp, key.yarn);
      const double mass_g =
          cell.length_mm() * kPi * cell.fibreRadius_mm * cell.fibreRadius_mm * yarn.fibreDensity_g_cm3 * 1e-3;
      entry->second = mass_g * 1e6 / (yarn.count_tex * cloth.yarns().axisLength_mm(key));
    }
    masses.push_back(entry->second);
  }
  return masses;
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

/// Coefficient of variation of the mass of pieces of so many cells that lie end to end.
double variationOfPieces(const std::vector<double>& masses, int cells) {
  std::vector<double> pieces;
  for (size_t i = 0; i + static_cast<size_t>(cells) <= masses.size(); i += static_cast<size_t>(cells)) {
    double piece = 0;
    for (int j = 0; j < cells; ++j) piece += masses[i + static_cast<size_t>(j)] / cells;
    pieces.push_back(piece);
  }
  double squares = 0;
  const double middle = mean(pieces);
  for (const double piece : pieces) squares += (piece - middle) * (piece - middle);
  return std::sqrt(squares / static_cast<double>(pieces.size())) / middle;
}

Fabric uneven(double cv_percent, double picks_per_cm) {
  Fabric f = cloths::plain();
  f.picks_per_cm = picks_per_cm;
  f.ends_per_cm = picks_per_cm;
  f.yarns[0].evennessCv_percent = cv_percent;
  return f;
}

/// Cells of as much yarn as a length of it.
int cellsOf(const ClothGeometry& cloth, double length_mm) {
  return static_cast<int>(std::lround(length_mm / cloth.yarn(System::warp, 0).cellLength_mm));
}

TEST(Evenness, AKilometreOfYarnVariesAsAsked) {
  for (const double cv_percent : {8.0, 15.0, 25.0})
    for (const double picks_per_cm : {11.0, 25.0}) {
      SCOPED_TRACE(testing::Message() << cv_percent << " %, " << picks_per_cm << " picks/cm");
      const ClothGeometry cloth(uneven(cv_percent, picks_per_cm), 4, 4);
      const std::vector<double> masses = massesAlong(cloth, 1, cellsOf(cloth, 1e6));
      EXPECT_NEAR(mean(masses), 1, 0.01);
      EXPECT_NEAR(100 * variationOfPieces(masses, cellsOf(cloth, kEvennessCut_mm)), cv_percent, 0.1 * cv_percent);
      // Of independent pieces a decimetre would vary by a fourth of that; long waves are what streaks come of.
      EXPECT_GT(100 * variationOfPieces(masses, cellsOf(cloth, 100)), 0.35 * cv_percent);
    }
}

TEST(Evenness, AThickPlaceHasMoreFibresOfTheYarnsOwnRadius) {
  const ClothGeometry cloth(uneven(25, 20), 40, 40);
  const YarnModel& yarn = cloth.yarns().model(System::warp, 0);
  const YarnGeometry& g = yarn.geometry;
  double least = 1, most = 1;
  for (int end = 0; end < 40; ++end) {
    const YarnCellKey key = cloth.key(System::warp, 5, end);
    const CellStrands cell = cloth.strands(key);
    const double mass_g = cell.fibresEach * cell.length_mm() * g.fibreMass_g_mm();
    const double mass = mass_g * 1e6 / (g.count_tex * cloth.yarns().axisLength_mm(key));
    EXPECT_NEAR(mass, yarn.stretch(key.stretch).massOfCell(key.phase, g.period), 0.001);
    least = std::min(least, mass);
    most = std::max(most, mass);
  }
  EXPECT_LT(least, 0.8);
  EXPECT_GT(most, 1.2);
}

/// A warp that floats over everything, whose fibres turn with the twist alone.
Fabric unevenAndStraight(double cv_percent) {
  Fabric f = uneven(cv_percent, 20);
  f.weave = Weave(std::vector<std::vector<uint8_t>>{{1}});
  f.yarns[0].flattening = 1;
  f.yarns[0].migration = f.yarns[0].fibreDisorder_deg = 0;
  return f;
}

/// Turns per mm of the fibres of a cell, about where they lie: a thick yarn lies further out.
double turnedIn(const ClothGeometry& cloth, const YarnCellKey& key) {
  const CellStrands cell = roundStrands(cloth, key);
  double height_mm = 0;
  for (const glm::vec3& p : cell.points) height_mm += p.z / static_cast<double>(cell.points.size());
  return handedness(cell, height_mm);
}

TEST(Evenness, TwistRunsIntoThinPlaces) {
  const ClothGeometry cloth(unevenAndStraight(20), 4, 4);
  const YarnGeometry& yarn = cloth.yarn(System::warp, 0);
  const YarnModel& model = cloth.yarns().model(System::warp, 0);
  YarnCellKey key = cloth.key(System::warp, 0, 0);
  int mixed = 0;
  for (key.stretch = 0; key.stretch < model.spool->kinds(); ++key.stretch) {
    const Stretch stretch = model.stretch(key.stretch);
    // Of both halves, the cell in the middle left out where there is one: turns and mass.
    double turns[2] = {0, 0}, masses[2] = {0, 0}, all = 0;
    for (key.phase = 0; key.phase < yarn.period; ++key.phase) {
      const double turned = turnedIn(cloth, key);
      all += turned / yarn.period;
      if (2 * key.phase + 1 == yarn.period) continue;
      const int half = 2 * key.phase < yarn.period ? 0 : 1;
      turns[half] += turned;
      masses[half] += stretch.massOfCell(key.phase, yarn.period);
    }
    const double turns_per_mm = yarn.plyTurns / (yarn.period * yarn.pitch_mm);
    EXPECT_NEAR(all, turns_per_mm, 0.01 * turns_per_mm) << "no twist is lost";
    EXPECT_NEAR(turns[0] / turns[1], masses[1] / masses[0], 0.1 * masses[1] / masses[0]);
    mixed += stretch.from != stretch.to;
    if (stretch.from < stretch.to) {
      EXPECT_GT(turns[0], 1.1 * turns[1]);
    }
  }
  EXPECT_EQ(mixed, 2);
}

TEST(Evenness, AKilometreHasTheTwistThatIsAsked) {
  const ClothGeometry cloth(unevenAndStraight(15), 4, 4);
  const YarnGeometry& yarn = cloth.yarn(System::warp, 0);
  std::unordered_map<YarnCellKey, double, YarnCellKeyHash> known;
  double turns = 0, cells = 0;
  for (; cells * yarn.pitch_mm < 1e6; ++cells) {
    const YarnCellKey key = cloth.key(System::warp, static_cast<int>(cells), 1);
    const auto [entry, isNew] = known.try_emplace(key);
    if (isNew) entry->second = turnedIn(cloth, key);
    turns += entry->second;
  }
  const double asked_per_mm = 1e-3 * cloths::plain().yarns[0].plyTwist_per_m;
  EXPECT_NEAR(turns / cells, asked_per_mm, 0.1 * asked_per_mm);
}

TEST(Evenness, ThreadsDiffer) {
  const ClothGeometry cloth(uneven(15, 20), 40, 40);
  const int decimetre = cellsOf(cloth, 100);
  std::vector<double> ends;
  for (int end = 0; end < 200; ++end) ends.push_back(mean(massesAlong(cloth, end, decimetre)));
  EXPECT_GT(variationOfPieces(ends, 1), 0.04);
}

/// Slubs of 40 mm and twice the mass, 5 to a metre.
void expectSlubs(double picks_per_cm) {
  Fabric f = uneven(0, picks_per_cm);
  f.yarns[0].slubs_per_m = 5;
  f.yarns[0].slubLength_mm = 40;
  f.yarns[0].slubRatio = 2;
  const ClothGeometry cloth(f, 4, 4);
  const std::vector<double> masses = massesAlong(cloth, 0, cellsOf(cloth, 2e5));
  EXPECT_NEAR(mean(masses), 1, 0.02);
  const auto [least, most] = std::minmax_element(masses.begin(), masses.end());
  EXPECT_NEAR(*most / *least, 2, 0.02);
  const double half = 0.5 * (*least + *most);
  int slubs = 0, cells = 0;
  for (size_t i = 1; i < masses.size(); ++i) {
    cells += masses[i] > half;
    slubs += masses[i] > half && masses[i - 1] <= half;
  }
  // A thousand slubs come by chance: three standard deviations are a tenth.
  EXPECT_NEAR(slubs, 1000, 100);
  EXPECT_NEAR(cells * cloth.yarn(System::warp, 0).cellLength_mm / slubs, 40, 4);
}

TEST(Evenness, SlubsAreAsManyAndAsLongAndThickAsAsked) {
  expectSlubs(20);
  expectSlubs(4);  // stretches of two centimetres
}

TEST(Evenness, AnEvenYarnHasOneKindOfCells) {
  for (const Fabric& fabric : cloths::all()) {
    const ClothGeometry cloth(fabric, 40, 40);
    const bool uneven = fabric.name == cloths::slubby().name;
    EXPECT_EQ(cloth.yarns().spool(System::weft, cloth.geometryClass(System::weft, 0)) != nullptr, uneven);
    for (int end = 0; end < 40 && !uneven; ++end) EXPECT_EQ(cloth.key(System::warp, 33, end).stretch, 0);
  }
}

TEST(Evenness, FibresStayWhereTheyAreInTheirYarn) {
  // A slider that is dragged must not part all fibres anew: the yarn is the one before but for its spool. Where fibres
  // are parted anew in a sketch, they are not parted at all.
  const auto manyFibres = [](double cv_percent) {
    Fabric f = uneven(cv_percent, 14);
    f.yarns[0].count_tex = 60;
    f.yarns[0].migration = 0.3;
    return f;
  };
  constexpr bool kSketched = true;
  const ClothGeometry before(manyFibres(10), 4, 4), after(manyFibres(20), 4, 4, &before, kSketched);
  ASSERT_TRUE(ClothGeometry(manyFibres(20), 4, 4, nullptr, kSketched).yarns().isSketched());
  EXPECT_FALSE(after.yarns().isSketched());
  const ClothGeometry anew(manyFibres(20), 4, 4);
  for (int pick = 0; pick < 4; ++pick) {
    const YarnCellKey key = anew.key(System::warp, pick, 2);
    EXPECT_EQ(after.key(System::warp, pick, 2), key);
    const CellStrands kept = after.strands(key), laid = anew.strands(key);
    EXPECT_EQ(kept.points, laid.points);
    EXPECT_EQ(kept.fibreRadius_mm, laid.fibreRadius_mm);
    EXPECT_EQ(kept.fibresEach, laid.fibresEach);
  }
}

}  // namespace
}  // namespace loomlight
