#include "render/scene/fibre_bricks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "render/media/shell_walk.h"
#include "render/scene/fibre_bvh.h"
#include "tests/support/any_direction.h"
#include "tests/support/test_cloth.h"

namespace loomlight {
namespace {

/// Rays from all around into a piece; more of them along the cloth than a camera's, so that they cross many cells.
Ray rayInto(const Shell& shell, Random& random) {
  const glm::vec3 lower = shell.lower_mm(), upper = shell.upper_mm();
  const auto within = [&] {
    return lower + glm::vec3(random.uniform(), random.uniform(), random.uniform()) * (upper - lower);
  };
  const glm::vec3 direction = test::anyDirection(random);
  return {within() - 30.0f * direction, direction};
}

/// The first fibre along a ray through the shell: distance in the world.
std::optional<FibreHit> meet(const TraceData& cloth, FibreBricks::Reader& reader, const Ray& ray) {
  ShellWalk walk(cloth, {ray.origin, -1}, ray.direction, 1e9f);
  while (walk.next()) {
    const ShellSegment& s = walk.segment();
    auto hit = reader.meet({s.clothOrigin, s.clothDirection, s.tEnter, s.tLeave});
    if (!hit) continue;
    hit->distance_mm += s.passed;
    return hit;
  }
  return std::nullopt;
}

struct Agreement {
  int hits = 0;         ///< of the whole tree, within the piece
  int same = 0;         ///< of those, with the same fibre in the same place
  double apart_mm = 0;  ///< sum over those
};

/// Beside the piece's edge bricks end with the piece, and the whole tree's fibres hang over: what is met there does not
/// count.
Agreement compare(const Scene& scene, int rays, float near_mm) {
  const auto bvh = FibreBvh::build(scene.cloth, planFibres(*scene.cloth, {}), Task{});
  const ClothGeometry& geometry = scene.cloth->volume->geometry();
  FibreBricks::Reader reader(*scene.cloth->fibres, *scene.cloth->volume);
  Random random(5);
  Agreement agreement;
  for (int i = 0; i < rays; ++i) {
    const Ray ray = rayInto(*scene.cloth->shell, random);
    const auto expected = bvh->meet({ray.origin, ray.direction});
    const auto hit = meet(*scene.cloth, reader, ray);
    if (!expected || expected->end < 2 || expected->end >= geometry.ends() - 2 || expected->pick < 2 ||
        expected->pick >= geometry.picks() - 2)
      continue;
    ++agreement.hits;
    const double apart = hit ? std::abs(expected->distance_mm - hit->distance_mm) : 1;
    if (!hit || expected->fibre != hit->fibre || apart > static_cast<double>(near_mm) ||
        glm::dot(expected->normal, hit->normal) < 0.9f || std::abs(glm::dot(expected->tangent, hit->tangent)) < 0.9f)
      continue;
    ++agreement.same;
    agreement.apart_mm += apart;
  }
  return agreement;
}

/// A handful of crossings, so that rays come in by the sides too.
Fabric smallPiece() {
  Fabric fabric = test::whiteCotton();
  fabric.drape.width_mm = 4;
  fabric.drape.height_mm = 3;
  fabric.yarns[0].hairiness_per_mm = 2;
  return fabric;
}

/// Where a yarn goes from cell to cell its strands end in half spheres, which in the whole tree stand out into the next
/// cell: fibres are a hundredth of a pitch thick, so one ray in some hundred comes by there, and few of these see it.
TEST(FibreBricks, MeetWhatTheWholeTreeMeets) {
  Fabric inPairs = smallPiece();
  inPairs.yarns[0].count_tex = 8;
  inPairs.warpSpacing = {1, 2};
  inPairs.weftSpacing = {1, 1.5, 1};
  for (const Fabric& fabric : {smallPiece(), inPairs}) {
    const auto scene = test::sceneOf(fabric);
    ASSERT_TRUE(scene->cloth->fibres);
    const Agreement agreement = compare(*scene, 20'000, 1e-4f);
    EXPECT_GT(agreement.hits, 3000);
    EXPECT_GT(agreement.same, 0.995 * agreement.hits);
  }
}

/// A flat cloth's part of a ray is all of it that there is.
std::optional<ClothRay> inCloth(const TraceData& cloth, const Ray& ray) {
  ShellWalk walk(cloth, {ray.origin, -1}, ray.direction, 1e9f);
  if (!walk.next()) return std::nullopt;
  const ShellSegment& s = walk.segment();
  return ClothRay{s.clothOrigin, s.clothDirection, s.tEnter, s.tLeave};
}

// 1e-4 mm are some roundings of the 30 mm from which rays come, and a hundredth of a fibre.
TEST(FibreBricks, BlockLightWhereTheyAreMetButNotThatOfTheirOwnFibre) {
  constexpr float kNear_mm = 1e-4f;
  const auto scene = test::sceneOf(smallPiece());
  FibreBricks::Reader reader(*scene->cloth->fibres, *scene->cloth->volume);
  Random random(11);
  int hits = 0, others = 0;
  for (int i = 0; i < 2000; ++i) {
    std::optional<ClothRay> ray = inCloth(*scene->cloth, rayInto(*scene->cloth->shell, random));
    if (!ray) continue;
    const auto hit = reader.meet(*ray);
    EXPECT_EQ(reader.isFree(*ray), !hit) << i;
    if (!hit) continue;
    ++hits;
    const float met = hit->distance_mm;
    ray->t1 = met - kNear_mm;
    EXPECT_TRUE(reader.isFree(*ray)) << i;
    ray->t1 = met + kNear_mm;
    EXPECT_FALSE(reader.isFree(*ray)) << i;

    // The fibre that a ray leaves is hidden from it up to a distance: first one before the fibre, then one behind it.
    ray->ownFibre = hit->fibre;
    ray->ownUntil = met - kNear_mm;
    EXPECT_FALSE(reader.isFree(*ray)) << i;
    EXPECT_TRUE(reader.meet(*ray)) << i;
    ray->ownUntil = met + 2 * kNear_mm;
    const auto another = reader.meet(*ray);
    EXPECT_EQ(reader.isFree(*ray), !another) << i;
    if (another) {
      EXPECT_NE(another->fibre, hit->fibre) << i;
    }
    others += another.has_value();
  }
  EXPECT_GT(hits, 500);
  EXPECT_LT(others, hits / 20);
}

/// On a drape the whole tree's fibres are chords between bent points, and here rays are bent, tetrahedron by
/// tetrahedron: where both lie differs by the sagitta of a triangle, so at the rim of a fibre another may be met.
TEST(FibreBricks, AreBentAsTheDrapeIs) {
  Fabric fabric = smallPiece();
  fabric.drape.kind = DrapeKind::cylinder;
  fabric.drape.radius_mm = 6;
  const auto scene = test::sceneOf(fabric);
  const Agreement agreement = compare(*scene, 20'000, 0.01f);
  EXPECT_GT(agreement.hits, 2000);
  EXPECT_GT(agreement.same, 0.97 * agreement.hits);
  EXPECT_LT(agreement.apart_mm, 1e-3 * agreement.same);
}

/// What a designer reads in place of fibres.
TEST(FibreBricks, SayWhyThereAreNone) {
  VolumeCounts counts;
  counts.segments = FibreBricks::kMostSegments;
  EXPECT_EQ(FibreBricks::whyNone(counts), "");
  counts.segments *= 2;
  EXPECT_NE(FibreBricks::whyNone(counts).find("120 million fibre segments"), std::string::npos);
}

TEST(FibreBricks, AreMadeOncePerKeyAndServeAnyWeave) {
  Fabric fabric = smallPiece();
  const auto scene = test::sceneOf(fabric);
  const FibreBricks& fibres = *scene->cloth->fibres;
  EXPECT_EQ(fibres.made(), 0u);
  FibreBricks::Reader reader(fibres, *scene->cloth->volume);
  Random random(7);
  for (int i = 0; i < 5000; ++i) meet(*scene->cloth, reader, rayInto(*scene->cloth->shell, random));
  const size_t made = fibres.made();
  EXPECT_GT(made, 0u);
  const VolumeCounts counts = scene->cloth->volume->counts();
  EXPECT_LE(made, counts.bricks);
  // A segment has at least a fourth of a run and of what goes with it, 64 and 8 bytes, and at most what is planned.
  EXPECT_GT(fibres.bytes(), 18 * counts.segments * made / counts.bricks);
  EXPECT_LT(static_cast<double>(fibres.bytes()),
            planFibres(*scene->cloth, {1e9, FibreExtent::bricks}).bytes * 1.05 + 1e6);

  fabric.weave = fabric.weave.with(0, 0, !fabric.weave.at(0, 0));
  const auto edited = makeScene(std::make_shared<const Fabric>(fabric), Task{}, scene.get());
  EXPECT_EQ(edited->cloth->fibres, scene->cloth->fibres);
  fabric.yarns[0].plyTwist_per_m += 100;
  const auto twisted = makeScene(std::make_shared<const Fabric>(fabric), Task{}, edited.get());
  EXPECT_NE(twisted->cloth->fibres, scene->cloth->fibres);
}

}  // namespace
}  // namespace loomlight
