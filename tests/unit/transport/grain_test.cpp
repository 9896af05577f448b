#include <gtest/gtest.h>

#include <cmath>

#include "core/base/units.h"
#include "render/film/image.h"
#include "render/scene/scene.h"
#include "render/transport/make_medium.h"
#include "render/transport/path_tracer.h"

namespace loomlight {
namespace {

/// Which way the fibres go that are seen on top of a cylinder of ends without a twist, which hide all picks: an angle
/// from +y to the left, in degrees from -90 to 90.
double wayOfFibres_deg(double grain_deg) {
  auto fabric = std::make_shared<Fabric>();
  fabric->weave = Weave(std::vector<Weave::Row>{{1}});
  fabric->yarns[0].plyTwist_per_m = fabric->yarns[0].yarnTwist_per_m = 0;
  fabric->yarns[0].hairiness_per_mm = 0;
  fabric->drape.kind = DrapeKind::cylinder;
  fabric->drape.width_mm = fabric->drape.height_mm = 12;
  fabric->drape.grain_deg = grain_deg;
  fabric->camera.elevation_deg = 90;
  fabric->camera.distance_mm = 8;
  fabric->light.kind = LightKind::dome;
  fabric->render.resolution = 4;
  constexpr int kSide = 16;  // of one sample each: signs of tangents are left to chance, and means of them say nothing
  const auto scene = makeScene(fabric, Task{});
  const auto medium = makeMedium(*scene, 1e9, Task{});
  Film film(kSide, kSide);
  EXPECT_TRUE(renderUpTo(1, *scene, *medium, CameraRays(fabric->camera, kSide, kSide), film, Task{}).complete);
  // A fibre goes both ways, so angles are averaged at twice their size.
  const Image image = film.toImage(false);
  double cosines = 0, sines = 0;
  const std::vector<float>&x = image.find("tangent.X")->values, &y = image.find("tangent.Y")->values;
  for (size_t i = 0; i < x.size(); ++i) {
    cosines += double{y[i]} * y[i] - double{x[i]} * x[i];
    sines += -2.0 * x[i] * y[i];
  }
  return std::atan2(sines, cosines) / 2 * 180 / kPi;
}

TEST(Grain, TurnsTheFibresThatAreSeen) {
  // A fibre that strays by 20 degrees, a far larger angle than any here, in each of 256 pixels alone leaves the mean
  // within 20 / 16 degrees. All pixels show cloth, at most 13 degrees from the top; its slope there turns a way by .7
  // degrees in the picture.
  constexpr double kWithin_deg = 1.5;
  for (const double grain_deg : {0.0, 30.0, -45.0, 75.0})
    EXPECT_NEAR(wayOfFibres_deg(grain_deg), grain_deg, kWithin_deg);
  EXPECT_NEAR(std::abs(wayOfFibres_deg(90)), 90, kWithin_deg);
}

}  // namespace
}  // namespace loomlight
