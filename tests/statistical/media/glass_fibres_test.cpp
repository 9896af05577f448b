#include "tests/support/glass_fibres.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/base/parallel.h"
#include "render/scene/pixel_filter.h"
#include "render/transport/path_tracer.h"
#include "tests/support/every_medium.h"
#include "tests/support/sampled_mean.h"

namespace loomlight {
namespace {

constexpr int kSide = 64;
constexpr uint32_t kBatch = PathIntegrator::kBatch;

/// Dyed filaments as smooth as the renderer has them, lightly twisted, in a plain weave.
Fabric filaments() {
  Fabric fabric;
  Fibre& fibre = fabric.fibres[0];
  fibre.radius_um = 8;
  fibre.absorption_per_mm = Rgb(2, 4, 8);
  fibre.longitudinalRoughness = fibre.azimuthalRoughness = 0.05;
  Yarn& yarn = fabric.yarns[0];
  yarn.fibresPerPly = 30;
  yarn.packing = 0.6;
  yarn.plyTwist_per_m = 200;
  fabric.ends_per_cm = fabric.picks_per_cm = 35;
  fabric.drape.width_mm = fabric.drape.height_mm = 2.5;
  fabric.camera.distance_mm = 5;
  fabric.camera.azimuth_deg = -60;
  fabric.camera.elevation_deg = 55;
  fabric.render.resolution = 1;
  test::kFibres.askFor(fabric);
  return fabric;
}

/// What the paths of a pixel bring, in groups of kGroup: the mean of each. Numbers are stratified over the paths of a
/// group, so its mean is nearer to the truth than as many paths that know nothing of each other.
using Pixel = std::vector<glm::dvec3>;
constexpr uint32_t kGroup = 64;
static_assert(kBatch % kGroup == 0);
void add(Pixel& pixel, uint32_t path, const Rgb& colour) {
  if (path % kGroup == 0) pixel.emplace_back(0);
  pixel.back() += glm::dvec3(colour) / double{kGroup};
}
/// Row by row.
using Picture = std::vector<Pixel>;

template <class PixelAt>
Picture pictureOf(PixelAt&& pixelAt) {
  Picture picture(size_t{kSide} * kSide);
  parallelFor(kSide, 0, [&](size_t y) {
    for (size_t x = 0; x < kSide; ++x) picture[y * kSide + x] = pixelAt(static_cast<int>(x), static_cast<int>(y));
  });
  return picture;
}

Picture rendered(const Scene& scene, uint32_t samples) {
  const auto fibres = test::kFibres.make(scene);
  const CameraRays camera(scene.fabric->camera, kSide, kSide);
  return pictureOf([&](int x, int y) {
    PathTracer tracer(scene, *fibres, camera, kBatch);
    TraceCounts counts;
    Pixel pixel;
    for (uint32_t first = 0; first < samples; first += kBatch) {
      std::vector<PixelSample> batch;
      for (uint32_t i = 0; i < kBatch; ++i) batch.push_back({x, y, first + i, nullptr});
      tracer.trace(batch, counts);
      for (uint32_t i = 0; i < kBatch; ++i) add(pixel, first + i, tracer.sample(i).direct + tracer.sample(i).indirect);
    }
    return pixel;
  });
}

Picture rayTraced(const Scene& scene, uint32_t samples) {
  const Fibre& fibre = scene.fabric->fibres[0];
  const test::GlassFibres glass(scene.cloth->volume->geometry(), *scene.cloth->shell, fibre.refractiveIndex);
  const CameraRays camera(scene.fabric->camera, kSide, kSide);
  return pictureOf([&](int x, int y) {
    // As the tracer draws them: path i of either picture comes along the same ray.
    const uint64_t number = hashCombine(hashCombine(hashCombine(scene.fabric->render.seed, x), y), 0);
    Pixel pixel;
    for (uint32_t i = 0; i < samples; ++i) {
      Random random(number, i);
      random.stratify(0, PathIntegrator::kFirstDimension);
      const float u = random.uniform(), v = random.uniform();
      const glm::vec2 place = glm::vec2(x, y) + TriangleFilter::sample({u, v});
      const Ray ray = camera.ray(place.x, place.y);
      const auto path = glass.follow(ray.origin, ray.direction, random);
      EXPECT_TRUE(path.escaped);
      const Rgb arriving = path.met ? scene.lighting->escape(glm::vec3(path.direction)) : Rgb(0);
      add(pixel, i, arriving * glm::exp(-fibre.absorption_per_mm.primaries * static_cast<float>(path.inside_mm)));
    }
    return pixel;
  });
}

/// Passes where the mean colours are known to differ by less than `most`, a fraction. Both are of the same fibres: that
/// one pixel differs by more than another is no noise, but that the groups of a pixel do is. Those of both pictures
/// come along the same rays, and so are compared in pairs.
void expectWithin(double most, const Picture& ours, const Picture& truth) {
  constexpr double kDeviations = 3.3;
  for (int c = 0; c < 3; ++c) {
    double difference = 0, variance = 0, sum = 0;
    for (size_t pixel = 0; pixel < truth.size(); ++pixel) {
      test::SampledMean off;
      for (size_t group = 0; group < truth[pixel].size(); ++group) {
        off.add(ours[pixel][group][c] - truth[pixel][group][c]);
        sum += truth[pixel][group][c] / static_cast<double>(truth[pixel].size());
      }
      difference += off.mean();
      variance += std::pow(off.standardError(), 2);
    }
    const double off = difference / sum, noise = std::sqrt(variance) / sum;
    EXPECT_LT(std::abs(off) + kDeviations * noise, most) << "channel " << c << ": " << off << " +- " << noise;
  }
}

// The truth that no statistics can fool: fibres by their BCSDF against glass cylinders, surface by surface, through the
// very same cloth. What fibres absorb depends on how far light goes in them, hence on how many it meets and where it
// leaves them; where it goes, on their lobes. The furnace is the same to 0.1 % (+- 0.1, a million paths), and the dome
// 0.6 % brighter (+- 0.1, five million): no fibre of ours is smooth. Light that set out where it came in would make
// both 4 to 5 % brighter.
TEST(GlassFibres, AreWhatSmoothFibresLookLike) {
  Fabric fabric = filaments();
  fabric.light.kind = LightKind::furnace;
  const auto inFurnace = test::sceneOf(fabric);
  expectWithin(0.005, rendered(*inFurnace, kBatch), rayTraced(*inFurnace, kBatch));
  fabric.light.kind = LightKind::dome;
  const auto underDome = test::sceneOf(fabric);
  constexpr uint32_t kLong = 5 * kBatch;  // what is known to part them leaves noise little room
  expectWithin(0.01, rendered(*underDome, kLong), rayTraced(*underDome, kLong));
}

}  // namespace
}  // namespace loomlight
