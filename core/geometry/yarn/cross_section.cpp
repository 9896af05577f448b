#include "core/geometry/yarn/cross_section.h"

#include <algorithm>
#include <cmath>

#include "core/base/random.h"

// How it works. A packed section starts as the hexagonal lattice of the wanted density, its points nearest to a random
// place of it, each then shaken as far as the free room between neighbours allows. Sweeps push overlapping fibres
// apart, half each (discs.cpp), at first within the rim of the ply; the later sweeps leave the rim free, so that a
// section that is too full grows a little instead of overlapping. A random section is independent uniform points, as in
// the report.

namespace loomlight {
namespace {

using Points = DiscCentres;

constexpr double kHexagonalDensity = 0.90689968;  // pi / (2 sqrt 3)
constexpr int kRelaxations = 400;
constexpr double kTouching = 0.004;  // overlap, in radii, that counts as none

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

/// Pushes overlapping discs apart, from within the rim, until none overlap. Where the rim leaves too little room, the
/// rim gives way: the later sweeps leave it free.
void relax(Points& points, const HelicalFibres& fibres, double rim, const Task& task) {
  SectionLanes sections = sideBySide({&points, 1});
  Parting parting(fibres);
  for (int sweep = 0; sweep < kRelaxations && !task.stopped(); ++sweep) {
    if (sweep < kRelaxations / 4) keepWithin(sections, rim);
    if (parting.sweep(sections) < kTouching * fibres.radius_mm) break;
  }
  points = sectionOf(sections, 0);
}

}  // namespace

Points plySection(FibreLayout layout, int count, double plyRadius_mm, const HelicalFibres& fibres, uint64_t seed,
                  const Task& task) {
  if (count == 1) return {glm::dvec2(0)};
  Random random(seed);
  const double radius = fibres.radius_mm / std::sqrt(fibres.section.up * fibres.section.across);
  const double rim = std::max(plyRadius_mm - radius, 0.5 * plyRadius_mm);
  Points points;
  if (layout == FibreLayout::random) {
    for (int i = 0; i < count; ++i) points.push_back(rim * uniformInDisc(random));
  } else {
    const double density = std::min(count * radius * radius / (plyRadius_mm * plyRadius_mm), 0.88);
    const double spacing = 2 * radius * std::sqrt(kHexagonalDensity / density);
    points = hexagonal(count, spacing, random);
    for (glm::dvec2& p : points) p += 1.5 * (spacing - 2 * radius) * uniformInDisc(random);
    relax(points, fibres, rim, task);
  }
  centre(points);
  return points;
}

}  // namespace loomlight
