#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/random.h"
#include "core/shell/drape_surface.h"
#include "render/scene/shell_entry.h"
#include "tests/support/any_direction.h"

namespace loomlight {
namespace {

struct Interval {
  double from, to;
};

double length(const std::vector<Interval>& intervals) {
  double sum = 0;
  for (const Interval& i : intervals) sum += i.to - i.from;
  return sum;
}

/// Every tetrahedron by itself, in double: no adjacency, no Embree.
std::vector<Interval> bruteForce(const Shell& shell, glm::dvec3 origin, glm::dvec3 direction) {
  std::vector<Interval> parts;
  for (const Shell::Tet& tet : shell.tets()) {
    // Most are far from the ray: not within the longest edge of it.
    const glm::dvec3 any = shell.vertices()[tet.vertex[0]];
    double longest = 0;
    for (int i = 1; i < 4; ++i)
      longest = std::max(longest, glm::distance(any, glm::dvec3(shell.vertices()[tet.vertex[i]])));
    if (glm::length(glm::cross(any - origin, direction)) > longest) continue;
    double from = 0, to = 1e9;
    for (int i = 0; i < 4; ++i) {
      const glm::dvec3 corner = shell.vertices()[tet.vertex[i]];
      const glm::dvec3 a = shell.vertices()[tet.vertex[(i + 1) % 4]], b = shell.vertices()[tet.vertex[(i + 2) % 4]],
                       c = shell.vertices()[tet.vertex[(i + 3) % 4]];
      glm::dvec3 normal = glm::normalize(glm::cross(b - a, c - a));
      if (glm::dot(normal, corner - a) < 0) normal = -normal;
      const double distance = glm::dot(normal, origin - a), approach = glm::dot(normal, direction);
      if (std::abs(approach) < 1e-14) {
        if (distance < 0) to = -1;
      } else if (approach > 0) {
        from = std::max(from, -distance / approach);
      } else {
        to = std::min(to, -distance / approach);
      }
    }
    if (to > from) parts.push_back({from, to});
  }
  std::sort(parts.begin(), parts.end(), [](const Interval& a, const Interval& b) { return a.from < b.from; });
  std::vector<Interval> merged;
  for (const Interval& part : parts) {
    if (!merged.empty() && part.from < merged.back().to + 1e-7)
      merged.back().to = std::max(merged.back().to, part.to);
    else
      merged.push_back(part);
  }
  return merged;
}

struct WalkedTets {
  std::vector<Interval> inside;
  int steps = 0;
  bool ended = true;
};

/// Enter, walk, leave, enter again. `rebase`: with the origin moved along at every entry and exit.
WalkedTets walk(const Shell& shell, const ShellEntry& entry, glm::vec3 origin, glm::vec3 direction, bool rebase) {
  WalkedTets result;
  const int limit = 20000;
  double passed = 0;
  float t = 0;
  while (const auto hit = entry.enter(origin, direction, t, 1e6f)) {
    t = hit->t;
    int tet = hit->tet;
    if (rebase) {
      origin += t * direction;
      passed += t;
      t = 0;
    }
    const double from = passed + t;
    while (tet >= 0) {
      if (++result.steps > limit) {
        result.ended = false;
        return result;
      }
      int face = 0;
      t = std::max(t, shell.exit(tet, origin, direction, face));
      tet = shell.tets()[static_cast<size_t>(tet)].neighbour[face];
    }
    result.inside.push_back({from, passed + t});
    if (rebase) {
      origin += t * direction;
      passed += t;
      t = 0;
    }
  }
  return result;
}

/// A sheet folded to and fro, smooth, not developable: hills along both directions.
DrapeMesh wavySheet() {
  DrapeMesh mesh;
  const int n = 60;
  for (int row = 0; row <= n; ++row) {
    for (int column = 0; column <= n; ++column) {
      const float u = 20.0f * static_cast<float>(column) / n, v = 20.0f * static_cast<float>(row) / n;
      const float dzu = 1.8f * std::cos(u), dzv = 0.9f * std::cos(0.7f * v);
      mesh.positions.emplace_back(u - 10, v - 10, 1.8f * std::sin(u) + 0.9f / 0.7f * std::sin(0.7f * v));
      mesh.normals.push_back(glm::normalize(glm::vec3(-dzu, -dzv, 1)));
      mesh.uv_mm.emplace_back(u, v);
    }
  }
  for (uint32_t row = 0; row < n; ++row)
    for (uint32_t column = 0; column < n; ++column) {
      const uint32_t a = row * (n + 1) + column, b = a + n + 1;
      mesh.triangles.emplace_back(a, a + 1, b + 1);
      mesh.triangles.emplace_back(a, b + 1, b);
    }
  return mesh;
}

DrapeMesh named(const std::string& name) {
  Drape drape;
  drape.radius_mm = 6;
  if (name == "wavy") return wavySheet();
  if (name == "folded") return loadDrapeMesh(LOOMLIGHT_SAMPLES "/folded_cloth.obj", 1.0);
  if (name == "coil") drape.height_mm = 2 * kPi * 6;
  drape.kind = name == "sphere" ? DrapeKind::sphere : DrapeKind::cylinder;
  if (name == "sphere") drape.width_mm = drape.height_mm = 12;
  return makeDrape(drape);
}

class ShellWalk : public testing::TestWithParam<const char*> {
 protected:
  ShellWalk() : shell_(std::make_shared<const Shell>(DrapeSurface(named(GetParam())), 0.4)), entry_(shell_) {}

