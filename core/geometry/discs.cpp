#include "core/geometry/discs.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <tuple>

// How it works. A sweep pushes every pair of fibres that overlap apart by half of what is wanting each. Distance is
// measured as the fibres lie in the yarn, pressed and inclined, not in the round section (HelicalFibres::apartSquare).
// Pairs that could overlap are found with some slack, and serve until a fibre has moved by half of that slack. They are
// looked for ring by ring about the axis: fibres that are inclined reach far around it and no farther towards it, so
// that squares as wide as their reach would hold fifty times the pairs that touch.

namespace loomlight {
namespace {

/// Fibres in rings about the axis, and by their angle within each ring. Two that touch lie in one ring or in two that
/// are neighbours, if no fibres farther apart in radius than a ring is thick can touch.
class Rings {
 public:
  Rings(const DiscCentres& points, double thickness) : thickness_(thickness) {
    members_.reserve(points.size());
    for (size_t i = 0; i < points.size(); ++i)
      members_.push_back({static_cast<int>(std::min(glm::length(points[i]) / thickness, kMostRings)),
                          std::atan2(points[i].y, points[i].x), static_cast<int>(i)});
    std::sort(members_.begin(), members_.end(), [](const Member& a, const Member& b) {
      return std::tie(a.ring, a.angle, a.index) < std::tie(b.ring, b.angle, b.index);
    });
    start_.assign(members_.empty() ? 1 : static_cast<size_t>(members_.back().ring) + 3, 0);
    for (const Member& m : members_) ++start_[static_cast<size_t>(m.ring) + 1];
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
  }

  /// Calls visit(i, j) once for every two that may lie within reach(radius) of each other, `radius` being as far out as
  /// their rings go, in the points' unit.
  template <class Reach, class Visit>
  void pairs(const Reach& reach, const Visit& visit) const {
    const int rings = static_cast<int>(start_.size()) - 2;
    for (int ring = 0; ring < rings; ++ring) {
      const double angle = widestAngle(ring * thickness_, reach((ring + 2) * thickness_));
      const Span own = of(ring), next = of(ring + 1);
      for (size_t a = 0; a < own.size(); ++a) {
        onward(own, a, angle, visit);
        around(next, own[a], angle, visit);
      }
    }
  }

 private:
  static constexpr double kMostRings = 1e6;
  struct Member {
    int ring;
    double angle;  ///< radians, -pi to pi
    int index;
  };
  using Span = std::span<const Member>;

  Span of(int ring) const {
    return Span(members_).subspan(start_[static_cast<size_t>(ring)],
                                  start_[static_cast<size_t>(ring) + 1] - start_[static_cast<size_t>(ring)]);
  }

  /// As two points see each other from the axis that lie at least `innermost` from it and at most `reach` apart.
  static double widestAngle(double innermost, double reach) {
    return reach < 2 * innermost ? 2 * std::asin(0.5 * reach / innermost) : kPi;
  }

  /// Those of its own ring that follow member `a` within an angle.
  template <class Visit>
  static void onward(Span ring, size_t a, double angle, const Visit& visit) {
    if (angle >= kPi) {
      for (size_t b = a + 1; b < ring.size(); ++b) visit(ring[a].index, ring[b].index);
      return;
    }
    for (size_t step = 1; step < ring.size(); ++step) {
      const bool wraps = a + step >= ring.size();
      const Member& b = ring[wraps ? a + step - ring.size() : a + step];
      if (b.angle + (wraps ? 2 * kPi : 0) - ring[a].angle > angle) return;
      visit(ring[a].index, b.index);
    }
  }

  /// Those of another ring within an angle of a member, on both sides.
  template <class Visit>
  static void around(Span ring, const Member& a, double angle, const Visit& visit) {
    if (angle >= kPi) {
      for (const Member& b : ring) visit(a.index, b.index);
      return;
    }
    const double from = a.angle - angle, first = from < -kPi ? from + 2 * kPi : from;
    const auto begin = std::lower_bound(ring.begin(), ring.end(), first,
                                        [](const Member& b, double wanted) { return b.angle < wanted; });
    const auto offset = static_cast<size_t>(begin - ring.begin());
    for (size_t step = 0; step < ring.size(); ++step) {
      const bool wraps = offset + step >= ring.size();
      const Member& b = ring[wraps ? offset + step - ring.size() : offset + step];
      if (b.angle + (wraps ? 2 * kPi : 0) - first > 2 * angle) return;
      visit(a.index, b.index);
    }
  }

  double thickness_;
  std::vector<Member> members_;
  std::vector<size_t> start_;  ///< of each ring in members_, and of two empty ones beyond the last
};

/// Calls visit(i, j, square of their distance) for every two that are nearer than `near` as they lie in the yarn, mm.
template <class Visit>
void forPairsWithin(double near, const DiscCentres& centres, const HelicalFibres& fibres, const Visit& visit) {
  const auto [narrowest, widest] = std::minmax(fibres.section.up, fibres.section.across);
  // What is foreshortened is the way around the axis: towards it, fibres are as near as they look.
  const double thickness = near / narrowest;
  const auto reach = [&](double radius) { return thickness / fibres.cosineAt(radius * radius * widest * widest); };
  Rings(centres, thickness).pairs(reach, [&](int i, int j) {
    const double square = fibres.apartSquare(centres[i], centres[j]);
    if (square < near * near) visit(i, j, square);
  });
}

/// What two discs of radius 1 have in common, over the area of one; `square`: of the distance of their centres, < 4.
double commonShare(double square) {
  const double half = 0.5 * std::sqrt(square);
  return 2 / kPi * (std::acos(half) - half * std::sqrt(1 - half * half));
}

}  // namespace

double meanOverlap(const DiscCentres& centres, const HelicalFibres& fibres) {
  double sum = 0;
  const double perRadius = 1 / fibres.radius_mm;
  forPairsWithin(2 * fibres.radius_mm, centres, fibres,
                 [&](int, int, double square) { sum += 2 * commonShare(square * perRadius * perRadius); });
  return centres.empty() ? 0 : sum / static_cast<double>(centres.size());
}

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
  forPairsWithin(2 * fibres_.radius_mm + slack_mm_, centres, fibres_,
                 [this](int i, int j, double) { neighbours_.emplace_back(i, j); });
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
