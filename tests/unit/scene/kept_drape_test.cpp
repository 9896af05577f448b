#include <gtest/gtest.h>

#include <cstring>

#include "render/scene/scene.h"
#include "tests/support/test_cloth.h"

namespace loomlight {
namespace {

std::shared_ptr<const Scene> edited(const Scene& before, const Fabric& fabric) {
  return makeScene(std::make_shared<const Fabric>(fabric), Task{}, &before);
}

bool alike(const Shell& a, const Shell& b) {
  return a.tets().size() == b.tets().size() && a.vertices().size() == b.vertices().size() &&
         std::memcmp(a.tets().data(), b.tets().data(), a.tets().size_bytes()) == 0 &&
         std::memcmp(a.vertices().data(), b.vertices().data(), a.vertices().size_bytes()) == 0;
}

// A mesh of many triangles takes a while to read, mend and sort: an edit of a yarn, which makes the cloth thicker, lays
// another shell on the surface that it had before.
TEST(Drape, IsKeptThroughEditsOfYarns) {
  Fabric fabric = test::whiteCotton();
  fabric.drape.kind = DrapeKind::folds;
  const auto before = test::sceneOf(fabric);
  ASSERT_TRUE(before->cloth->drape);

  Fabric thicker = fabric;
  thicker.yarns[0].count_tex *= 2;
  const auto after = edited(*before, thicker);
  EXPECT_EQ(after->cloth->drape, before->cloth->drape);
  EXPECT_NE(after->cloth->shell, before->cloth->shell);
  EXPECT_TRUE(alike(*after->cloth->shell, *test::sceneOf(thicker)->cloth->shell));

  Fabric brighter = fabric;
  brighter.fibres[0].refractiveIndex += 0.05;
  const auto relit = edited(*before, brighter);
  ASSERT_NE(relit->cloth, before->cloth);
  EXPECT_EQ(relit->cloth->drape, before->cloth->drape);
}

TEST(Drape, FollowsItsOwnEdits) {
  Fabric fabric = test::whiteCotton();
  fabric.drape.kind = DrapeKind::folds;
  const auto before = test::sceneOf(fabric);
  Fabric tighter = fabric;
  tighter.drape.radius_mm *= 0.5;
  const auto after = edited(*before, tighter);
  EXPECT_NE(after->cloth->drape, before->cloth->drape);
  EXPECT_TRUE(alike(*after->cloth->shell, *test::sceneOf(tighter)->cloth->shell));

  Fabric flat = tighter;
  flat.drape.kind = DrapeKind::flat;
  const auto laid = edited(*after, flat);
  EXPECT_FALSE(laid->cloth->drape);
  EXPECT_TRUE(alike(*edited(*laid, fabric)->cloth->shell, *before->cloth->shell));
}

}  // namespace
}  // namespace loomlight
