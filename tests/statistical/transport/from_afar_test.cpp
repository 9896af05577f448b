/// Cloth from so far away that pixels are wider than threads: what should be seen of these, and what should not.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <vector>

#include "core/fabric/json/fabric_json.h"
#include "render/film/film.h"
#include "render/transport/make_medium.h"
#include "render/transport/path_tracer.h"
#include "tests/support/test_cloth.h"

namespace loomlight {
namespace {

constexpr int kPixels = 64;  ///< of a picture, on a side

/// Flat, from straight above, under the same light from everywhere.
Fabric seenFlat(Fabric fabric, double pixel_mm) {
  const double seen_mm = kPixels * pixel_mm;
  fabric.drape = Drape{};
  fabric.drape.width_mm = fabric.drape.height_mm = 1.1 * seen_mm + 4;
  fabric.light = Light{};
  fabric.light.kind = LightKind::dome;
  fabric.camera = Camera{};
  fabric.camera.azimuth_deg = -90;
  fabric.camera.elevation_deg = 90;
  fabric.camera.fov_deg = 0;
  fabric.camera.distance_mm = seen_mm / (2 * std::tan(10 * kPi / 180));  // as a field of view of 20 degrees shows
  fabric.render.resolution = 4;
  return fabric;
}

Film traced(const Scene& scene, uint32_t samples) {
  const auto medium = makeMedium(scene, {}, Task{});
  Film film(kPixels, kPixels);
  renderUpTo(samples, scene, *medium, CameraRays(scene.fabric->camera, kPixels, kPixels), film, Task{});
  return film;
}

/// Green, of each column or row of pixels, relative to their mean.
enum class Along { columns, rows };
std::vector<double> profile(const Film& film, Along along) {
  std::vector<double> sums(kPixels);
  double all = 0;
  for (int y = 0; y < kPixels; ++y)
    for (int x = 0; x < kPixels; ++x) {
      const double light = film.mean(x, y).g;
      sums[static_cast<size_t>(along == Along::columns ? x : y)] += light;
      all += light;
    }
  for (double& sum : sums) sum = sum * kPixels / all - 1;
  return sums;
}

/// Amplitude of the wave of so many cycles a pixel.
double amplitude(const std::vector<double>& profile, double cycles) {
  std::complex<double> sum = 0;
  for (size_t i = 0; i < profile.size(); ++i)
    sum += profile[i] * std::polar(1.0, -2 * kPi * cycles * static_cast<double>(i));
  return 2 * std::abs(sum) / static_cast<double>(profile.size());
}

// Black warp and white weft in turn, two picks a stripe: 2.54 stripes a pixel look like waves of 1 / 0.46 pixels where
// they are sampled too coarsely. What is positive has waves of no more than twice its mean, of which the filter leaves
// sinc^2 (2.54): 3 %. The mean over the pixels' own squares would leave 12 % of stripes that are nearly that strong.
TEST(FromAfar, ThreadsFinerThanPixelsLeaveNoMoire) {
  constexpr double kStripesAPixel = 2.54;
  Fabric fabric = test::whiteCotton();
  fabric.weave = Weave({{1, 1}, {0, 0}});
  fabric.fibres.push_back(fabric.fibres[0]);
  fabric.fibres[1].absorption_per_mm = Rgb(200.0f);
  fabric.yarns.push_back(fabric.yarns[0]);
  fabric.yarns[1].fibre = 1;
  fabric.warpSequence = {1};
  fabric.weftSequence = {0};
  fabric.drape = Drape{};
  const auto scene = test::sceneOf(seenFlat(fabric, 2 * kStripesAPixel * fabric.weftPitch_mm()));
  const std::vector<double> rows = profile(traced(*scene, 48), Along::rows);
  // Rows are independent: where there is nothing to be seen the amplitude is what noise makes of it.
  double squares = 0;
  for (size_t i = 1; i < rows.size(); ++i) squares += 0.5 * (rows[i] - rows[i - 1]) * (rows[i] - rows[i - 1]);
  const double noise = std::sqrt(squares / static_cast<double>(rows.size() - 1)) * std::sqrt(2.0 / kPixels);
  const double box = std::sin(kPi * kStripesAPixel) / (kPi * kStripesAPixel);
  EXPECT_LT(amplitude(rows, kStripesAPixel), 2 * box * box + 2 * noise);
  EXPECT_LT(2 * box * box + 2 * noise, 0.5 * std::abs(box)) << "too noisy to tell";
}

/// Variance of the columns' or rows' light, free of noise: two pictures that share nothing but the cloth. And how far
/// noise may take it off: the standard deviation of what it would be if columns were alike.
struct Streaks {
  double variance, noise;
};
Streaks streaks(const std::array<Film, 2>& films, Along along) {
  const std::vector<double> a = profile(films[0], along), b = profile(films[1], along);
  double both = 0, first = 0, second = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    both += a[i] * b[i] / kPixels;
    first += a[i] * a[i] / kPixels;
    second += b[i] * b[i] / kPixels;
  }
  return {both, std::sqrt(first * second / kPixels)};
}

/// By how much the one is more streaked than the other, over how far noise may take that off.
double sigmasMore(const Streaks& one, const Streaks& other) {
  return (one.variance - other.variance) / std::hypot(one.noise, other.noise);
}

std::array<Film, 2> twice(Fabric fabric, uint32_t samples) {
  std::array<Film, 2> films{Film(kPixels, kPixels), Film(kPixels, kPixels)};
  std::shared_ptr<const Scene> scene;
  for (uint64_t seed = 0; seed < 2; ++seed) {
    fabric.render.seed = seed;
    scene = makeScene(std::make_shared<const Fabric>(fabric), Task{}, scene.get());
    films[seed] = traced(*scene, samples);
  }
  return films;
}

// At arm's length, a pixel a millimetre, denim has streaks along its warp: more than the 1 % that an eye can just see,
// and more than across. The same cloth of even yarns has hardly any.
TEST(FromAfar, DenimIsStreakedAlongItsWarp) {
  Fabric denim = readFabric(std::string(LOOMLIGHT_SAMPLES) + "/cloths/denim_raw.json");
  const std::array<Film, 2> films = twice(seenFlat(denim, 1), 192);
  denim.settCv_percent = 0;
  for (Yarn& yarn : denim.yarns) yarn.evennessCv_percent = yarn.slubs_per_m = yarn.shadeVariation_percent = 0;
  const Streaks along = streaks(films, Along::columns), even = streaks(twice(seenFlat(denim, 1), 128), Along::columns);
  EXPECT_GT(along.variance, 0.02 * 0.02);
  EXPECT_GT(sigmasMore(along, streaks(films, Along::rows)), 3);
  EXPECT_GT(sigmasMore(along, even), 3);
}

}  // namespace
}  // namespace loomlight
