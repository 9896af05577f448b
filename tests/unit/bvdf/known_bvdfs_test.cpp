#include "render/bvdf/known_bvdfs.h"

#include <gtest/gtest.h>

#include "render/bvdf/bake/bvdf_baker.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_cloth.h"

namespace loomlight {
namespace {

constexpr BvdfOptions kOptions{{2, 2, 4, 8}, 1000};

Fabric twisted(double warpTwist_per_m, double weftTwist_per_m) {
  Fabric fabric = test::whiteCotton();
  fabric.yarns.push_back(fabric.yarns[0]);
  fabric.weftSequence = {1};
  fabric.yarns[0].plyTwist_per_m = warpTwist_per_m;
  fabric.yarns[1].plyTwist_per_m = weftTwist_per_m;
  return fabric;
}
std::string recipeOf(const Fabric& fabric, const BvdfOptions& options = kOptions) {
  return bvdfRecipe(fabric, options);
}
std::shared_ptr<const BvdfSet> tablesOf(std::initializer_list<float> ratios) {
  auto set = std::make_shared<BvdfSet>();
  for (const float ratio : ratios)
    set->tables.emplace_back(kOptions.resolution, HotSpot{}, std::vector<float>(kOptions.resolution.bins(), ratio));
  set->rays = 7;
  return set;
}
float ratioOf(const BvdfSet& set, size_t table) {
  return set.tables[table].ratios()[5];
}

TEST(KnownBvdfs, LendsEachYarnTheTableOfTheOneMostLikeIt) {
  const test::ScratchFolder folder;
  for (const bool onDisk : {false, true}) {
    SCOPED_TRACE(onDisk);
    const BvdfCache cache(onDisk ? std::filesystem::path(folder.file("")) : std::filesystem::path());
    KnownBvdfs known(cache);
    EXPECT_EQ(known.nearest(recipeOf(twisted(500, 700))), nullptr);
    const auto keep = [&](const Fabric& fabric, std::initializer_list<float> ratios) {
      if (onDisk) {
        cache.keep(recipeOf(fabric), *tablesOf(ratios));
      } else {
        known.keep(recipeOf(fabric), tablesOf(ratios));
      }
    };
    keep(twisted(300, 900), {0.3f, 0.9f});
    keep(twisted(600, 1200), {0.6f, 1.2f});
    const auto lent = known.nearest(recipeOf(twisted(1000, 500)));
    ASSERT_NE(lent, nullptr);
    ASSERT_EQ(lent->tables.size(), 2u);
    EXPECT_EQ(ratioOf(*lent, 0), 0.9f);
    EXPECT_EQ(ratioOf(*lent, 1), 0.6f);
    BvdfOptions finer = kOptions;
    finer.resolution.phiI *= 2;
    EXPECT_EQ(known.nearest(recipeOf(twisted(1000, 500), finer)), nullptr) << "of another resolution";
  }
}

TEST(KnownBvdfs, LendsNothingThatIsDamaged) {
  const test::ScratchFolder folder;
  const BvdfCache cache(folder.file(""));
  const std::string recipe = recipeOf(twisted(300, 900));
  cache.keep(recipe, *tablesOf({0.3f, 0.9f}));
  ASSERT_EQ(cache.recipes(9), (std::vector<std::string>{recipe}));
  EXPECT_TRUE(cache.recipes(0).empty());
  std::filesystem::resize_file(cache.fileOf(recipe), std::filesystem::file_size(cache.fileOf(recipe)) - 1);
  EXPECT_EQ(KnownBvdfs(cache).nearest(recipeOf(twisted(400, 900))), nullptr);
  std::filesystem::resize_file(cache.fileOf(recipe), 20);
  EXPECT_TRUE(cache.recipes(9).empty());
}

TEST(DrawnTowards, FadesFromThePriorToItself) {
  const auto own = tablesOf({0.2f, 0.4f}), prior = tablesOf({1.0f, 0.4f});
  EXPECT_EQ(ratioOf(*drawnTowards(*own, *prior, 0), 0), 1.0f);
  float last = 1;
  for (const double progress : {0.05, 0.2, 0.5, 0.9}) {
    const auto drawn = drawnTowards(*own, *prior, progress);
    EXPECT_LT(ratioOf(*drawn, 0), last);
    EXPECT_GT(ratioOf(*drawn, 0), 0.2f);
    EXPECT_EQ(ratioOf(*drawn, 1), 0.4f);
    last = ratioOf(*drawn, 0);
  }
  EXPECT_NEAR(last, 0.2f, 0.02f);
  EXPECT_EQ(ratioOf(*drawnTowards(*own, *prior, 1), 0), 0.2f);
}

}  // namespace
}  // namespace loomlight
