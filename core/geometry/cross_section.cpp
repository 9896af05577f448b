#include "core/geometry/cross_section.h"

#include <algorithm>
#include <cmath>

#include "core/base/random.h"

namespace loomlight {
namespace {

using Points = std::vector<glm::dvec2>;

constexpr double kHexagonalDensity = 0.90689968;  // pi / (2 sqrt 3)
constexpr int kRelaxations = 400;
constexpr double kTouching = 0.004;  // overlap, in radii, that counts as none

/// Buckets of points on a square grid, rebuilt each sweep by counting sort: discs of diameter `cell` or less that meet
/// lie in neighbouring buckets.
class Buckets {
 public:
  Buckets(const Points& points, double cell) : cell_(cell) {
    for (const glm::dvec2& p : points) extent_ = std::max({extent_, std::abs(p.x), std::abs(p.y)});
    side_ = static_cast<int>(std::min(2 * extent_ / cell_, 4000.0)) + 1;
    start_.assign(static_cast<size_t>(side_) * side_ + 1, 0);
    for (const glm::dvec2& p : points) ++start_[indexOf(p) + 1];
    for (size_t i = 1; i < start_.size(); ++i) start_[i] += start_[i - 1];
    members_.resize(points.size());
    std::vector<int> next(start_.begin(), start_.end() - 1);
    for (size_t i = 0; i < points.size(); ++i) members_[next[indexOf(points[i])]++] = static_cast<int>(i);
  }

  /// Calls visit(j) for every point that may lie within a cell of p.
  template <class Visit>
  void near(glm::dvec2 p, Visit&& visit) const {
    const int column = along(p.x), row = along(p.y);
    for (int y = std::max(0, row - 1); y <= std::min(side_ - 1, row + 1); ++y)
      for (int x = std::max(0, column - 1); x <= std::min(side_ - 1, column + 1); ++x)
        for (int k = start_[y * side_ + x]; k < start_[y * side_ + x + 1]; ++k) visit(members_[k]);
  }

 private:
  int along(double x) const { return std::clamp(static_cast<int>((x + extent_) / cell_), 0, side_ - 1); }
  int indexOf(glm::dvec2 p) const { return along(p.y) * side_ + along(p.x); }

  double cell_, extent_ = 0;
  int side_ = 1;
  std::vector<int> start_, members_;
};

void centre(Points& points) {
  glm::dvec2 mean(0);
  for (const glm::dvec2& p : points) mean += p;
  mean /= static_cast<double>(points.size());
  for (glm::dvec2& p : points) p -= mean;
}

glm::dvec2 uniformInDisc(Random& random) {
  const double radius = std::sqrt(random.uniformDouble());
  const double angle = 2 * kPi * random.uniformDouble();
  return radius * glm::dvec2(std::cos(angle), std::sin(angle));
}

/// The `count` points of a hexagonal lattice of that spacing that lie nearest to a random place of it.
Points hexagonal(int count, double spacing, Random& random) {
  const double rowHeight = spacing * std::sqrt(0.75);
  const glm::dvec2 origin = 0.5 * spacing * uniformInDisc(random);
  const int rows = static_cast<int>(std::sqrt(count / kHexagonalDensity)) + 3;
  Points points;
  for (int y = -rows; y <= rows; ++y)
    for (int x = -rows; x <= rows; ++x)
      points.push_back(glm::dvec2((x + 0.5 * (y & 1)) * spacing, y * rowHeight) - origin);
  std::nth_element(points.begin(), points.begin() + (count - 1), points.end(),
                   [](glm::dvec2 a, glm::dvec2 b) { return glm::dot(a, a) < glm::dot(b, b); });
  points.resize(static_cast<size_t>(count));
  // nth_element leaves an order of its own: sort, so that every library gives the same fibres.
  std::sort(points.begin(), points.end(),
            [](glm::dvec2 a, glm::dvec2 b) { return a.y != b.y ? a.y < b.y : a.x < b.x; });
  return points;
}

/// Pushes overlapping discs apart, half each, from within the rim, until none overlap. Where the rim leaves too little
/// room, overlaps win: the later sweeps leave the rim free.
void relax(Points& points, double radius, double rim) {
  const double apart = 2 * radius;
  for (int sweep = 0; sweep < kRelaxations; ++sweep) {
    if (sweep < kRelaxations / 4) {
      for (glm::dvec2& p : points)
        if (const double reach = glm::length(p); reach > rim) p *= rim / reach;
    }
    const Buckets buckets(points, 1.1 * apart);
    double worst = 0;
    for (size_t i = 0; i < points.size(); ++i) {
      buckets.near(points[i], [&](int j) {
        if (static_cast<size_t>(j) <= i) return;
        const glm::dvec2 d = points[j] - points[i];
        const double distance = glm::length(d);
        if (distance >= apart) return;
        worst = std::max(worst, apart - distance);
        const glm::dvec2 push = distance > 1e-9 * radius ? d / distance : glm::dvec2(1, 0);
        // A little further than touching, so that chains of contacts come to rest.
        const glm::dvec2 shift = 0.5 * (1.002 * apart - distance) * push;
        points[i] -= shift;
        points[j] += shift;
      });
    }
    if (worst < kTouching * radius) return;
  }
}

}  // namespace

Points plySection(FibreLayout layout, int count, double plyRadius_mm, double fibreRadius_mm, uint64_t seed) {
  if (count == 1) return {glm::dvec2(0)};
  Random random(seed);
  const double rim = std::max(plyRadius_mm - fibreRadius_mm, 0.5 * plyRadius_mm);
  Points points;
  if (layout == FibreLayout::random) {
    for (int i = 0; i < count; ++i) points.push_back(rim * uniformInDisc(random));
  } else {
    const double density = std::min(count * fibreRadius_mm * fibreRadius_mm / (plyRadius_mm * plyRadius_mm), 0.88);
    const double spacing = 2 * fibreRadius_mm * std::sqrt(kHexagonalDensity / density);
    points = hexagonal(count, spacing, random);
    for (glm::dvec2& p : points) p += 1.5 * (spacing - 2 * fibreRadius_mm) * uniformInDisc(random);
    relax(points, fibreRadius_mm, rim);
  }
  centre(points);
  return points;
}

double worstOverlap(const Points& centres_mm, double fibreRadius_mm) {
  const Buckets buckets(centres_mm, 2 * fibreRadius_mm);
  double worst = 0;
  for (size_t i = 0; i < centres_mm.size(); ++i)
    buckets.near(centres_mm[i], [&](int j) {
      if (static_cast<size_t>(j) > i)
        worst = std::max(worst, 2 * fibreRadius_mm - glm::distance(centres_mm[i], centres_mm[j]));
    });
  return worst / fibreRadius_mm;
}

}  // namespace loomlight
