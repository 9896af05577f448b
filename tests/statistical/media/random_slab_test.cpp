#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "render/media/fibre_exit.h"
#include "render/media/fibre_medium.h"
#include "render/media/loomlight_medium.h"
#include "render/media/volume_medium.h"
#include "render/optics/fibre_frame.h"
#include "tests/support/fibre_oracle.h"
#include "tests/support/test_cloth.h"

namespace loomlight {
namespace {

/// The inside of one thick straight yarn of 2000 fibres laid at random, few of them to the volume: parallel lines, as
/// random as lines can be (a Boolean model). A way of length L through them meets 2 r L n / A on average, n of them in
/// a section A; how many, is Poisson. So a slab of the thickness L lets exp(-sigma L) through, sigma = 2 r n / A, and
/// what goes straight on after exactly one fibre is sigma L exp(-sigma L) times that fibre's BCSDF.
class RandomSlab : public testing::Test {
 protected:
  static Fabric fabric() {
    Fabric f = test::whiteCotton();
    Yarn& yarn = f.yarns[0];
    yarn.fibresPerPly = 6000;
    yarn.packing = 0.5;
    yarn.flattening = 1;
    yarn.plyTwist_per_m = 0;
    yarn.layout = FibreLayout::random;
    f.fibres[0].radius_um = 5;
    f.weave = Weave(std::vector<Weave::Row>{Weave::Row{1}});  // nothing interlaces: straight yarns
    f.ends_per_cm = f.picks_per_cm = 1;
    f.drape.width_mm = f.drape.height_mm = 10;
    f.render.resolution = 16;
    return f;
  }

  RandomSlab() {
    const test::FibreOracle oracle(*scene);
    std::vector<glm::dvec3> crossings;  // of the section at kSection by the end's fibres
    for (const auto& s : oracle.segments())
      if (s.system == System::warp && std::min(s.a.y, s.b.y) <= kSection && std::max(s.a.y, s.b.y) > kSection)
        crossings.push_back(s.a + (kSection - s.a.y) / (s.b.y - s.a.y) * (s.b - s.a));
    for (const glm::dvec3& c : crossings) centre += c / static_cast<double>(crossings.size());
    radius = oracle.segments()[0].radius;
    glm::dvec3 reach(0);  // the section is an ellipse, in which the fibres are as dense everywhere
    for (const glm::dvec3& c : crossings) reach = glm::max(reach, glm::abs(c - centre));
    // No voxel that a way comes through reaches out of it.
    const glm::vec3 voxel = scene->cloth->volume->grid().size_mm;
    inner = std::min(reach.x, reach.z) - std::hypot(voxel.x, voxel.z);
    for (const glm::dvec3& c : crossings) inside += glm::distance(c, centre) < inner;
    sigma = 2 * radius * inside / (kPi * inner * inner);
  }

  /// A way across the fibres that lies inside.
  struct Way {
    ScenePoint from{};
    glm::vec3 direction;
  };
  Way anyWay(double length, Random& random) const {
    for (;;) {
      const double u = 2 * random.uniformDouble() - 1, v = 2 * random.uniformDouble() - 1;
      const double angle = 2 * kPi * random.uniformDouble(), along = random.uniformDouble();
      const glm::dvec3 start = inner * glm::dvec3(u, 0, v), direction(std::cos(angle), 0, std::sin(angle));
      if (glm::length(start) > inner || glm::length(start + length * direction) > inner) continue;
      Way way{{}, glm::vec3(direction)};
      way.from = {glm::vec3(centre + start + glm::dvec3(0, along, 0)), 0};
      return way;
    }
  }

  /// Standard error of a share of ways that `ways` of them have: that of as many draws, or of as many places in the
  /// section that do not see the same fibres (each 2 r by L, twice that apart), whichever there are fewer of.
  double standardError(double share, double length, int ways) const {
    const double places = kPi * inner * inner / (2 * 2 * radius * length);
    return std::sqrt(share * (1 - share) * (1.0 / ways + 1.0 / places));
  }

  static constexpr double kSection = 2;  // mm from the pick: nothing but the end is there
  std::shared_ptr<const Scene> scene = test::sceneOf(fabric());
  glm::dvec3 centre{0};
  double radius = 0, inner = 0, sigma = 0;
  int inside = 0;
  std::unique_ptr<const Medium> fibres = FibreMedium::build(scene->cloth, {}, Task{});
  VolumeMedium plain{scene->cloth};
  LoomlightMedium ours{scene->cloth};
  const std::pair<const char*, const Medium*> media[3] = {
      {"fibres", fibres.get()}, {"plain volume", &plain}, {"loomlight", &ours}};
};

TEST_F(RandomSlab, LetsTheExponentialOfItsDepthThrough) {
  ASSERT_GT(inside, 1000);
  for (const auto& [name, medium] : media)
    for (const double radii : {2.0, 5.0, 10.0}) {
      const double length = radii * radius, expected = std::exp(-sigma * length);
      constexpr int kWays = 20000;
      Random random(17);
      TraceCounts counts;
      double through = 0;
      MediumPath path = medium->path();
      for (int i = 0; i < kWays; ++i) {
        const Way way = anyWay(length, random);
        path.begin(way.from);
        through += path.transmittance(way.direction, static_cast<float>(length), random, counts);
      }
      EXPECT_NEAR(through / kWays, expected, 3 * standardError(expected, length, kWays)) << name << ", " << radii;
    }
}

TEST_F(RandomSlab, ScattersOnceToFirstOrderInItsDepth) {
  const FibreFrame frame(glm::vec3(0, 1, 0));
  const FibreBcsdf& bcsdf = *scene->cloth->materials[0].bcsdf;
  const glm::vec3 wi = frame.toLocal({0, 0, -1}), wo = frame.toLocal({0, 0, 1});  // straight on, across the fibre
  double forward = 0;
  constexpr int kOffsets = 2000;
  for (int i = 0; i < kOffsets; ++i)
    forward += bcsdf.evaluate(wo, wi, static_cast<float>(2 * (i + 0.5) / kOffsets - 1)).sum() / kOffsets;
  for (const auto& [name, medium] : media)
    for (const double radii : {2.0, 5.0}) {
      const double length = radii * radius;
      constexpr int kWays = 40000;
      Random random(19);
      TraceCounts counts;
      double once = 0, light = 0, squares = 0;
      MediumPath path = medium->path();
      for (int i = 0; i < kWays; ++i) {
        const Way way = anyWay(length, random);
        path.begin(way.from);
        const auto hit = path.collide(way.direction, random, counts);
        if (!hit || hit->distance_mm >= length) continue;
        const FibreFrame own(hit->tangent);
        const float value = bcsdf.evaluate(own.toLocal(-way.direction), own.toLocal(way.direction), hit->offset).sum();
        path.leave(*hit, way.direction, traverse_radii(*scene->cloth, *hit));
        const float rest = static_cast<float>(length) - hit->distance_mm;
        const float free = path.transmittance(way.direction, rest, random, counts);
        once += free;
        light += free * value;
        squares += free * value * free * value;
      }
      const double expected = sigma * length * std::exp(-sigma * length);
      const double error = standardError(expected, length, kWays);
      EXPECT_NEAR(once / kWays, expected, 3 * error) << name << ", " << radii;
      const double mean = light / kWays, noise = std::sqrt((squares / kWays - mean * mean) / kWays);
      EXPECT_NEAR(mean, expected * forward, 3 * std::hypot(noise, error * forward)) << name << ", " << radii;
    }
}

}  // namespace
}  // namespace loomlight
