#include "core/geometry/discs.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

// How it works. A sweep pushes every pair of fibres that overlap apart by half of what is wanting each. Distance is
// measured as the fibres lie in the yarn, pressed and inclined, not in the round section (HelicalFibres::apartSquare).
// Pairs that could overlap are found with some slack, and serve until a fibre has moved by half of that slack. They are
// looked for ring by ring about the axis: fibres that are inclined reach far around it and no farther towards it, so
// that squares as wide as their reach would hold fifty times the pairs that touch.

namespace loomlight {
namespace {

/// Fibres in rings about the axis, and by their angle within each ring. Two that touch lie in one ring or in two that
/// are neighbours, if no fibres farther apart in radius than a ring is thick can touch. Those of a ring lie one after
/// the other in memory, so that one fibre is held against many in SIMD lanes.
class Rings {
 public:
  /// `order`: all points, as the rings held them when they were looked for last, or empty; as these hold them, after.
  Rings(const DiscCentres& points, double thickness, std::vector<int>& order) : thickness_(thickness) {
    std::vector<Key> keys(points.size());
    for (size_t i = 0; i < points.size(); ++i)
      keys[i] = {static_cast<int>(std::min(glm::length(points[i]) / thickness, kMostRings)),
                 std::atan2(points[i].y, points[i].x)};
    sort(keys, order);
    start_.assign(order.empty() ? 1 : static_cast<size_t>(keys[static_cast<size_t>(order.back())].ring) + 3, 0);
    for (const Key& key : keys) ++start_[static_cast<size_t>(key.ring) + 1];
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    for (std::vector<double>* column : {&angles_, &up_, &across_}) column->reserve(points.size());
    for (const int i : order) {
      angles_.push_back(keys[static_cast<size_t>(i)].angle);
      up_.push_back(points[static_cast<size_t>(i)].x);
      across_.push_back(points[static_cast<size_t>(i)].y);
    }
    indices_ = order;
  }

  /// Calls visit(i, j, square of their distance) once for every two that lie nearer than `near` to each other in the
  /// yarn, mm. In the section these may be reach(radius) apart and no more, in the points' unit, where `radius` is how
  /// far out their rings go.
  template <class Reach, class Visit>
  void pairs(double near, const HelicalFibres& fibres, const Reach& reach, const Visit& visit) {
    squares_.resize(indices_.size());
    const int rings = static_cast<int>(start_.size()) - 2;
    for (int ring = 0; ring < rings; ++ring) {
      const double angle = widestAngle(ring * thickness_, reach((ring + 2) * thickness_));
      const Range own = of(ring), next = of(ring + 1);
      Window onward{own}, around{next};
      for (size_t a = own.begin; a < own.end; ++a) {
        const auto hold = [&](Range range) { nearIn(range, a, near, fibres, visit); };
        if (angle >= kPi) {
          hold({a + 1, own.end});
          hold(next);
          continue;
        }
        onward.begin = a + 1;
        follow(onward, angles_[a], angle);
        hold({onward.begin, onward.end});
        hold({own.begin, std::min(onward.wrapped, a)});  // itself is a whole turn away
        const double from = angles_[a] - angle;
        seek(around, from < -kPi ? from + 2 * kPi : from);
        follow(around, around.first, 2 * angle);
        hold({around.begin, around.end});
        hold({next.begin, around.wrapped});
      }
    }
  }

 private:
  static constexpr double kMostRings = 1e6;
  struct Key {
    int ring;
    double angle;  ///< radians, -pi to pi
  };
  struct Range {
    size_t begin, end;
  };
  /// Members of a ring within an angle. It moves on around the ring with those that it is asked for, which are asked
  /// for by their angles: so it is found without a search.
  struct Window {
    explicit Window(Range r) : ring(r), begin(r.begin), end(r.begin), wrapped(r.begin) {}
    Range ring;
    size_t begin, end;
    size_t wrapped;           ///< past the ring's end: as many of its beginning, up to here
    double first = -2 * kPi;  ///< angle from which it was sought
  };

