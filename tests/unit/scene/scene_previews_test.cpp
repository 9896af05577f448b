#include <gtest/gtest.h>

#include "render/scene/cells_in_view.h"
#include "render/scene/shell_entry.h"
#include "tests/support/test_cloth.h"

namespace loomlight {
namespace {

/// Yarns of many fibres, which are sketched first.
Fabric thickCloth() {
  Fabric fabric = test::whiteCotton();
  fabric.yarns[0].count_tex = 60;
  fabric.yarns[0].migration = 0.3;
  fabric.ends_per_cm = fabric.picks_per_cm = 14;
  fabric.render.resolution = 2;
  return fabric;
}

bool sameBricks(const ClothVolume& a, const ClothVolume& b) {
  for (int pick = 0; pick < a.geometry().picks(); ++pick)
    for (int end = 0; end < a.geometry().ends(); ++end)
      for (const System system : {System::warp, System::weft})
        if (!(a.brick(system, pick, end) == b.brick(system, pick, end))) return false;
  return true;
}

struct Shown {
  std::vector<std::shared_ptr<const Scene>> sketches;
  ScenePreviews first{1.5, [](double) { return true; },
                      [this](std::shared_ptr<const Scene> sketch) { sketches.push_back(std::move(sketch)); }};
};

TEST(ScenePreviews, AreCompleteAndLeaveTheSceneAsItIs) {
  const auto fabric = std::make_shared<const Fabric>(thickCloth());
  Shown shown;
  const auto scene = makeScene(fabric, Task{}, nullptr, &shown.first), fresh = makeScene(fabric, Task{});
  ASSERT_FALSE(shown.sketches.empty());
  EXPECT_TRUE(shown.sketches.front()->cloth->volume->geometry().isSketched());
  EXPECT_FALSE(scene->cloth->volume->geometry().isSketched());
  EXPECT_TRUE(sameBricks(*scene->cloth->volume, *fresh->cloth->volume));
  for (const auto& sketch : shown.sketches) {
    EXPECT_EQ(sketch->fabric, fabric);
    EXPECT_TRUE(sketch->cloth->shell && sketch->cloth->entry && sketch->lighting);
    EXPECT_EQ(sketch->cloth->materials.size(), scene->cloth->materials.size());
    EXPECT_EQ(sketch->cloth->yarns[0].size(), scene->cloth->yarns[0].size());
    EXPECT_EQ(sketch->cloth->volume->geometry().ends(), scene->cloth->volume->geometry().ends());
  }
}

TEST(ScenePreviews, AreNotShownOfWhatIsThere) {
  Fabric fabric = thickCloth();
  const auto before = test::sceneOf(fabric);
  fabric.fibres[0].absorption_per_mm = Rgb(3);
  Shown shown;
  const auto after = makeScene(std::make_shared<const Fabric>(fabric), Task{}, before.get(), &shown.first);
  EXPECT_TRUE(shown.sketches.empty());
  EXPECT_EQ(after->cloth->volume, before->cloth->volume);
}

TEST(CellsInView, HoldAllThatThePictureShows) {
  for (const DrapeKind kind : {DrapeKind::flat, DrapeKind::cylinder}) {
    Fabric fabric = test::whiteCotton();
    fabric.render.resolution = 1;
    fabric.drape.kind = kind;
    fabric.drape.width_mm = fabric.drape.height_mm = 60;
    fabric.drape.radius_mm = 30;
    const auto scene = test::sceneOf(fabric);
    const ClothGeometry& geometry = scene->cloth->volume->geometry();
    const CellRect rect = cellsInView(fabric.camera, 1.5, geometry, *scene->cloth->shell, *scene->cloth->entry);
    EXPECT_LT(rect.picks * rect.ends, geometry.picks() * geometry.ends() / 2);
    const CameraRays camera(fabric.camera, 90, 60);
    int seen = 0;
    for (int y = 0; y < 60; ++y)
      for (int x = 0; x < 90; ++x) {
        const Ray ray = camera.ray(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
        const auto hit = scene->cloth->entry->enter(ray.origin, ray.direction, 0, 1e6f);
        if (!hit) continue;
        const glm::vec3 place = scene->cloth->shell->toCloth(hit->tet, ray.origin + hit->t * ray.direction);
        ++seen;
        EXPECT_TRUE(rect.contains(static_cast<int>(place.y / geometry.weftPitch_mm()),
                                  static_cast<int>(place.x / geometry.warpPitch_mm())));
      }
    EXPECT_GT(seen, 1000);
  }
}

TEST(CellsInView, AreOneWhereNothingIsSeen) {
  Fabric fabric = test::whiteCotton();
  fabric.render.resolution = 1;
  const auto scene = test::sceneOf(fabric);
  fabric.camera.target_mm = {500, 0, 0};
  const CellRect rect =
      cellsInView(fabric.camera, 1, scene->cloth->volume->geometry(), *scene->cloth->shell, *scene->cloth->entry);
  EXPECT_LE(rect.picks * rect.ends, 9);
  EXPECT_GE(rect.pick, 0);
  EXPECT_LT(rect.pick + rect.picks, scene->cloth->volume->geometry().picks());
}

}  // namespace
}  // namespace loomlight
