#include "render/bvdf/bake/bvdf_baker.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/fabric/model/finish.h"
#include "render/bvdf/bake/bvdf_patch.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_cloth.h"

namespace loomlight {
namespace {

constexpr BvdfResolution kCoarse{4, 4, 8, 16};
const BvdfCache kNoCache{std::filesystem::path()};

/// Two kinds of yarn, one of them in two colours: cheap to bake.
Fabric stripes() {
  Fabric fabric = test::whiteCotton();
  fabric.fibres.push_back(fabric.fibres[0]);
  fabric.fibres[1].absorption_per_mm = Rgb(10, 20, 30);
  fabric.yarns.resize(3, fabric.yarns[0]);
  fabric.yarns[1].fibre = 1;
  fabric.yarns[2].count_tex = 10;
  fabric.warpSequence = {0, 1};
  fabric.weftSequence = {2};
  return fabric;
}

bool same(const BvdfSet& a, const BvdfSet& b) {
  if (a.tableOfYarn != b.tableOfYarn || a.rays != b.rays || a.tables.size() != b.tables.size()) return false;
  for (size_t i = 0; i < a.tables.size(); ++i)
    if (!std::equal(a.tables[i].ratios().begin(), a.tables[i].ratios().end(), b.tables[i].ratios().begin(),
                    b.tables[i].ratios().end()))
      return false;
  return true;
}

TEST(BvdfBaker, YarnsOfEqualFibresShareATable) {
  const auto baker = BvdfBaker::begin(stripes(), kCoarse, Task{});
  ASSERT_TRUE(baker->advance(1, Task{}));
  const auto set = baker->tables();
  EXPECT_EQ(set->tables.size(), 2u);
  EXPECT_EQ(set->tableOfYarn, (std::vector<int>{0, 0, 1}));
  EXPECT_EQ(&set->of(1), &set->tables[0]);
  EXPECT_GT(set->rays, 100'000u);
  EXPECT_EQ(set->bytes(), 2 * kCoarse.bins() * sizeof(float));
}

TEST(BvdfBaker, TablesDependOnPassesAloneNotOnThreadsOrCalls) {
  const auto one = BvdfBaker::begin(stripes(), kCoarse, Task{{}, {}, 1});
  ASSERT_TRUE(one->advance(2, Task{{}, {}, 1}));
  const auto many = BvdfBaker::begin(stripes(), kCoarse, Task{{}, {}, 2});
  ASSERT_TRUE(many->advance(1, Task{{}, {}, 2}));
  const auto early = many->tables();
  ASSERT_TRUE(many->advance(1, Task{{}, {}, 1}));
  EXPECT_TRUE(same(*one->tables(), *many->tables()));
  EXPECT_FALSE(same(*early, *many->tables()));
}

TEST(BvdfBaker, StopsAndLeavesNoHalfPass) {
  const auto baker = BvdfBaker::begin(stripes(), kCoarse, Task{});
  ASSERT_TRUE(baker->advance(1, Task{}));
  const auto before = baker->tables();
  std::stop_source stop;
  Task task{stop.get_token(),
            [&stop](double fraction) {
              if (fraction > 0.3) stop.request_stop();
            },
            1};
  EXPECT_FALSE(baker->advance(1, task));
  EXPECT_EQ(baker->passes(), 1);
  EXPECT_TRUE(same(*before, *baker->tables()));
  EXPECT_EQ(BvdfBaker::begin(stripes(), kCoarse, task), nullptr);
  EXPECT_EQ(bakeBvdf(stripes(), {kCoarse, 1000}, kNoCache, task), nullptr);
  ASSERT_TRUE(baker->advance(1, Task{}));
  const auto straight = BvdfBaker::begin(stripes(), kCoarse, Task{});
  ASSERT_TRUE(straight->advance(2, Task{}));
  EXPECT_TRUE(same(*straight->tables(), *baker->tables()));
}

TEST(BakeBvdf, TakesWhatTheCacheHasAndMendsWhatItHasLost) {
  const test::ScratchFolder folder;
  const BvdfCache cache(folder.file(""));
  const BvdfOptions options{kCoarse, 50'000};
  const auto baked = bakeBvdf(stripes(), options, cache, Task{});
  std::stop_source stopped;
  stopped.request_stop();  // cannot bake, so what it returns it has read
  const Task readOnly{stopped.get_token(), {}, 1};
  const auto found = bakeBvdf(stripes(), options, cache, readOnly);
  ASSERT_TRUE(found);
  EXPECT_TRUE(same(*baked, *found));

  const std::string file = cache.fileOf(bvdfRecipe(stripes(), options)).string();
  test::putBytes(file, test::bytesOf(file).substr(0, 1000));
  EXPECT_FALSE(bakeBvdf(stripes(), options, cache, readOnly));
  EXPECT_TRUE(same(*baked, *bakeBvdf(stripes(), options, cache, Task{})));
  EXPECT_TRUE(bakeBvdf(stripes(), options, cache, readOnly));
}

TEST(BakeBvdf, HasTablesAfterEachPassAndEndsOnTheSame) {
  const BvdfOptions options{kCoarse, 200'000};
  std::vector<uint64_t> rays;
  const auto watched = bakeBvdf(stripes(), options, kNoCache, Task{}, [&](const BvdfBaker& baker) {
    rays.push_back(baker.tables()->rays);
    EXPECT_EQ(baker.passes(), static_cast<int>(rays.size()));
  });
  ASSERT_FALSE(rays.empty());
  EXPECT_TRUE(std::is_sorted(rays.begin(), rays.end()));
  EXPECT_LT(rays.back(), watched->rays);
  EXPECT_TRUE(same(*watched, *bakeBvdf(stripes(), options, kNoCache, Task{})));
}

TEST(ExpectedBvdf, IsTheHotSpotLawThatTheBakerMeasuresAgainst) {
  const Fabric fabric = stripes();
  const auto expected = expectedBvdf(*test::sceneOf(fabric), kCoarse);
  ASSERT_EQ(expected->tableOfYarn.size(), fabric.yarns.size());
  const auto baked = bakeBvdf(fabric, {kCoarse, 1000}, kNoCache, Task{});
  const glm::vec3 wo = glm::normalize(glm::vec3(0.2, 0.1, 1)), wi = glm::normalize(glm::vec3(-0.5, 0.4, 0.6));
  for (int yarn = 0; yarn < 3; ++yarn) {
    EXPECT_EQ(expected->of(yarn).hotSpot().depth, baked->of(yarn).hotSpot().depth);
    EXPECT_FLOAT_EQ(expected->of(yarn).occlusion(wi, wo), baked->of(yarn).hotSpot().occlusion(wi, wo));
    EXPECT_EQ(expected->of(yarn).occlusion(wo, wo), 0);
  }
}

// Depth times reach is 4 packing / pi, whatever the fibres' radius and the size of the cell.
TEST(ExpectedBvdf, OfMilledYarnsIsOfThePackingThatTheyHaveOpenedTo) {
  Fabric fabric = stripes();
  fabric.yarns[1].hairiness_per_mm = 2;
  fabric.milling = 1;
  const auto expected = expectedBvdf(*test::sceneOf(fabric), kCoarse);
  const auto packingOf = [&](int yarn) {
    const HotSpot& law = expected->of(yarn).hotSpot();
    return 0.25 * kPi * law.depth * law.reach;
  };
  EXPECT_NEAR(packingOf(0), fabric.yarns[0].packing, 1e-6) << "filament";
  EXPECT_NEAR(packingOf(1), withFinish(fabric.yarns[1], fabric).packing, 1e-6);
}

TEST(BvdfRecipe, HasWhatFibresDependOnAndNothingElse) {
  const BvdfOptions options;
  const std::string recipe = bvdfRecipe(stripes(), options);
  Fabric other = stripes();
  other.name = "another";
  other.yarns[0].name = "blue";
  other.fibres[1].absorption_per_mm = Rgb(1);
  other.fibres[1].refractiveIndex = 1.4;
  other.light.kind = LightKind::back;
  other.camera.distance_mm = 5;
  other.drape.kind = DrapeKind::cylinder;
  other.render.seed = 77;
  other.warpSequence = {1, 0};
  EXPECT_EQ(bvdfRecipe(other, options), recipe) << "colour, light, view and drape do not matter";

  const auto changed = [&](auto&& edit) {
    Fabric fabric = stripes();
    edit(fabric);
    return bvdfRecipe(fabric, options) != recipe;
  };
  EXPECT_TRUE(changed([](Fabric& f) { f.yarns[2].packing = 0.4; }));
  EXPECT_TRUE(changed([](Fabric& f) { f.yarns[2].layout = FibreLayout::random; }));
  EXPECT_TRUE(changed([](Fabric& f) { f.fibres[1].radius_um = 7; }));
  EXPECT_TRUE(changed([](Fabric& f) { f.ends_per_cm += 1; }));
  EXPECT_TRUE(changed([](Fabric& f) { f.render.resolution = 4; }));
  EXPECT_TRUE(changed([](Fabric& f) { f.weave = Weave({{1, 1, 0}, {0, 1, 1}, {1, 0, 1}}); }));
  EXPECT_NE(bvdfRecipe(stripes(), {{}, 10 * options.rays}), recipe);
  EXPECT_NE(bvdfRecipe(stripes(), {kCoarse, options.rays}), recipe);
}

// However large the repeat, however thick the yarns, the patch stays small.
TEST(BvdfPatch, IsBounded) {
  Fabric fabric = test::whiteCotton();
  std::vector<std::vector<uint8_t>> rows(300, std::vector<uint8_t>(300));
  Random random(3);
  for (auto& row : rows)
    for (auto& cell : row) cell = static_cast<uint8_t>(random.below(2));
  fabric.weave = Weave(rows);
  fabric.yarns[0].count_tex = 200;
  fabric.ends_per_cm = fabric.picks_per_cm = 8;
  const auto patch = BvdfPatch::build(fabric, Task{});
  EXPECT_LT(patch->fibres().segments(), 2'000'000u);
  EXPECT_LT(bvdfRecipe(fabric, {}).size(), 200'000u);
  EXPECT_TRUE(patch->isInside(1, 1));
  EXPECT_FALSE(patch->isInside(0, 1));
}

}  // namespace
}  // namespace loomlight
