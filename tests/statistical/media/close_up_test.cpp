#include "render/media/close_up_medium.h"

#include <gtest/gtest.h>

#include <cmath>

#include "render/media/fibre_medium.h"
#include "render/scene/fibre_bricks.h"
#include "render/transport/make_medium.h"
#include "render/transport/path_tracer.h"
#include "tests/support/every_sample.h"
#include "tests/support/test_cloth.h"
#include "tests/support/white_light.h"

namespace loomlight {
namespace {

constexpr int kSize = 24;

/// White cotton that a picture of kSize pixels shows so wide.
Fabric seenAt(double width_mm) {
  Fabric fabric = test::whiteCotton();
  fabric.drape.width_mm = fabric.drape.height_mm = 6;
  fabric.render.estimator = Estimator::loomlight;
  fabric.camera.elevation_deg = 70;
  fabric.camera.fov_deg = 20;
  fabric.camera.distance_mm = width_mm / (2 * std::tan(10 * kPi / 180));
  return fabric;
}

std::vector<PathSample> traced(const Scene& scene, const Medium& medium, uint32_t samples) {
  std::vector<PathSample> all;
  test::forEachSample(scene, medium, kSize, samples,
                      [&](int, int, const PathSample& sample) { all.push_back(sample); });
  return all;
}

void expectSame(const std::vector<PathSample>& seen, const std::vector<PathSample>& expected) {
  for (size_t i = 0; i < seen.size(); ++i) {
    EXPECT_EQ(seen[i].direct + seen[i].indirect, expected[i].direct + expected[i].indirect);
    EXPECT_EQ(seen[i].depth_mm, expected[i].depth_mm);
  }
}

TEST(CloseUp, FromAfarItIsTheVolumeToTheBit) {
  const auto scene = test::sceneOf(seenAt(5));  // a pixel is 0.2 mm wide
  expectSame(traced(*scene, CloseUpMedium(scene->cloth), 2), traced(*scene, LoomlightMedium(scene->cloth), 2));
  EXPECT_EQ(scene->cloth->fibres->made(), 0u);
}

TEST(CloseUp, FromNearTheFirstMeetingsAreThoseAmongFibresToTheBit) {
  Fabric fabric = seenAt(0.15);  // a pixel is 6 um wide, fibres are more
  fabric.render.maxDepth = CloseUpMedium::kMeetings - 1;
  const auto scene = test::sceneOf(fabric);
  expectSame(traced(*scene, CloseUpMedium(scene->cloth), 2), traced(*scene, FibreMedium(scene->cloth), 2));
  EXPECT_GT(scene->cloth->fibres->made(), 0u);
}

/// Both draw the same numbers, so that paths differ from where the volume takes them over, and the mean of what they
/// differ by is known much better than that of either. Dark yarn shows best what shades it that is not there.
TEST(CloseUp, WhatGoesOnThroughTheVolumeKeepsItsColour) {
  Fabric fabric = seenAt(0.4);
  fabric.fibres[0].absorption_per_mm = Rgb(12.0f);
  fabric.light.kind = LightKind::dome;
  const auto scene = test::sceneOf(fabric);
  const auto among = traced(*scene, FibreMedium(scene->cloth), 128);
  const auto handedOver = traced(*scene, CloseUpMedium(scene->cloth), 128);
  double light = 0, sum = 0, squares = 0;
  const auto count = static_cast<double>(among.size());
  for (size_t i = 0; i < among.size(); ++i) {
    const double expected = (among[i].direct + among[i].indirect).g;
    const double difference = (handedOver[i].direct + handedOver[i].indirect).g - expected;
    light += expected;
    sum += difference;
    squares += difference * difference;
  }
  const double error = std::sqrt((squares - sum * sum / count) / count / (count - 1)) / (light / count);
  EXPECT_GT(squares, 0) << "the volume took over nothing";
  EXPECT_NEAR(sum / light, 0, 0.01 + 4.5 * error);
  EXPECT_LT(error, 0.007);
}

// The same numbers are drawn, so a path differs from the first fibre on that was met otherwise: at the seams of cells,
// and where roundings part at a fibre's rim. It meets a dozen fibres.
TEST(CloseUp, BricksTracePathsAsOneTreeDoes) {
  Fabric fabric = seenAt(3);  // several cells
  fabric.render.maxDepth = 8;
  const auto scene = test::sceneOf(fabric);
  const auto tree = FibreMedium::build(scene->cloth, {}, Task{});
  const FibreMedium bricks(scene->cloth);
  const auto expected = traced(*scene, *tree, 2), seen = traced(*scene, bricks, 2);
  int same = 0;
  for (size_t i = 0; i < seen.size(); ++i) {
    const float light = (expected[i].direct + expected[i].indirect).g;
    same += seen[i].events == expected[i].events &&
            std::abs((seen[i].direct + seen[i].indirect).g - light) <= 0.01f * light;
  }
  EXPECT_GT(same, 0.9 * static_cast<double>(seen.size()));
}

TEST(CloseUp, ChanceGoesFromNoneToAllAsTheEyeComesNearer) {
  const auto scene = test::sceneOf(seenAt(5));
  EXPECT_EQ(closeUpChance(*scene->cloth, 1), 0);
  EXPECT_EQ(closeUpChance(*scene->cloth, 1e-4f), 1);
  float last = 0;
  bool between = false;
  for (float width = 0.1f; width > 1e-3f; width *= 0.9f) {
    const float chance = closeUpChance(*scene->cloth, width);
    EXPECT_GE(chance, last);
    between = between || (chance > 0 && chance < 1);
    last = chance;
  }
  EXPECT_TRUE(between);
}

/// Of white fibres under white light every path is worth 1 in the mean, wherever it goes, as long as it takes light and
/// shadow by one law.
TEST(CloseUp, WhiteStaysWhite) {
  const test::WhiteLight white;
  for (const double width_mm : {0.15, 0.45}) {
    Fabric fabric = seenAt(width_mm);
    fabric.render.maxDepth = 4000;
    white.shineOn(fabric);
    const auto scene = test::sceneOf(fabric);
    const CloseUpMedium closeUp(scene->cloth);
    double sum = 0, squares = 0, count = 0;
    for (const PathSample& sample : traced(*scene, closeUp, 12)) {
      if (sample.alpha == 0) continue;
      const double value = (sample.direct + sample.indirect).g;
      sum += value;
      squares += value * value;
      ++count;
    }
    const double mean = sum / count, error = std::sqrt((squares / count - mean * mean) / count);
    EXPECT_GT(scene->cloth->fibres->made(), 0u) << width_mm;
    EXPECT_NEAR(mean, 1, 4.5 * error) << width_mm;
    EXPECT_LT(error, 0.02) << width_mm;
  }
}

TEST(CloseUp, BytesDoNotDependOnThreads) {
  const auto picture = [](int threads) {
    // A pixel is as wide as fibres are: some of its samples meet them. Each picture lays its own.
    const auto scene = test::sceneOf(seenAt(0.45));
    const auto medium = makeMedium(*scene, {}, Task{});
    Film film(kSize, kSize);
    renderUpTo(4, *scene, *medium, CameraRays(scene->fabric->camera, kSize, kSize), film, Task{{}, {}, threads});
    std::vector<Rgb> colours;
    for (int y = 0; y < kSize; ++y)
      for (int x = 0; x < kSize; ++x) colours.push_back(film.mean(x, y));
    EXPECT_GT(scene->cloth->fibres->made(), 0u);
    return colours;
  };
  EXPECT_EQ(picture(1), picture(4));
}

}  // namespace
}  // namespace loomlight
