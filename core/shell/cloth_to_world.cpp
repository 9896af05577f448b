#include "core/shell/cloth_to_world.h"

#include <algorithm>
#include <cmath>
#include <limits>

// How it works. The prisms of a shell are sorted by counting into a grid over the plane of the texture, with about
// one cell for each, but with cells no smaller than the prisms are on average: pieces may lie on top of each other in
// the texture, and then each would touch very many. So there are a few entries for each prism on average. A point of
// cloth space is looked for in the prisms of its cell: of all their tetrahedra the one that it lies deepest in is its
// own, so that points in a face are not lost to rounding. A flat piece is a translation. Lengths are in mm. Cost: a few
// tetrahedra for each point, times as many pieces as lie on each other there.

namespace loomlight {
namespace {

constexpr size_t kTetsPerPrism = 3;

constexpr double kMostCells = 4096;  // each way

struct Bounds {
  glm::vec2 lower{std::numeric_limits<float>::max()}, upper{-std::numeric_limits<float>::max()};
  void include(glm::vec2 p) {
    lower = glm::min(lower, p);
    upper = glm::max(upper, p);
  }
  glm::dvec2 size() const { return glm::dvec2(upper) - glm::dvec2(lower); }
};

Bounds prismBounds(const Shell& shell, size_t prism) {
  Bounds bounds;
  for (size_t i = prism * kTetsPerPrism; i < (prism + 1) * kTetsPerPrism; ++i)
    for (const uint32_t v : shell.tets()[i].vertex)
      bounds.include(glm::vec2(shell.toCloth(static_cast<int>(i), shell.vertices()[v])));
  return bounds;
}

/// How deep inside the tetrahedron, mm; negative outside.
float depth(const Shell::Tet& tet, glm::vec3 world) {
  const Float32x4 heights = tet.plane.heights(world);
  return std::min(std::min(heights[0], heights[1]), std::min(heights[2], heights[3]));
}

}  // namespace

ClothToWorld::ClothToWorld(const Shell& shell) : shell_(shell) {
  if (shell.isFlat()) return;
  const size_t prisms = shell.tets().size() / kTetsPerPrism;
  std::vector<Bounds> bounds(prisms);
  Bounds all;
  double areas = 0, sides = 0;
  for (size_t i = 0; i < prisms; ++i) {
    bounds[i] = prismBounds(shell, i);
    all.include(bounds[i].lower);
    all.include(bounds[i].upper);
    const glm::dvec2 of = bounds[i].size();
    areas += of.x * of.y;
    sides += 0.5 * (of.x + of.y);
  }
  lower_ = all.lower;
  const glm::dvec2 size = glm::max(all.size(), 1e-6);
  const auto n = static_cast<double>(prisms);
  const double side = std::max({std::sqrt(size.x * size.y / n), std::sqrt(areas / n), sides / n});
  cells_ = glm::ivec2(glm::clamp(size / side, 1.0, kMostCells));
  perCell_ = glm::vec2(size / glm::dvec2(cells_));

  // Counting sort of the prisms into the cells that their bounds touch.
  firstOfCell_.assign(static_cast<size_t>(cells_.x) * cells_.y + 1, 0);
  const auto forCells = [&](const Bounds& b, auto&& body) {
    const glm::ivec2 from = cellOf(b.lower), to = cellOf(b.upper);
    for (int y = from.y; y <= to.y; ++y)
      for (int x = from.x; x <= to.x; ++x) body(static_cast<size_t>(y) * cells_.x + x);
  };
  for (const Bounds& b : bounds) forCells(b, [&](size_t cell) { ++firstOfCell_[cell + 1]; });
  for (size_t c = 1; c < firstOfCell_.size(); ++c) firstOfCell_[c] += firstOfCell_[c - 1];
  prisms_.resize(firstOfCell_.back());
  std::vector<uint32_t> next(firstOfCell_.begin(), firstOfCell_.end() - 1);
  for (size_t i = 0; i < prisms; ++i)
    forCells(bounds[i], [&](size_t cell) { prisms_[next[cell]++] = static_cast<uint32_t>(i); });

  toWorld_.reserve(shell.tets().size());
  for (const Shell::Tet& tet : shell.tets()) toWorld_.push_back(glm::inverse(tet.toCloth));
}

glm::ivec2 ClothToWorld::cellOf(glm::vec2 uv) const {
  return glm::clamp(glm::ivec2(glm::floor((uv - lower_) / perCell_)), glm::ivec2(0), cells_ - 1);
}

std::optional<ClothToWorld::Point> ClothToWorld::operator()(glm::vec3 cloth) const {
  if (shell_.isFlat()) {  // a translation
    const glm::vec3 corner = shell_.lower_mm();
    return Point{corner + (cloth - shell_.toCloth(0, corner)), 0};
  }
  const glm::ivec2 c = cellOf(glm::vec2(cloth));
  const size_t cell = static_cast<size_t>(c.y) * cells_.x + c.x;
  constexpr float kTolerance_mm = 1e-5f;  // points in a face belong to both sides; rounding must not lose them
  Point best{glm::vec3(0), -1};
  float bestDepth = -kTolerance_mm;
  for (uint32_t i = firstOfCell_[cell]; i < firstOfCell_[cell + 1]; ++i)
    for (size_t t = prisms_[i] * kTetsPerPrism; t < (prisms_[i] + 1) * kTetsPerPrism; ++t) {
      const Shell::Tet& tet = shell_.tets()[t];
      const glm::vec3 world = toWorld_[t] * (cloth - tet.offset);
      const float inside = depth(tet, world);
      if (inside <= bestDepth) continue;
      bestDepth = inside;
      best = {world, static_cast<int>(t)};
    }
  if (best.tet < 0) return std::nullopt;
  return best;
}

}  // namespace loomlight