  /// By ring, by angle there, and by number. Fibres that have moved a little are in order but for a few.
  static void sort(const std::vector<Key>& keys, std::vector<int>& order) {
    const auto before = [&keys](int a, int b) {
      const Key &one = keys[static_cast<size_t>(a)], &other = keys[static_cast<size_t>(b)];
      return std::tie(one.ring, one.angle, a) < std::tie(other.ring, other.angle, b);
    };
    if (order.size() != keys.size()) {
      order.resize(keys.size());
      std::iota(order.begin(), order.end(), 0);
      std::sort(order.begin(), order.end(), before);
      return;
    }
    for (size_t k = 1; k < order.size(); ++k)
      for (size_t to = k; to > 0 && before(order[to], order[to - 1]); --to) std::swap(order[to], order[to - 1]);
  }

  Range of(int ring) const { return {start_[static_cast<size_t>(ring)], start_[static_cast<size_t>(ring) + 1]}; }

  /// As two points see each other from the axis that lie at least `innermost` from it and at most `reach` apart.
  static double widestAngle(double innermost, double reach) {
    return reach < 2 * innermost ? 2 * std::asin(0.5 * reach / innermost) : kPi;
  }

  /// Begins the window with the first member whose angle is `first` or more. Angles that are sought rise, but for one
  /// step back by a whole turn, where the window begins anew.
  void seek(Window& window, double first) const {
    if (first < window.first) window = Window{window.ring};
    window.first = first;
    while (window.begin < window.ring.end && angles_[window.begin] < first) ++window.begin;
  }

  /// Ends the window with the last member within an angle of `first`, on the far side of a whole turn too.
  void follow(Window& window, double first, double angle) const {
    window.end = std::max(window.end, window.begin);
    while (window.end < window.ring.end && angles_[window.end] - first <= angle) ++window.end;
    window.wrapped = window.ring.begin;
    if (window.end < window.ring.end) return;
    while (window.wrapped < window.begin && angles_[window.wrapped] + 2 * kPi - first <= angle) ++window.wrapped;
  }

  /// Those of a range that are near to member `a`. All distances first, which takes no branches.
  template <class Visit>
  void nearIn(Range range, size_t a, double near, const HelicalFibres& fibres, const Visit& visit) {
    const glm::dvec2 from(up_[a], across_[a]);
    for (size_t b = range.begin; b < range.end; ++b)
      squares_[b] = fibres.apartSquare(from, glm::dvec2(up_[b], across_[b]));
    for (size_t b = range.begin; b < range.end; ++b)
      if (squares_[b] < near * near) visit(indices_[a], indices_[b], squares_[b]);
  }

  double thickness_;
  std::vector<size_t> start_;  ///< of each ring, and of two empty ones beyond the last
  // Of each member, ring by ring and by their angles there.
  std::vector<double> angles_;       ///< radians, -pi to pi
  std::vector<double> up_, across_;  ///< where it lies
  std::vector<int> indices_;
  std::vector<double> squares_;  ///< of distances, while one is held against others
};

/// Calls visit(i, j, square of their distance) for every two that are nearer than `near` as they lie in the yarn, mm;
/// `order`: see Rings.
template <class Visit>
void forPairsWithin(double near, const DiscCentres& centres, const HelicalFibres& fibres, std::vector<int>& order,
                    const Visit& visit) {
  const auto [narrowest, widest] = std::minmax(fibres.section.up, fibres.section.across);
  // What is foreshortened is the way around the axis: towards it, fibres are as near as they look.
  const double thickness = near / narrowest;
  const auto reach = [&](double radius) { return thickness / fibres.cosineAt(radius * radius * widest * widest); };
  Rings(centres, thickness, order).pairs(near, fibres, reach, visit);
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
  std::vector<int> order;
  forPairsWithin(2 * fibres.radius_mm, centres, fibres, order,
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
  forPairsWithin(2 * fibres_.radius_mm + slack_mm_, centres, fibres_, order_,
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
