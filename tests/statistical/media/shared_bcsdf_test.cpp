#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "render/media/fibre_medium.h"
#include "render/media/loomlight_medium.h"
#include "render/media/volume_medium.h"
#include "render/transport/path_tracer.h"
#include "tests/support/batch_around.h"
#include "tests/support/test_cloth.h"

namespace loomlight {
namespace {

Fabric dyedCloth() {
  Fabric fabric = test::whiteCotton();
  fabric.fibres[0].absorption_per_mm = Rgb(2, 10, 40);
  fabric.fibres[0].scaleTilt_deg = 2;
  fabric.yarns[0].count_tex = 10;
  fabric.drape.width_mm = fabric.drape.height_mm = 4;
  fabric.camera.distance_mm = 8;
  fabric.light.kind = LightKind::sky;
  return fabric;
}

/// A medium with one collision, given beforehand, and nothing else in the way of light; all that it does with the
/// collision is another medium's.
class OneCollision final : public Medium {
 public:
  OneCollision(const Medium& of, const Collision& collision) : of_(of), collision_(collision) {}
  std::unique_ptr<MediumBatch> batch(size_t paths) const override { return std::make_unique<Batch>(*this, paths); }

 private:
  class Batch final : public test::BatchAround {
   public:
    Batch(const OneCollision& medium, size_t paths) : BatchAround(medium.of_.batch(paths)), next_(medium.collision_) {}
    void transmit(std::span<ShadowRay> rays, TraceCounts&) override {
      for (ShadowRay& ray : rays) ray.visible = 1;
    }
    size_t offsetsAcross(uint32_t, const Collision& met, std::span<float> offsets, Random&) const override {
      offsets[0] = met.offset;
      return 1;
    }

   private:
    std::optional<Collision> fly(const PathRay&, TraceCounts&) override { return std::exchange(next_, std::nullopt); }

    std::optional<Collision> next_;
  };

  const Medium& of_;
  Collision collision_;
};

/// Collisions of rays over the cloth.
std::vector<Collision> collisions(const Scene& scene, const Medium& medium, int count) {
  const CameraRays camera(scene.fabric->camera, 64, 64);
  Random random(4);
  TraceCounts counts;
  std::vector<Collision> met;
  MediumPath path = medium.path();
  while (static_cast<int>(met.size()) < count) {
    const float x = 64 * random.uniform(), y = 64 * random.uniform();
    const Ray ray = camera.ray(x, y);
    path.begin({ray.origin, -1});
    if (const auto hit = path.collide(ray.direction, random, counts)) met.push_back(*hit);
  }
  return met;
}

// Given fibre, tangent, h and directions, light is scattered by one and the same BCSDF whatever found the fibre: to the
// last bit, straight from the lamps and on along the path.
TEST(SharedBcsdf, IsTheIdenticalForEveryMedium) {
  const auto scene = test::sceneOf(dyedCloth());
  const auto fibres = FibreMedium::build(scene->cloth, {}, Task{});
  const VolumeMedium plain(scene->cloth);
  const LoomlightMedium ours(scene->cloth);
  const CameraRays camera(scene->fabric->camera, 4, 4);
  const auto rendered = [&](const Medium& medium, const Collision& collision, uint32_t index) {
    TraceCounts counts;
    const PathSample sample = tracePath(*scene, OneCollision(medium, collision), camera, 1, 2, index, counts);
    return sample.direct + sample.indirect;
  };
  const Medium* finders[] = {fibres.get(), &plain, &ours};
  for (const Medium* finder : finders) {
    uint32_t index = 0;
    int lit = 0;
    for (const Collision& collision : collisions(*scene, *finder, 300)) {
      const Rgb truth = rendered(*fibres, collision, index);
      ASSERT_EQ(rendered(plain, collision, index), truth);
      ASSERT_EQ(rendered(ours, collision, index), truth);
      Collision other = collision;  // and nothing but what was given matters to it
      other.offset = -collision.offset;
      lit += truth != Rgb(0.0f) && rendered(*fibres, other, index) != truth;
      ++index;
    }
    EXPECT_GT(lit, 200);
  }
}

// Media whose fibres have a radius mean the same by h: how far aside of the fibre's axis the ray passes, along tangent
// x direction, in radii.
TEST(SharedBcsdf, OffsetsAreThoseOfTheRayFromTheAxis) {
  const auto scene = test::sceneOf(dyedCloth());
  const auto fibres = FibreMedium::build(scene->cloth, {}, Task{});
  const LoomlightMedium ours(scene->cloth);
  const Medium* media[] = {fibres.get(), &ours};
  for (const Medium* medium : media)
    for (const Collision& c : collisions(*scene, *medium, 500)) {
      const glm::vec3 across = glm::normalize(glm::cross(c.tangent, c.incoming));
      const float aside = glm::dot(c.place.world - c.axis, across) / c.radius_mm;
      ASSERT_NEAR(aside, c.offset, 0.02);  // places are known to about a thousandth of a radius, from 8 mm away
    }
}

// Where a yarn is thick its explicit fibres are, and light leaves them from the surface that it came to.
TEST(SharedBcsdf, RadiiAreThoseOfTheFibresThatAreLaid) {
  Fabric uneven = dyedCloth();
  for (Yarn& yarn : uneven.yarns) yarn.evennessCv_percent = 25;
  const auto scene = test::sceneOf(uneven);
  const ClothGeometry& geometry = scene->cloth->volume->geometry();
  for (const FibreExtent extent : {FibreExtent::wholePiece, FibreExtent::bricks}) {
    const auto fibres = FibreMedium::build(scene->cloth, {std::numeric_limits<double>::infinity(), extent}, Task{});
    int thicker = 0;
    for (const Collision& c : collisions(*scene, *fibres, 100)) {
      const YarnCellKey key = geometry.key(c.yarnId.system, c.pick, c.end);
      ASSERT_EQ(c.radius_mm, geometry.strands(key).fibreRadius_mm);
      thicker += c.radius_mm > 1.05f * c.optics.fibreRadius_mm;
    }
    EXPECT_GT(thicker, 10);
  }
}

}  // namespace
}  // namespace loomlight