  /// What is walked must be the union of the tetrahedra, to within rounding at its ends.
  void expectCovered(glm::vec3 origin, glm::vec3 direction, double tolerance) {
    // A ray that grazes an edge has a length as uncertain as its distance from the edge: what rays beside it have,
    // as far off as planes and origins some 60 mm away are uncertain in float when met at a glancing angle.
    double least = length(bruteForce(*shell_, origin, direction)), most = least;
    const glm::vec3 aside = glm::normalize(glm::cross(direction, glm::vec3(0.3f, 0.5f, 0.8f)));
    for (const glm::vec3 beside : {aside, -aside, glm::cross(direction, aside), -glm::cross(direction, aside)}) {
      const double near = length(bruteForce(*shell_, origin + 1e-4f * beside, direction));
      least = std::min(least, near);
      most = std::max(most, near);
    }
    for (const bool rebase : {false, true}) {
      const WalkedTets walked = walk(*shell_, entry_, origin, direction, rebase);
      ASSERT_TRUE(walked.ended) << "a ray walks for ever";
      const double walkedLength = length(walked.inside);
      EXPECT_TRUE(walkedLength > least - tolerance && walkedLength < most + tolerance)
          << walkedLength << " is not in " << least << " .. " << most << ", from " << origin.x << ' ' << origin.y << ' '
          << origin.z << " along " << direction.x << ' ' << direction.y << ' ' << direction.z
          << (rebase ? " rebased" : "");
      for (size_t i = 1; i < walked.inside.size(); ++i)
        EXPECT_GE(walked.inside[i].from, walked.inside[i - 1].to - 1e-4);
    }
  }

  std::shared_ptr<const Shell> shell_;
  ShellEntry entry_;
};

TEST_P(ShellWalk, CoversTheUnionOfTheTetrahedra) {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const glm::vec3 target = shell_->vertices()[random.below(static_cast<uint32_t>(shell_->vertices().size()))] +
                             0.5f * test::anyDirection(random);
    const glm::vec3 direction = test::anyDirection(random);
    expectCovered(target - 60.0f * direction, direction, 2e-3);
  }
}

TEST_P(ShellWalk, HasNoCracksAtVerticesAndEdges) {
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    const Shell::Tet& tet = shell_->tets()[random.below(static_cast<uint32_t>(shell_->tets().size()))];
    const glm::vec3 a = shell_->vertices()[tet.vertex[random.below(4)]];
    const glm::vec3 b = shell_->vertices()[tet.vertex[random.below(4)]];
    const glm::vec3 origin = 60.0f * test::anyDirection(random);
    expectCovered(origin, glm::normalize(a - origin), 2e-3);
    expectCovered(origin, glm::normalize(0.5f * (a + b) - origin), 2e-3);
    // Along an edge the union is ill-defined, to the width of rounding; the walk must end all the same.
    if (a == b) continue;
    const glm::vec3 along = glm::normalize(b - a);
    for (const bool rebase : {false, true}) EXPECT_TRUE(walk(*shell_, entry_, a - 20.0f * along, along, rebase).ended);
  }
}

TEST_P(ShellWalk, EntersOnlyForward) {
  Random random(3);
  for (int i = 0; i < 300; ++i) {
    const glm::vec3 direction = test::anyDirection(random);
    const glm::vec3 origin = 30.0f * test::anyDirection(random);
    const auto hit = entry_.enter(origin, direction, 5.0f, 40.0f);
    if (!hit) continue;
    EXPECT_GE(hit->t, 5.0f);
    EXPECT_LE(hit->t, 40.0f + 1e-3f);
    int face = 0;
    EXPECT_GT(shell_->exit(hit->tet, origin, direction, face), hit->t);
  }
}

INSTANTIATE_TEST_SUITE_P(Drapes, ShellWalk, testing::Values("cylinder", "coil", "sphere", "wavy", "folded"),
                         [](const auto& info) { return std::string(info.param); });

TEST(ShellEntryFlat, IsTheSlabOfTheBox) {
  const auto shell = std::make_shared<const Shell>(Shell::flat(20, 10, 0.25));
  const ShellEntry entry(shell);
  const glm::vec3 down(0, 0, -1);
  const auto hit = entry.enter({1, 2, 5}, down, 0, 100);
  ASSERT_TRUE(hit);
  EXPECT_FLOAT_EQ(hit->t, 4.75f);
  int face = -1;
  EXPECT_FLOAT_EQ(shell->exit(0, {1, 2, 5}, down, face), 5.25f);
  EXPECT_FALSE(entry.enter({1, 2, 5}, down, 0, 4));       // too far
  EXPECT_FALSE(entry.enter({1, 2, 5}, -down, 0, 100));    // behind
  EXPECT_FALSE(entry.enter({1, 2, 0}, down, 0, 100));     // inside already
  EXPECT_FALSE(entry.enter({10.5, 2, 5}, down, 0, 100));  // beside
  EXPECT_FALSE(entry.enter({1, 2, 5}, down, 4.8f, 100));  // entered before tMin
}

}  // namespace
}  // namespace loomlight
