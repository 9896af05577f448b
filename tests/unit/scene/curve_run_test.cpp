#include "render/scene/curve_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "core/base/random.h"
#include "tests/support/any_direction.h"

namespace loomlight {
namespace {

constexpr float kRadius = 0.006f;  // of a fine fibre, mm
constexpr int kRunPoints = CurveRun::kSegments + 1;

/// A curve of two runs, the second one of three segments.
class Curve {
 public:
  explicit Curve(std::vector<glm::vec3> points)
      : points_(std::move(points)),
        runs_{CurveRun(std::span(points_).first(kRunPoints), kRadius),
              CurveRun(std::span(points_).subspan(CurveRun::kSegments), kRadius)} {}
  /// Segments are of half a radius to 70, as in the wardrobe, and turn by up to some 60 degrees, as hardly a fibre
  /// does.
  static Curve random(Random& random) {
    std::vector<glm::vec3> points{0.05f * test::anyDirection(random)};
    glm::vec3 direction = test::anyDirection(random);
    while (points.size() < 8) {
      points.push_back(points.back() + 0.5f * kRadius * std::pow(140.0f, random.uniform()) * direction);
      direction = glm::normalize(direction + 0.8f * test::anyDirection(random));
    }
    return Curve(points);
  }
  static Curve straight() {
    std::vector<glm::vec3> points;
    for (int i = 0; i < 8; ++i) points.emplace_back(0.01f * static_cast<float>(i), 0, 0);
    return Curve(points);
  }

  const std::vector<glm::vec3>& points() const { return points_; }

  struct Hit {
    float t;
    int segment;
    glm::vec3 normal;
  };
  /// The nearest hit from the ray's origin on.
  std::optional<Hit> meet(glm::vec3 origin, glm::vec3 direction) const {
    std::optional<Hit> nearest;
    for (int run = 0; run < 2; ++run) {
      const CurveRun::Hits hits = runs_[run].meet(origin, direction, {0, run == 0, run == 1}, &runs_[0]);
      for (unsigned i = 0; i < CurveRun::kSegments; ++i) {
        if (!(hits.segments >> i & 1) || hits.t[i] < 0 || (nearest && hits.t[i] >= nearest->t)) continue;
        nearest = {hits.t[i], run * CurveRun::kSegments + static_cast<int>(i), hits.normal[i]};
      }
    }
    return nearest;
  }

  /// From a point to the surface, negative within. Knows nothing of runs, cylinders and balls.
  double distance(glm::dvec3 p) const {
    double least = std::numeric_limits<double>::infinity();
    for (size_t i = 0; i + 1 < points_.size(); ++i) {
      const glm::dvec3 a = points_[i], axis = glm::dvec3(points_[i + 1]) - a;
      const double on = std::clamp(glm::dot(p - a, axis) / glm::dot(axis, axis), 0.0, 1.0);
      least = std::min(least, glm::length(p - a - on * axis));
    }
    return least - static_cast<double>(kRadius);
  }

 private:
  std::vector<glm::vec3> points_;
  CurveRun runs_[2];
};

/// Where a ray comes to the curve, found by steps of its distance; the least distance where it does not.
struct March {
  std::optional<double> t;
  double least = std::numeric_limits<double>::infinity();

  /// How deep the ray gets below the surface behind t before it comes out again.
  double depth(const Curve& curve, glm::dvec3 origin, glm::dvec3 direction) const {
    double deepest = 0;
    constexpr double kStep = 1e-6;
    for (double at = t.value_or(0) + kStep;; at += kStep) {
      const double distance = curve.distance(origin + at * direction);
      if (distance > 0) return deepest;
      deepest = std::max(deepest, -distance);
    }
  }

