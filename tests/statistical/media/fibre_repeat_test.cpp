#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "render/media/fibre_medium.h"
#include "render/scene/fibre_bvh.h"
#include "render/transport/path_tracer.h"
#include "tests/support/every_sample.h"
#include "tests/support/isotropic_light.h"
#include "tests/support/test_cloth.h"

namespace loomlight {
namespace {

/// Twisted and hairy cotton, no multiple of its repeat wide.
Fabric cotton(double side_mm) {
  Fabric fabric = test::whiteCotton();
  fabric.yarns[0].count_tex = 12;
  fabric.yarns[0].flattening = 1;
  fabric.yarns[0].hairiness_per_mm = 2;
  fabric.drape.width_mm = side_mm;
  fabric.drape.height_mm = side_mm + 1;
  fabric.render.resolution = 2;
  return fabric;
}

// Where nothing varies along the yarns a repeat and its copies are the very same cloth: every ray, from everywhere,
// meets the same fibre of the same crossing, or nothing, as in the whole piece; at its edges too.
TEST(FibreRepeat, OfUntwistedYarnsIsTheWholePieceRayByRay) {
  Fabric fabric = cotton(14);
  fabric.yarns[0].hairiness_per_mm = 0;
  fabric.yarns[0].plyTwist_per_m = 0;
  const auto scene = test::sceneOf(fabric);
  const FibreSize repeat = planFibres(*scene->cloth, {1e9, FibreExtent::oneRepeat});
  ASSERT_GT(repeat.copies.x, 1);
  ASSERT_GT(repeat.copies.y, 1);
  ASSERT_NE(scene->cloth->volume->geometry().ends() % repeat.ends, 0);
  const auto whole = FibreBvh::build(scene->cloth, planFibres(*scene->cloth, {}), Task{});
  const auto copies = FibreBvh::build(scene->cloth, repeat, Task{});
  Random random(3);
  int met = 0, otherwise = 0;
  for (int i = 0; i < 40000; ++i) {
    const float u = random.uniform(), v = random.uniform(), a = random.uniform(), b = random.uniform();
    const float z = 2 * a - 1, sine = std::sqrt(1 - z * z), phi = static_cast<float>(2 * kPi) * b;
    const glm::vec3 direction(sine * std::cos(phi), sine * std::sin(phi), z);
    const glm::vec3 about(16 * (u - 0.5f), 16 * (v - 0.5f), 0);
    FibreRay ray{about - (i % 2 ? 0.0f : 3.0f) * direction, direction};
    const auto expected = whole->meet(ray), hit = copies->meet(ray);
    if (expected.has_value() != hit.has_value()) {
      ++otherwise;
      continue;
    }
    ray.length_mm = random.uniform();
    if (whole->isFree(ray) != copies->isFree(ray)) ++otherwise;
    if (!hit) continue;
    ++met;
    if (hit->fibre != expected->fibre || hit->end != expected->end || hit->pick != expected->pick ||
        std::abs(hit->distance_mm - expected->distance_mm) > 1e-4f)
      ++otherwise;
  }
  EXPECT_GT(met, 20000);
  EXPECT_LT(otherwise, 40);  // a thousandth: rounding at silhouettes, as copies stand elsewhere to the last bit
}

struct Mean {
  double value = 0, standardError = 0;
};

// Blocks of the picture 3 mm wide, each a sample of the arrangement and of the noise together: the error of the mean is
// what differs between them.
Mean meanOfBlocks(const Scene& scene, const Medium& medium) {
  constexpr int kBlocks = 5, kSide = 8;
  constexpr uint32_t kSamples = 24;
  std::array<double, static_cast<size_t>(kBlocks) * kBlocks> lights{};
  test::forEachSample(scene, medium, kBlocks * kSide, kSamples, [&](int x, int y, const PathSample& sample) {
    lights[static_cast<size_t>(y / kSide * kBlocks + x / kSide)] +=
        (sample.direct.g + sample.indirect.g) / (kSide * kSide * kSamples);
  });
  double sum = 0, squares = 0;
  for (const double light : lights) {
    sum += light;
    squares += light * light;
  }
  constexpr double n = kBlocks * kBlocks;
  const double mean = sum / n;
  return {mean, std::sqrt((squares / n - mean * mean) / (n - 1))};
}

// Twisted yarns begin elsewhere in copies than in the piece: another arrangement, the same mean picture.
TEST(FibreRepeat, GivesTheSameMeanPictureAsTheWholePiece) {
  Fabric fabric = cotton(20);
  fabric.fibres[0].absorption_per_mm = Rgb(8);
  fabric.light.kind = LightKind::dome;
  fabric.camera.elevation_deg = 70;
  fabric.camera.fov_deg = 0;
  fabric.camera.distance_mm = 15 / (2 * std::tan(10 * kPi / 180));
  const auto scene = test::sceneOf(fabric);
  const auto whole = FibreMedium::build(scene->cloth, {}, Task{});
  const auto copies = FibreMedium::build(scene->cloth, {1e9, FibreExtent::oneRepeat}, Task{});
  ASSERT_TRUE(whole->size().isWholePiece());
  ASSERT_FALSE(copies->size().isWholePiece());
  EXPECT_LT(copies->segments(), 0.6 * static_cast<double>(whole->segments()));
  const Mean a = meanOfBlocks(*scene, *whole), b = meanOfBlocks(*scene, *copies);
  const double error = std::hypot(a.standardError, b.standardError);
  EXPECT_NEAR(a.value, b.value, 3.3 * error);
  EXPECT_LT(error, 0.02 * a.value);
}

TEST(FibreRepeat, KeepsTheCountOfEvents) {
  Fabric fabric = cotton(20);
  fabric.yarns[0].hairiness_per_mm = 0;
  const auto scene = test::sceneOf(fabric);
  const auto copies = FibreMedium::build(scene->cloth, {1e9, FibreExtent::oneRepeat}, Task{});
  ASSERT_FALSE(copies->size().isWholePiece());
  const double expected = test::lateralOverBoundaryArea(*scene);
  const auto [mean, error] = test::eventsUnderIsotropicLight(*scene, *copies, 4, 6000, 13);
  EXPECT_NEAR(mean, expected, 0.03 * expected + 3 * error);
  EXPECT_LT(error, 0.02 * expected);
  RecordProperty("share", std::to_string(mean / expected));
}

}  // namespace
}  // namespace loomlight
