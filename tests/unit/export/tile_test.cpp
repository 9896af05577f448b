#include "app/export/tile.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/fabric/model/validate.h"
#include "core/geometry/cloth/cloth_geometry.h"
#include "render/transport/make_medium.h"
#include "render/transport/path_tracer.h"
#include "tests/support/open_cloth.h"
#include "tests/support/scratch_folder.h"

namespace loomlight {
namespace {

/// A few coarse white fibres in an open twill.
Fabric openWeave() {
  Fabric fabric = test::openCloth();
  fabric.ends_per_cm = 10;
  fabric.picks_per_cm = 12;
  fabric.yarns[0].fibresPerPly = 40;
  fabric.fibres[0].radius_um = 15;
  fabric.render.resolution = 2;
  fabric.render.samplesPerPixel = 16;
  return fabric;
}

Film rendered(const Fabric& scene) {
  const auto shared = std::make_shared<const Fabric>(scene);
  const auto built = makeScene(shared, {});
  const auto medium = makeMedium(*built, 1e9, {});
  Film film(scene.render.width, scene.render.height);
  renderUpTo(static_cast<uint32_t>(scene.render.samplesPerPixel), *built, *medium,
             CameraRays(scene.camera, film.width(), film.height()), film, {});
  return film;
}

TEST(Tile, HoldsWholeRepeatsOfWeaveColoursAndTwist) {
  Fabric fabric = openWeave();
  fabric.warpSequence = {0, 0, 0, 0, 0};
  const TileExtent extent = tileExtent(fabric);
  EXPECT_EQ(extent.ends % 15, 0);  // 3 of the weave, 5 of the colours
  EXPECT_EQ(extent.picks % 3, 0);
  const ClothGeometry geometry(fabric, 8, 8);
  EXPECT_TRUE(extent.twistJoins);
  EXPECT_EQ(extent.ends % geometry.yarn(System::weft, 0).period, 0);
  EXPECT_EQ(extent.picks % geometry.yarn(System::warp, 0).period, 0);
}

TEST(Tile, ThatIsTooLargeIsRefusedByTheFabricsName) {
  Fabric fabric = openWeave();
  fabric.name = "Scrim";
  fabric.ends_per_cm = fabric.picks_per_cm = 1;
  fabric.warpSequence = fabric.weftSequence = std::vector<int>(401, 0);  // three times as many threads: 12 m
  const test::ScratchFolder folder;
  EXPECT_THAT(test::messageOf<InputError>([&] { makeTile(fabric, folder.file("scrim"), {64, false}, 1e9, {}); }),
              testing::StartsWith("Scrim: the tile: drape.width_mm: expected"));
}

TEST(Tile, ThePictureIsExactlyTheTileInTheMiddle) {
  const Fabric fabric = openWeave();
  const TileExtent extent = tileExtent(fabric);
  const Fabric scene = tileScene(fabric, extent, 100);
  validate(scene, "tile");
  EXPECT_EQ(std::max(scene.render.width, scene.render.height), 100);
  // What the camera sees, by the rays of its corners.
  const CameraRays camera(scene.camera, scene.render.width, scene.render.height);
  const auto width = static_cast<float>(scene.render.width), height = static_cast<float>(scene.render.height);
  const glm::vec3 corner = camera.ray(0, height).origin, far = camera.ray(width, 0).origin;
  EXPECT_NEAR(far.x - corner.x, extent.ends * scene.warpPitch_mm(), 1e-4);
  EXPECT_NEAR(far.y - corner.y, extent.picks * scene.weftPitch_mm(), 1e-4);
  // Its corner is that of a tile, an odd number of which lies across the piece, and there is cloth around it.
  EXPECT_NEAR(std::remainder(0.5 * scene.drape.width_mm + corner.x, extent.ends * scene.warpPitch_mm()), 0, 1e-3);
  EXPECT_NEAR(std::remainder(0.5 * scene.drape.height_mm + corner.y, extent.picks * scene.weftPitch_mm()), 0, 1e-3);
  EXPECT_GE(0.5 * scene.drape.width_mm + corner.x, 3 - 1e-3);
  EXPECT_NEAR(scene.ends_per_cm, fabric.ends_per_cm, 0.01 * fabric.ends_per_cm);
}

TEST(Tile, EveryThreadGoesOnInTheNextTile) {
  Fabric fabric = openWeave();
  fabric.yarns[0].evennessCv_percent = 15;
  fabric.yarns[0].slubs_per_m = 5;
  fabric.settCv_percent = 5;
  const TileExtent extent = tileExtent(fabric);
  ASSERT_TRUE(extent.twistJoins);
  const auto scene = std::make_shared<const Fabric>(tileScene(fabric, extent, 100));
  const auto built = makeScene(scene, {}, SceneBase{nullptr, {}, extent.tiling()});
  const ClothGeometry& geometry = built->cloth->volume->geometry();
  for (const System system : {System::warp, System::weft})
    for (int pick = 0; pick < extent.picks; ++pick)
      for (int end = 0; end < extent.ends; ++end) {
        ASSERT_EQ(geometry.key(system, pick, end), geometry.key(system, pick, end + extent.ends));
        ASSERT_EQ(geometry.key(system, pick, end), geometry.key(system, pick + extent.picks, end));
      }
  std::set<int> phases;  // and within a tile threads differ
  for (int end = 0; end < extent.ends; ++end) phases.insert(geometry.key(System::warp, 0, end).phase);
  EXPECT_GT(phases.size(), 1u);
}

TEST(Tile, AWhiteClothHasAWhiteBaseColourAndItsHoles) {
  const Fabric fabric = openWeave();
  const Fabric scene = tileScene(fabric, tileExtent(fabric), 96);
  const TileMaps maps = tileMaps(rendered(scene), scene, 1);
  double opacity = 0, reflected = 0;
  for (size_t i = 0; i < maps.opacity.size(); ++i) {
    opacity += maps.opacity[i];
    if (maps.opacity[i] > 0) {
      reflected += maps.opacity[i] * maps.baseColour[i].x;
      EXPECT_EQ(maps.yarn[i], 0);
    } else {
      EXPECT_EQ(maps.yarn[i], -1);
      EXPECT_GT(maps.baseColour[i].x, 0.5) << "a dark hole beside white yarns";
    }
    EXPECT_NEAR(glm::length(maps.normal[i]), 1, 1e-5);
    EXPECT_GT(maps.normal[i].z, 0);
  }
  EXPECT_NEAR(reflected / opacity, 1, 0.01);
  opacity /= static_cast<double>(maps.opacity.size());
  EXPECT_GT(opacity, 0.2);
  EXPECT_LT(opacity, 0.95);
  // Heights are those of yarns about the mid-plane.
  const auto [low, high] = std::minmax_element(maps.height_mm.begin(), maps.height_mm.end());
  EXPECT_LT(*low, 0);
  EXPECT_GT(*high, 0);
  EXPECT_LT(*high - *low, 2);
}

// A map of few samples is as near to one of many as if it had several times as many, and as bright.
TEST(Tile, ColoursHaveLittleNoise) {
  Fabric fabric = openWeave();
  fabric.fibres[0].absorption_per_mm = Rgb(10, 20, 40);
  fabric.render.samplesPerPixel = 8;
  const Fabric scene = tileScene(fabric, tileExtent(fabric), 96);
  const Film few = rendered(scene);
  Fabric longer = scene;
  longer.render.samplesPerPixel = 256;
  longer.render.seed = 1;
  const Film many = rendered(longer);
  const TileMaps maps = tileMaps(few, scene, 1);
  double ours = 0, plain = 0, sum = 0, plainSum = 0;
  for (int y = 0; y < maps.height; ++y)
    for (int x = 0; x < maps.width; ++x) {
      const float alpha = few.alpha(x, y);
      if (alpha == 0 || many.alpha(x, y) == 0) continue;
      const Rgb truth = many.mean(x, y) / many.alpha(x, y), asTraced = few.mean(x, y) / alpha;
      const Rgb colour =
          maps.baseColour[static_cast<size_t>(y) * static_cast<size_t>(maps.width) + static_cast<size_t>(x)];
      const Rgb off = colour - truth, plainOff = asTraced - truth;
      ours += alpha * glm::dot(off, off);
      plain += alpha * glm::dot(plainOff, plainOff);
      sum += alpha * luminance(colour);
      plainSum += alpha * luminance(asTraced);
    }
  EXPECT_LT(ours, plain / 3);
  EXPECT_NEAR(sum, plainSum, 0.01 * plainSum);
}

/// Mean difference of neighbouring columns of the opacity: within the tile, and from its last to its first.
TEST(Tile, OppositeEdgesMeet) {
  const Fabric fabric = openWeave();
  const Fabric scene = tileScene(fabric, tileExtent(fabric), 192);
  const TileMaps maps = tileMaps(rendered(scene), scene, 1);
  const auto step = [&](int x) {
    double sum = 0;
    for (int y = 0; y < maps.height; ++y) {
      const auto row = static_cast<size_t>(y) * static_cast<size_t>(maps.width);
      sum += std::abs(maps.opacity[row + static_cast<size_t>((x + 1) % maps.width)] -
                      maps.opacity[row + static_cast<size_t>(x)]);
    }
    return sum / maps.height;
  };
  double largest = 0;
  for (int x = 0; x + 1 < maps.width; ++x) largest = std::max(largest, step(x));
  EXPECT_LE(step(maps.width - 1), largest);
}

}  // namespace
}  // namespace loomlight
