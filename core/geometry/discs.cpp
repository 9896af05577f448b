#include "core/geometry/discs.h"

#include <algorithm>
#include <cmath>

// How it works. A sweep pushes every pair of fibres that overlap apart by half of what is wanting each. Pairs that
// could overlap are found by buckets, with some slack; the list serves until a fibre has moved by half of that slack.
// Distance is measured as the fibres lie in the yarn, pressed and inclined, not in the round section
// (HelicalFibres::apartSquare).

namespace loomlight {
namespace {

/// Buckets of points on a square grid, by counting sort: discs of diameter `cell` or less that meet
/// lie in neighbouring buckets.
class Buckets {
 public:
  Buckets(const DiscCentres& points, double cell) : cell_(cell) {
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

/// How far from one another fibres may lie in the round section and touch, at most.
double farthestTouch(const DiscCentres& centres, const HelicalFibres& fibres) {
  double square = 0;
  for (const glm::dvec2& p : centres) square = std::max(square, glm::dot(p, p));
  const auto& [up, across] = fibres.section;
  return 2 * fibres.radius_mm /
         (fibres.cosineAt(square * std::max(up, across) * std::max(up, across)) * std::min(up, across));
}

}  // namespace

bool Parting::knowsNeighbours(const DiscCentres& centres) const {
  if (looked_.size() != centres.size()) return false;
  double moved = 0;
  for (size_t i = 0; i < centres.size(); ++i) {
    const glm::dvec2 d = centres[i] - looked_[i];
    moved = std::max(moved, glm::dot(d, d));
  }
  const double widest = std::max(fibres_.section.up, fibres_.section.across);
  return 4 * moved * widest * widest < slack_mm_ * slack_mm_;
}

void Parting::findNeighbours(const DiscCentres& centres) {
  constexpr double kSlack = 0.5;  // radii
  slack_mm_ = kSlack * fibres_.radius_mm;
  looked_ = centres;
  neighbours_.clear();
  const double near = 2 * fibres_.radius_mm + slack_mm_;
  const double narrowest = std::min(fibres_.section.up, fibres_.section.across);
  const Buckets buckets(centres, farthestTouch(centres, fibres_) + slack_mm_ / narrowest);
  for (int i = 0; i < static_cast<int>(centres.size()); ++i)
    buckets.near(centres[i], [&](int j) {
      if (j <= i) return;
      if (fibres_.apartSquare(centres[i], centres[j]) < near * near) neighbours_.emplace_back(i, j);
    });
}

double Parting::sweep(DiscCentres& centres) {
  if (!knowsNeighbours(centres)) findNeighbours(centres);
  const double diameter = 2 * fibres_.radius_mm;
  double worst = 0;
  for (const auto& [i, j] : neighbours_) {
    const double square = fibres_.apartSquare(centres[i], centres[j]);
    if (square >= diameter * diameter) continue;
    const double distance = std::sqrt(square);
    worst = std::max(worst, diameter - distance);
    const glm::dvec2 way = distance > 1e-9 * diameter ? (centres[j] - centres[i]) / distance : glm::dvec2(1, 0);
    // A little further than touching, so that chains of contacts come to rest.
    const glm::dvec2 shift = 0.5 * (1.002 * diameter - distance) * way;
    centres[i] -= shift;
    centres[j] += shift;
  }
  return worst;
}

}  // namespace loomlight