  March(const Curve& curve, glm::dvec3 origin, glm::dvec3 direction) {
    for (double at = 0; at < 6;) {
      const double distance = curve.distance(origin + at * direction);
      least = std::min(least, distance);
      if (distance < 1e-9) {
        t = at;
        return;
      }
      at += distance;
    }
  }
};

/// By how much the distance of a ray from the curve may be off, mm. It begins half a millimetre away, of which four
/// roundings of 6e-8 count, over the sine of its angle to a segment. Rays that pass by this near may be taken for hits,
/// and those that are within by as little for none.
double rounding(const Curve& curve, glm::vec3 direction) {
  double leastSine = 1;
  for (size_t i = 0; i + 1 < curve.points().size(); ++i) {
    const glm::dvec3 axis = glm::normalize(glm::dvec3(curve.points()[i + 1]) - glm::dvec3(curve.points()[i]));
    leastSine = std::min(leastSine, glm::length(glm::cross(axis, glm::dvec3(direction))));
  }
  return 4 * 6e-8 * 0.5 / leastSine;
}

TEST(CurveRun, IsMetWhereItsDistanceIsNone) {
  Random random(1);
  int hits = 0, unsure = 0, atJoints = 0;
  constexpr int kRays = 20'000;
  for (int i = 0; i < kRays; ++i) {
    const Curve curve = Curve::random(random);
    const size_t target = static_cast<size_t>(7 * random.uniform());
    const glm::vec3 to = glm::mix(curve.points()[target], curve.points()[target + 1], random.uniform()) +
                         1.2f * kRadius * test::anyDirection(random);
    // Every other ray goes along a segment, nearly: there rounding counts most.
    const glm::vec3 axis = glm::normalize(curve.points()[target + 1] - curve.points()[target]);
    const glm::vec3 direction =
        i % 2 == 0 ? test::anyDirection(random) : glm::normalize(axis + 0.1f * test::anyDirection(random));
    const glm::vec3 origin = to - 0.05f * direction;
    const double slack = rounding(curve, direction);
    if (curve.distance(origin) < slack) continue;
    const March expected(curve, origin, direction);
    const auto hit = curve.meet(origin, direction);
    if (hit.has_value() != expected.t.has_value()) {
      ++unsure;
      // A ray that it meets by mistake passes by closely; one that passes by mistake would be within for a little only.
      EXPECT_LT(expected.t ? expected.depth(curve, origin, direction) : expected.least, slack) << i;
      continue;
    }
    if (!hit) continue;
    ++hits;
    const glm::dvec3 place = glm::dvec3(origin) + static_cast<double>(hit->t) * glm::dvec3(direction);
    ASSERT_NEAR(curve.distance(place), 0, slack) << i;
    // No surface is passed over, but one that it grazes.
    if (static_cast<double>(hit->t) > *expected.t + 1e-4) {
      ASSERT_LT(expected.depth(curve, origin, direction), slack) << i;
    }
    // The normal is from the axis of the very segment to the surface, and towards the ray.
    const glm::vec3 a = curve.points()[static_cast<size_t>(hit->segment)],
                    b = curve.points()[static_cast<size_t>(hit->segment) + 1];
    const glm::vec3 foot = glm::vec3(place) - hit->normal;
    const float on = glm::dot(foot - a, b - a) / glm::dot(b - a, b - a);
    ASSERT_NEAR(static_cast<double>(glm::length(hit->normal)), static_cast<double>(kRadius), slack) << i;
    ASSERT_LT(glm::length(foot - glm::mix(a, b, on)), 1e-3f * kRadius) << i;
    ASSERT_TRUE(on > -1e-3f && on < 1.001f) << i;
    ASSERT_LT(glm::dot(hit->normal, direction), 1e-3f * kRadius) << i;
    atJoints += on < 1e-3f;
  }
  EXPECT_GT(hits, kRays / 3);
  EXPECT_GT(atJoints, kRays / 100);
  EXPECT_LT(unsure, kRays / 1000);
}

// A ray that comes out of the next cell is inside of a fibre that goes on, and comes to nothing of it.
TEST(CurveRun, IsNotMetFromInside) {
  const Curve curve = Curve::straight();
  Random random(2);
  for (int i = 0; i < 2000; ++i) {
    const glm::vec3 within(0.07f * random.uniform(), 0, 0);
    const glm::vec3 origin = within + 0.9f * kRadius * std::cbrt(random.uniform()) * test::anyDirection(random);
    EXPECT_FALSE(curve.meet(origin, test::anyDirection(random))) << i;
    // A ray along the curve goes through all joints, also just below the surface.
    const glm::vec3 along(random.uniform() < 0.5f ? 1 : -1, 0, 0);
    EXPECT_FALSE(curve.meet(origin, along)) << i;
    const glm::vec3 below = 0.9999f * kRadius * glm::normalize(glm::cross(along, test::anyDirection(random)));
    EXPECT_FALSE(curve.meet(within + below, along)) << i;
  }
}

// Rays go right through the planes in which two segments meet: rounding leaves no crack in between.
TEST(CurveRun, HasNoCracksBetweenSegments) {
  Random random(3);
  for (int i = 0; i < 20'000; ++i) {
    // In line, along some direction whose multiples are rounded.
    const glm::vec3 direction = test::anyDirection(random);
    std::vector<glm::vec3> points;
    for (int k = 0; k < 8; ++k) points.push_back(0.01f * static_cast<float>(k) * direction);
    const Curve curve(points);
    const glm::vec3 joint = points[1 + static_cast<size_t>(6 * random.uniform())];
    const glm::vec3 side = glm::normalize(glm::cross(direction, test::anyDirection(random)));
    EXPECT_TRUE(curve.meet(joint + 0.3f * side, -side)) << i;
  }
}

// Where a run has fewer segments than it could, there is nothing more of it.
TEST(CurveRun, EndsAtItsLastPoint) {
  const std::vector<glm::vec3> points{{0, 0, 0}, {0.02f, 0, 0}};
  const CurveRun run(points, kRadius);
  for (const bool ends : {true, false}) {
    const auto met = [&](float x) { return run.meet({x, 0, 1}, {0, 0, -1}, {0, true, ends}, nullptr).segments; };
    EXPECT_EQ(met(0.01f), 1u);
    EXPECT_EQ(met(0.02f + 0.5f * kRadius), ends ? 1u : 0u);
    EXPECT_EQ(met(0.02f + 1.5f * kRadius), 0u);
    EXPECT_EQ(met(-0.5f * kRadius), 1u);
  }
}

}  // namespace
}  // namespace loomlight
