#include "app/live/recent_cloths.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "render/transport/make_medium.h"
#include "tests/support/test_cloth.h"

namespace loomlight {
namespace {

constexpr size_t kPlenty = size_t{1} << 30;

Fabric twill() {
  Fabric fabric = test::whiteCotton();
  fabric.weave = Weave({{1, 1, 0, 0}, {0, 1, 1, 0}, {0, 0, 1, 1}, {1, 0, 0, 1}});
  fabric.render.resolution = 2;
  return fabric;
}

Fabric twisted(int step) {
  Fabric fabric = twill();
  fabric.yarns[0].count_tex += step;
  return fabric;
}

/// As the builder makes cloths, each from what is kept.
BuiltCloth built(const Fabric& fabric, const RecentCloths& recent) {
  BuiltCloth cloth;
  Traceable& made = cloth.traceable;
  const RecentCloths::Base base = recent.baseFor(fabric);
  made.scene =
      makeScene(std::make_shared<const Fabric>(fabric), Task{}, SceneBase{base.cloth.traceable.scene.get(), base.edit});
  return cloth;
}

const ClothVolume* show(const Fabric& fabric, RecentCloths& recent) {
  BuiltCloth cloth = built(fabric, recent);
  const ClothVolume* volume = cloth.traceable.scene->cloth->volume.get();
  recent.keep(std::move(cloth));
  return volume;
}

TEST(RecentCloths, BringBackTheVeryVolume) {
  RecentCloths recent(kPlenty);
  EXPECT_EQ(recent.baseFor(twill()).cloth.traceable.scene, nullptr);
  const ClothVolume* first = show(twill(), recent);
  Fabric painted = twill();
  painted.weave = painted.weave.with(1, 0, true);
  const ClothVolume* second = show(painted, recent);
  const ClothVolume* third = show(twisted(5), recent);
  EXPECT_EQ(std::set({first, second, third}).size(), 3u);
  for (int times = 0; times < 3; ++times) {
    EXPECT_EQ(show(twill(), recent), first);
    EXPECT_EQ(show(painted, recent), second);
    EXPECT_EQ(show(twisted(5), recent), third);
  }
  // In other colours too.
  Fabric red = painted;
  red.fibres[0].absorption_per_mm = Rgb(1, 50, 50);
  EXPECT_EQ(show(red, recent), second);
  EXPECT_EQ(recent.count(), 3u);
}

TEST(RecentCloths, OfOneVolumeAreOne) {
  RecentCloths recent(kPlenty);
  Fabric fabric = twill();
  for (int i = 0; i < 10; ++i) {
    fabric.camera.azimuth_deg += 1;
    show(fabric, recent);
  }
  EXPECT_EQ(recent.count(), 1u);
  EXPECT_EQ(recent.bytes(), 0u);
}

TEST(RecentCloths, KeepWithinTheirBudget) {
  RecentCloths all(kPlenty);
  for (int step = 0; step < 8; ++step) show(twisted(step), all);
  ASSERT_EQ(all.count(), 8u);
  ASSERT_GT(all.bytes(), 7 * sizeof(ClothVolume));

  const size_t budget = all.bytes() / 2;
  RecentCloths recent(budget);
  for (int step = 0; step < 8; ++step) {
    show(twisted(step), recent);
    EXPECT_LE(recent.bytes(), budget);
  }
  EXPECT_GT(recent.count(), 2u);
  EXPECT_LT(recent.count(), 8u);
  // What was used last is there still, what was used first is not.
  const ClothVolume* volume = recent.baseFor(twisted(6)).cloth.traceable.scene->cloth->volume.get();
  EXPECT_EQ(show(twisted(6), recent), volume);
  EXPECT_EQ(built(twisted(7), recent).traceable.scene->cloth->volume,
            recent.baseFor(twisted(7)).cloth.traceable.scene->cloth->volume);
  EXPECT_NE(built(twisted(0), recent).traceable.scene->cloth->volume,
            recent.baseFor(twisted(0)).cloth.traceable.scene->cloth->volume);

  RecentCloths none(0);
  show(twisted(0), none);
  show(twisted(1), none);
  EXPECT_EQ(none.count(), 1u);  // the newest is not part of the budget
}

/// Bytes of all bricks that the volumes hold together.
size_t brickBytes(const std::set<std::shared_ptr<const ClothVolume>>& volumes) {
  std::map<const BrickBlock*, size_t> bricks;  // by where they lie
  for (const auto& volume : volumes)
    for (int pick = 0; pick < volume->geometry().picks(); ++pick)
      for (int end = 0; end < volume->geometry().ends(); ++end)
        for (const System system : {System::warp, System::weft}) {
          const BrickView brick = volume->brick(system, pick, end);
          bricks[brick.blocks] = brick.bytes();
        }
  size_t bytes = 0;
  for (const auto& brick : bricks) bytes += brick.second;
  return bytes;
}

TEST(RecentCloths, CountAtLeastWhatTheyTake) {
  RecentCloths recent(kPlenty);
  std::set<std::shared_ptr<const ClothVolume>> volumes;
  Fabric fabric = twill();
  for (const int step : {0, 1, 0, 2, 3, 1, 4, 0, 5}) {
    fabric.yarns[0].count_tex = 20 + step / 2;
    fabric.weave = twill().weave.with(step % 2, step % 4, step % 3 == 0);
    show(fabric, recent);
    const auto newest = recent.baseFor(fabric).cloth.traceable.scene->cloth->volume;
    volumes.insert(newest);
    EXPECT_GE(recent.bytes() + brickBytes({newest}), brickBytes(volumes));
  }
  EXPECT_EQ(recent.count(), volumes.size());
}

// A drape that is dragged is a new cloth with each step, whose volume takes nothing beside the one before.
TEST(RecentCloths, CountDrapes) {
  RecentCloths recent(kPlenty);
  Fabric fabric = twill();
  fabric.drape.kind = DrapeKind::cylinder;
  size_t shells = 0;
  for (int step = 0; step < 3; ++step) {
    fabric.drape.radius_mm += step;
    show(fabric, recent);
    const Shell& shell = *recent.baseFor(fabric).cloth.traceable.scene->cloth->shell;
    EXPECT_GE(shell.bytes(), shell.tets().size() * sizeof(Shell::Tet));
    EXPECT_GE(recent.bytes(), shells) << "those of the cloths before";
    shells += shell.bytes();
  }
  EXPECT_EQ(recent.count(), 3u);
}

TEST(RecentCloths, LetExplicitFibresGo) {
  RecentCloths recent(kPlenty);
  Fabric fibres = twill();
  fibres.drape.width_mm = fibres.drape.height_mm = 2;
  fibres.render.method = Method::fibres;
  BuiltCloth cloth = built(fibres, recent);
  std::shared_ptr<const Medium> medium = makeMedium(*cloth.traceable.scene, kPlenty, Task{});
  const std::weak_ptr<const Medium> watched = medium;
  cloth.traceable.medium = std::move(medium);
  recent.keep(std::move(cloth));
  EXPECT_FALSE(watched.expired());
  show(twisted(3), recent);
  EXPECT_TRUE(watched.expired());
}

}  // namespace
}  // namespace loomlight
