#include "render/transport/blend.h"

#include <gtest/gtest.h>

#include <cmath>

#include "render/media/volume_medium.h"
#include "render/transport/path_tracer.h"
#include "tests/support/test_cloth.h"

namespace loomlight {
namespace {

Fabric blended(double share) {
  Fabric fabric = test::whiteCotton();
  fabric.fibres.push_back(fabric.fibres[0]);
  fabric.fibres[1].absorption_per_mm = Rgb(40.0f, 20.0f, 5.0f);
  for (Yarn& yarn : fabric.yarns) {
    yarn.blendFibre = 1;
    yarn.blendShare = share;
  }
  return fabric;
}

Image pictureOf(const Fabric& fabric) {
  constexpr int kWidth = 16, kHeight = 12;
  const auto scene = test::sceneOf(fabric);
  Film film(kWidth, kHeight);
  Task task;
  task.threads = 1;
  renderUpTo(2, *scene, VolumeMedium(scene->cloth), CameraRays(fabric.camera, kWidth, kHeight), film, task);
  return film.toImage(false);
}

void expectSame(const Image& a, const Image& b) {
  for (const char* channel : {"R", "G", "B"}) EXPECT_EQ(a.find(channel)->values, b.find(channel)->values);
}

TEST(Blend, OfNothingIsTheYarnsOwnFibre) {
  Fabric plain = blended(0);
  for (Yarn& yarn : plain.yarns) yarn.blendFibre.reset();
  expectSame(pictureOf(plain), pictureOf(blended(0)));
}

/// With a fibre of the blended yarn.
Collision collisionIn(const Scene& scene) {
  Collision at;
  at.optics = scene.cloth->yarns[0][0];
  return at;
}

TEST(Blend, OfAllIsTheOtherFibre) {
  const auto scene = test::sceneOf(blended(1));
  Random random(7);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(materialMet(collisionIn(*scene), random), 1);
}

TEST(Blend, LightMeetsEachKindAsOftenAsThereIs) {
  const auto scene = test::sceneOf(blended(0.3));
  constexpr int kDraws = 20000;
  Random random(1);
  int drawn = 0, numbered = 0;
  for (int i = 1; i <= kDraws; ++i) {
    Collision at = collisionIn(*scene);
    drawn += materialMet(at, random) == 1;
    at.fibre = (uint64_t{1} << 32) + static_cast<uint64_t>(i);
    numbered += materialMet(at, random) == 1;
  }
  const double sigma = std::sqrt(0.3 * 0.7 / kDraws);
  EXPECT_NEAR(drawn / static_cast<double>(kDraws), 0.3, 4 * sigma);
  EXPECT_NEAR(numbered / static_cast<double>(kDraws), 0.3, 4 * sigma);
}

TEST(Blend, AnExplicitFibreIsAlwaysOfOneKind) {
  const auto scene = test::sceneOf(blended(0.5));
  Random random(1);
  for (uint64_t fibre = 1; fibre < 50; ++fibre) {
    Collision at = collisionIn(*scene);
    at.fibre = fibre;
    const int material = materialMet(at, random);
    for (int i = 0; i < 5; ++i) EXPECT_EQ(materialMet(at, random), material);
  }
}

}  // namespace
}  // namespace loomlight
