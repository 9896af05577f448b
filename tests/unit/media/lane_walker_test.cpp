#include "render/media/lane_walker.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/lane_walks.h"

namespace loomlight {
namespace {

using test::Ends;
using test::Rays;
using test::WalkEnd;

class LaneWalks : public test::LaneClothTest {};

// Lanes take each ray as far as it would come alone, in doubles. Their floats put the faces of voxels elsewhere by some
// 1e-6 mm, which is less than a thousandth of a voxel: so a ray ends in another voxel, or passes where the other meets,
// only if its depth is used up as near to a face as that, and that is one ray in a thousand at the most.
void expectAsFarAsAlone(const std::shared_ptr<const Scene>& scene, LoomlightMedium::Ingredients ingredients) {
  const LoomlightMedium medium(scene->cloth, ingredients);
  const Rays all = test::raysOf(*scene, medium, 1500);
  LaneWalker walker(*scene->cloth, medium.walkRules());
  Ends lanes(*scene->cloth, all.rays.size());
  EXPECT_GT(walker.walk(all.rays, lanes), all.rays.size());
  EXPECT_TRUE(lanes.allToldOnce());
  const glm::vec3 size = scene->cloth->volume->grid().size_mm;
  const float near_mm = 0.01f * std::min({size.x, size.y, size.z});
  size_t met = 0, others = 0;
  for (size_t i = 0; i < all.rays.size(); ++i) {
    const WalkEnd alone = test::loneWalk(*scene->cloth, medium.walkRules(), all.rays[i]);
    const WalkEnd& lane = lanes.ends()[i];
    met += alone.met;
    const bool same = alone.met == lane.met && std::abs(alone.t_mm - lane.t_mm) <= near_mm &&
                      std::abs(alone.depth - lane.depth) <= 0.01f;
    others += !same;
  }
  EXPECT_GT(met, all.rays.size() / 4);
  EXPECT_LT(met, all.rays.size());
  EXPECT_LE(others, all.rays.size() / 1000) << "of " << all.rays.size();
}

TEST_P(LaneWalks, GoAsFarAsEachRayAlone) {
  expectAsFarAsAlone(scene(), {});
}
TEST_P(LaneWalks, GoAsFarAsEachRayAloneThroughThePlainVolume) {
  expectAsFarAsAlone(scene(), LoomlightMedium::plain(EventLaw::projected));
}

// What becomes of a ray does not depend on which others walk beside it, nor on how many fit into a register.
TEST_P(LaneWalks, AreTheSameInAnyCompanyAndOfAnyWidth) {
  const auto scene = this->scene();
  const LoomlightMedium medium(scene->cloth);
  const Rays all = test::raysOf(*scene, medium, 200);
  const auto together = [&] {
    LaneWalker walker(*scene->cloth, medium.walkRules());
    Ends ends(*scene->cloth, all.rays.size());
    walker.walk(all.rays, ends);
    return ends.ends();
  };
  const auto expectSame = [](const WalkEnd& a, const WalkEnd& b) {
    EXPECT_EQ(a.met, b.met);
    EXPECT_EQ(a.t_mm, b.t_mm);
    EXPECT_EQ(a.depth, b.depth);
    EXPECT_EQ(a.voxel, b.voxel);
  };
  const std::vector<WalkEnd> expected = together();
  LaneWalker walker(*scene->cloth, medium.walkRules());
  for (size_t i = 0; i < all.rays.size(); ++i) {
    Ends alone(*scene->cloth, 1);
    walker.walk({&all.rays[i], 1}, alone);
    expectSame(alone.ends()[0], expected[i]);
  }
  test::onEveryInstructionSet([&] {
    const std::vector<WalkEnd> ends = together();
    for (size_t i = 0; i < ends.size(); ++i) expectSame(ends[i], expected[i]);
  });
}

INSTANTIATE_TEST_SUITE_P(Cloths, LaneWalks, testing::ValuesIn(test::laneCloths()),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace loomlight
