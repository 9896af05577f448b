#include <gtest/gtest.h>

#include <array>
#include <map>
#include <set>
#include <unordered_set>

#include "core/base/random.h"
#include "core/geometry/cloth/cloth_geometry.h"
#include "core/geometry/cloth/weave_changes.h"
#include "tests/unit/geometry/cloths.h"

namespace loomlight {
namespace {

/// What does not depend on where along its yarn the cell lies.
YarnCellKey withoutPhase(YarnCellKey key) {
  key.phase = key.stretch = 0;
  return key;
}

TEST(CellKeys, RepeatUpToThePhase) {
  for (const Fabric& fabric : cloths::all()) {
    SCOPED_TRACE(fabric.name);
    const ClothGeometry cloth(fabric, 100, 100);
    for (const System system : {System::warp, System::weft})
      for (int pick = -5; pick < 12; ++pick)
        for (int end = -5; end < 12; ++end) {
          const YarnCellKey key = withoutPhase(cloth.key(system, pick, end));
          EXPECT_EQ(key, withoutPhase(cloth.key(system, pick + cloth.repeatPicks(), end)));
          EXPECT_EQ(key, withoutPhase(cloth.key(system, pick, end - cloth.repeatEnds())));
          EXPECT_EQ(cloth.place(system, pick, end).phase, cloth.key(system, pick, end).phase);
        }
  }
}

TEST(CellKeys, RepeatIsTheSmallest) {
  Fabric fabric = cloths::plain();
  fabric.weave = Weave({{1, 0, 1, 0}, {0, 1, 0, 1}, {1, 0, 1, 0}, {0, 1, 0, 1}, {1, 0, 1, 0}, {0, 1, 0, 1}});
  fabric.warpSequence = {0, 0, 0};
  const ClothGeometry cloth(fabric, 100, 100);
  EXPECT_EQ(cloth.repeatEnds(), 2);
  EXPECT_EQ(cloth.repeatPicks(), 2);
  const ClothGeometry mixed(cloths::mixed(), 100, 100);
  EXPECT_EQ(mixed.repeatEnds(), 40);
  EXPECT_EQ(mixed.repeatPicks(), 24);
}

TEST(CellKeys, RepeatOfPicksOfDifferentPeriodsIsTheirMultiple) {
  Fabric fabric = cloths::plain();
  fabric.weave = Weave({{1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0}, {1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0}});
  EXPECT_EQ(ClothGeometry(fabric, 10, 10).repeatEnds(), 6);
  fabric.weave = Weave({{1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0}, {1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0}});
  EXPECT_EQ(ClothGeometry(fabric, 10, 10).repeatEnds(), 12);
}

TEST(CellKeys, AreThoseOfTheShapeCodes) {
  for (const Fabric& fabric : cloths::all()) {
    SCOPED_TRACE(fabric.name);
    const ClothGeometry cloth(fabric, 100, 100);
    for (const System system : {System::warp, System::weft})
      for (int across = -3; across < 12; ++across) {
        std::vector<ShapeCode> codes(50);
        cloth.codes().read(system, across, -7, codes);
        if (system == System::warp) {
          std::vector<ShapeCode> ofColumn(50);
          const auto column = [&](int end) { return fabric.weave.columns(end, 1); };
          const auto own = column(across), before = column(across - 1), after = column(across + 1);
          cloth.codes().read(system, across, -7, {own, before, after}, ofColumn);
          EXPECT_EQ(ofColumn, codes);
        }
        for (int i = 0; i < 50; ++i) {
          const bool warp = system == System::warp;
          const YarnCellKey key = warp ? cloth.key(system, i - 7, across) : cloth.key(system, across, i - 7);
          EXPECT_EQ(cloth.shapeKey(system, codes[i]), withoutPhase(key)) << across << " " << i;
        }
      }
  }
}

TEST(ClothGeometry, SharesTheYarnsThatAnEditLeavesAlone) {
  Fabric fabric = cloths::mixed();
  const ClothGeometry before(fabric, 10, 10);
  fabric.weave = cloths::twill22();
  const ClothGeometry woven(fabric, 10, 10, &before);
  EXPECT_EQ(&woven.yarn(System::weft, 1), &before.yarn(System::weft, 1));
  EXPECT_TRUE(woven.differsInWeaveOnly(before));
  EXPECT_TRUE(woven.differsInWeaveOnly(ClothGeometry(fabric, 10, 10)));
  fabric.yarns[1].plyTwist_per_m += 100;
  const ClothGeometry twisted(fabric, 10, 10, &before);
  EXPECT_EQ(&twisted.yarn(System::weft, 0), &before.yarn(System::weft, 0));
  EXPECT_EQ(twisted.yarn(System::weft, 1), ClothGeometry(fabric, 10, 10).yarn(System::weft, 1));
  EXPECT_FALSE(twisted.yarn(System::weft, 1) == before.yarn(System::weft, 1));
  EXPECT_FALSE(twisted.differsInWeaveOnly(before));
  EXPECT_FALSE(woven.differsInWeaveOnly(ClothGeometry(fabric, 10, 11)));
}

/// Whether a map of the shapes of `before` is one of `after`, name by name; their weaves must be the same.
void expectSameShapes(const ClothGeometry& before, const ClothGeometry& after) {
  const auto names = after.yarns().namesOfKinds(before.yarns());
  ASSERT_TRUE(names);
  std::array<std::set<std::pair<size_t, size_t>>, 2> keys;  // numbers of the codes' shapes, before and after
  for (const System system : {System::warp, System::weft}) {
    std::map<uint64_t, size_t> numbersBefore, numbersAfter;
    for (int across = 0; across < 40; ++across) {
      std::vector<ShapeCode> codes(50), codesAfter(50);
      before.codes().read(system, across, 0, codes);
      after.codes().read(system, across, 0, codesAfter);
      for (size_t i = 0; i < codes.size(); ++i) {
        EXPECT_EQ(renamed(system, codes[i], *names), codesAfter[i]);
        const uint64_t keyBefore = hash(before.shapeKey(system, codes[i]));
        const uint64_t keyAfter = hash(after.shapeKey(system, codesAfter[i]));
        keys[static_cast<size_t>(system)].emplace(
            numbersBefore.try_emplace(keyBefore, numbersBefore.size()).first->second,
            numbersAfter.try_emplace(keyAfter, numbersAfter.size()).first->second);
      }
    }
    EXPECT_EQ(keys[static_cast<size_t>(system)].size(), numbersBefore.size());
    EXPECT_EQ(keys[static_cast<size_t>(system)].size(), numbersAfter.size());
  }
}

TEST(ClothGeometry, NamesTheClassesOfAnotherWhereShapesAreGroupedAlike) {
  Fabric fabric = cloths::mixed();
  const ClothGeometry before(fabric, 40, 40);
  Fabric twisted = fabric;
  twisted.yarns[1].plyTwist_per_m += 100;
  twisted.yarns[1].count_tex *= 1.02;  // so little that no float rises to the height of another
  expectSameShapes(before, ClothGeometry(twisted, 50, 30));
  // Another yarn is the first of its class, so all have other numbers.
  Fabric turned = twisted;
  std::reverse(turned.yarns.begin(), turned.yarns.end());
  const auto last = static_cast<int>(turned.yarns.size()) - 1;
  for (int& yarn : turned.warpSequence) yarn = last - yarn;
  for (int& yarn : turned.weftSequence) yarn = last - yarn;
  expectSameShapes(before, ClothGeometry(turned, 40, 40));
}

TEST(ClothGeometry, NamesNoClassesWhereTheyArePartedOrBecomeOne) {
  Fabric fabric = cloths::plain();
  fabric.yarns.push_back(fabric.yarns[0]);
  fabric.warpSequence = {0, 1};
  const ClothGeometry same(fabric, 10, 10);
  fabric.yarns[1].count_tex *= 1.5;
  const ClothGeometry striped(fabric, 10, 10);
  EXPECT_FALSE(striped.yarns().namesOfKinds(same.yarns()));
  EXPECT_FALSE(same.yarns().namesOfKinds(striped.yarns()));
  fabric.warpSequence = {0, 0, 1};
  EXPECT_FALSE(ClothGeometry(fabric, 10, 10).yarns().namesOfKinds(striped.yarns()));
}

// Threads that touch stand equally far aside, however much they are drawn.
TEST(ClothGeometry, NamesNoClassesWhereThreadsComeToTouch) {
  Fabric fabric = cloths::hopsack();
  fabric.ends_per_cm = 36;
  fabric.crowding = 0.2;
  const ClothGeometry apart(fabric, 10, 10);
  fabric.crowding = 0.3;
  EXPECT_TRUE(ClothGeometry(fabric, 10, 10).yarns().namesOfKinds(apart.yarns()));
  fabric.crowding = 3;
  const ClothGeometry touching(fabric, 10, 10);
  EXPECT_FALSE(touching.yarns().namesOfKinds(apart.yarns()));
  EXPECT_FALSE(apart.yarns().namesOfKinds(touching.yarns()));
}

TEST(WeaveChanges, AreThePlacesThatDiffer) {
  const Weave before = Weave().resized(30, 20);
  const Weave after = before.with(3, 29, !before.at(3, 29)).with(17, 0, !before.at(17, 0)).with(5, 5, before.at(5, 5));
  EXPECT_EQ(weaveChanges(before, after, 2), (std::vector<WeaveCrossing>{{3, 29}, {17, 0}}));
  EXPECT_EQ(weaveChanges(before, after, 1), std::nullopt);
  EXPECT_EQ(weaveChanges(before.resized(29, 19), after, 2), (std::vector<WeaveCrossing>{{17, 0}}));
  EXPECT_EQ(weaveChanges(before, after.resized(33, 10), 2), (std::vector<WeaveCrossing>{{3, 29}}));
}

TEST(CellKeys, NeighbouringYarnsAreNotInStep) {
  const ClothGeometry cloth(cloths::plain(), 100, 100);
  const int period = cloth.yarn(System::warp, 0).period;
  std::set<int> steps;
  for (int end = 0; end < 64; ++end)
    steps.insert((cloth.place(System::warp, 0, end + 1).phase - cloth.place(System::warp, 0, end).phase + period) %
                 period);
  EXPECT_EQ(static_cast<int>(steps.size()), period);
}

TEST(CellKeys, ColourAndOpticsAreNotShape) {
  Fabric fabric = cloths::plain();
  Yarn blue = fabric.yarns[0];
  blue.name = "blue";
  blue.fibre = 1;
  Fibre dyed = fabric.fibres[0];
  dyed.name = "blue cotton";
  dyed.absorption_per_mm = Rgb(80, 20, 2);
  dyed.refractiveIndex = 1.6;
  fabric.fibres.push_back(dyed);
  fabric.yarns.push_back(blue);
  fabric.warpSequence = {0, 1, 1};
  const ClothGeometry cloth(fabric, 12, 12);
  EXPECT_EQ(cloth.repeatEnds(), 2);
  EXPECT_EQ(withoutPhase(cloth.key(System::warp, 0, 0)), withoutPhase(cloth.key(System::warp, 0, 2)));
  EXPECT_EQ(cloth.yarnIndex(System::warp, 2), 1);
  EXPECT_EQ(cloth.yarnIndex(System::warp, -1), 1);
  EXPECT_EQ(cloth.yarnIndex(System::warp, -3), 0);
}

TEST(CellKeys, AnEditOfACrossingStaysLocal) {
  Random random(11);
  std::vector<std::vector<uint8_t>> rows(40, std::vector<uint8_t>(40));
  for (auto& row : rows)
    for (uint8_t& cell : row) cell = random.below(2) != 0;
  Fabric fabric = cloths::plain();
  fabric.weave = Weave(rows);
  const ClothGeometry before(fabric, 40, 40);
  fabric.weave = fabric.weave.with(20, 20, !fabric.weave.at(20, 20));
  const ClothGeometry after(fabric, 40, 40);
  EXPECT_EQ(before.yarn(System::warp, 0), after.yarn(System::warp, 0));
  EXPECT_EQ(before.halfThickness_mm(), after.halfThickness_mm());
  int changed = 0;
  for (int pick = 0; pick < 40; ++pick)
    for (int end = 0; end < 40; ++end)
      for (const System system : {System::warp, System::weft}) {
        if (before.key(system, pick, end) == after.key(system, pick, end)) continue;
        ++changed;
        const int across = system == System::warp ? end : pick, along = system == System::warp ? pick : end;
        EXPECT_EQ(across, 20);
        EXPECT_LE(std::abs(along - 20), kCrossingReach);
      }
  EXPECT_GE(changed, 6);
}

TEST(CellKeys, OfAJacquardAreFew) {
  // Five crossings decide, each over or under: any weave whatever has at most 32, one yarn a system.
  Random random(5);
  std::vector<std::vector<uint8_t>> rows(300, std::vector<uint8_t>(300));
  for (auto& row : rows)
    for (uint8_t& cell : row) cell = random.below(3) == 0;
  Fabric fabric = cloths::plain();
  fabric.weave = Weave(rows);
  const ClothGeometry cloth(fabric, 300, 300);
  std::unordered_set<YarnCellKey, YarnCellKeyHash> keys;
  for (int pick = 0; pick < 300; ++pick)
    for (int end = 0; end < 300; ++end) keys.insert(withoutPhase(cloth.key(System::warp, pick, end)));
  EXPECT_LE(keys.size(), 32u);
  EXPECT_GT(keys.size(), 10u);
}

TEST(CellKeys, HashSeparatesThem) {
  const ClothGeometry cloth(cloths::mixed(), 100, 100);
  std::unordered_set<YarnCellKey, YarnCellKeyHash> keys;
  std::set<uint64_t> hashes;
  for (int pick = 0; pick < 48; ++pick)
    for (int end = 0; end < 80; ++end)
      for (const System system : {System::warp, System::weft}) {
        keys.insert(cloth.key(system, pick, end));
        hashes.insert(hash(cloth.key(system, pick, end)));
      }
  EXPECT_EQ(keys.size(), hashes.size());
}

TEST(Measure, CountsTheSegmentsOfARepeat) {
  for (const Fabric& fabric : {cloths::plain(), cloths::pliedSatin()}) {
    SCOPED_TRACE(fabric.name);
    const ClothGeometry cloth(fabric, 100, 100);
    double segments = 0;
    for (const System system : {System::warp, System::weft})
      for (int pick = 0; pick < cloth.repeatPicks(); ++pick)
        for (int end = 0; end < cloth.repeatEnds(); ++end)
          segments += static_cast<double>(cloth.strands(cloth.key(system, pick, end)).segments());
    // Stations beside the cell's ends are cut at differing places by different fibres: a segment a fibre, more or less.
    EXPECT_NEAR(cloth.measure().segmentsPerRepeat / segments, 1, 0.1);
  }
}

}  // namespace
}  // namespace loomlight
