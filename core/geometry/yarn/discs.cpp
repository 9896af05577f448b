#include "core/geometry/yarn/discs.h"

#include <algorithm>
#include <cmath>
#include <tuple>

// How it works. A sweep pushes every pair of fibres that overlap apart by half of what is wanting each. Distance is
// measured as the fibres lie in the yarn, pressed and inclined, not in the round section (HelicalFibres::apartSquare).
// Eight sections are swept at once, side by side in SIMD lanes: a pair is looked at in all of them if it could overlap
// in one, and stays where it is in the others. Such pairs are found with some slack, and serve until a fibre has moved
// by half of that slack. They are found among those that are as far from the axis, or nearly: fibres that are inclined
// reach far around the axis and no farther towards it.

namespace loomlight {
namespace {

double leastLane(double a) {
  return a;
}
double leastLane(Float32x8 a) {
  float least = a[0];
  for (int lane = 1; lane < kLanes<Float32x8>; ++lane) least = std::min(least, a[lane]);
  return least;
}
double mostLane(double a) {
  return a;
}
double mostLane(Float32x8 a) {
  return -leastLane(-a);
}

/// Calls visit(i, j, squares of their distances) once for every two fibres that are nearer than `near`, as they lie in
/// the yarn, mm, in any of the sections. Takes at most n^2 / 2 steps for n fibres, each of a few products.
template <class T, class Visit>
void forPairsWithin(double near, const std::vector<PlaceOf<T>>& sections, const HelicalFibres& fibres,
                    const Visit& visit) {
  struct Fibre {
    PlaceOf<T> place;
    double inner, outer;  ///< its least and its largest distance from the axis, over all sections
    int index;
  };
  std::vector<Fibre> sorted;
  sorted.reserve(sections.size());
  double outermost = 0;
  for (size_t i = 0; i < sections.size(); ++i) {
    const PlaceOf<T>& p = sections[i];
    const T radius = squareRoot(p.up * p.up + p.across * p.across);
    sorted.push_back({p, leastLane(radius), mostLane(radius), static_cast<int>(i)});
    outermost = std::max(outermost, sorted.back().outer);
  }
  std::sort(sorted.begin(), sorted.end(),
            [](const Fibre& a, const Fibre& b) { return std::tie(a.inner, a.index) < std::tie(b.inner, b.index); });
  const auto [narrowest, widest] = std::minmax(fibres.section.up, fibres.section.across);
  // What is foreshortened is the way around the axis: towards it, fibres are as near as they look.
  const double towards = near / narrowest;
  // However inclined they are, two fibres are no nearer than what they seem to be, by the steepest one's cosine.
  const double cosine = fibres.cosineAt(widest * widest * outermost * outermost);
  const T seeming = broadcast<T>(near * near / (cosine * cosine)), nearSquare = broadcast<T>(near * near);
  const T up = broadcast<T>(fibres.section.up), across = broadcast<T>(fibres.section.across);
  for (size_t a = 0; a < sorted.size(); ++a) {
    const Fibre& one = sorted[a];
    const double end = one.outer + towards;
    for (size_t b = a + 1; b < sorted.size() && sorted[b].inner < end; ++b) {
      const Fibre& other = sorted[b];
      const T betweenUp = up * (other.place.up - one.place.up),
              betweenAcross = across * (other.place.across - one.place.across);
      if (!any(betweenUp * betweenUp + betweenAcross * betweenAcross < seeming)) continue;
      const T squares = fibres.apartSquare(one.place, other.place);
      if (any(squares < nearSquare)) visit(one.index, other.index, squares);
    }
  }
}

/// What two discs of radius 1 have in common, over the area of one; `square`: of the distance of their centres, < 4.
double commonShare(double square) {
  const double half = 0.5 * std::sqrt(square);
  return 2 / kPi * (std::acos(half) - half * std::sqrt(1 - half * half));
}

}  // namespace

SectionLanes sideBySide(std::span<const DiscCentres> sections) {
  SectionLanes lanes(sections[0].size());
  for (size_t i = 0; i < lanes.size(); ++i)
    for (int lane = 0; lane < kLanes<Float32x8>; ++lane) {
      const glm::dvec2 place = sections[std::min(static_cast<size_t>(lane), sections.size() - 1)][i];
      lanes[i].up[lane] = static_cast<float>(place.x);
      lanes[i].across[lane] = static_cast<float>(place.y);
    }
  return lanes;
}

DiscCentres sectionOf(const SectionLanes& sections, int lane) {
  DiscCentres centres;
  centres.reserve(sections.size());
  for (const PlaceLanes& place : sections) centres.emplace_back(place.up[lane], place.across[lane]);
  return centres;
}

double meanOverlap(const DiscCentres& centres, const HelicalFibres& fibres) {
  std::vector<PlaceOf<double>> places;
  places.reserve(centres.size());
  for (const glm::dvec2& centre : centres) places.push_back({centre.x, centre.y});
  double sum = 0;
  const double perRadius = 1 / fibres.radius_mm;
  forPairsWithin(2 * fibres.radius_mm, places, fibres,
                 [&](int, int, double square) { sum += 2 * commonShare(square * perRadius * perRadius); });
  return centres.empty() ? 0 : sum / static_cast<double>(centres.size());
}

void keepWithin(SectionLanes& sections, double rim_mm) {
  const auto rim = broadcast<Float32x8>(rim_mm), one = broadcast<Float32x8>(1);
  for (PlaceLanes& p : sections) {
    const Float32x8 reach = squareRoot(p.up * p.up + p.across * p.across);
    const Float32x8 scale = reach > rim ? rim / reach : one;
    p.up *= scale;
    p.across *= scale;
  }
}

bool Parting::knowsNeighbours(const SectionLanes& sections) const {
  if (looked_.size() != sections.size()) return false;
  Float32x8 moved{};
  for (size_t i = 0; i < sections.size(); ++i) {
    const Float32x8 up = sections[i].up - looked_[i].up, across = sections[i].across - looked_[i].across;
    moved = most(moved, up * up + across * across);
  }
  const double widest = std::max(fibres_.section.up, fibres_.section.across);
  return 4 * mostLane(moved) * widest * widest < slack_mm_ * slack_mm_;
}

void Parting::findNeighbours(const SectionLanes& sections) {
  constexpr double kSlack = 1.2;  // radii
  slack_mm_ = kSlack * fibres_.radius_mm;
  looked_ = sections;
  neighbours_.clear();
  forPairsWithin(2 * fibres_.radius_mm + slack_mm_, sections, fibres_,
                 [this](int i, int j, Float32x8) { neighbours_.emplace_back(i, j); });
}

double Parting::sweep(SectionLanes& sections) {
  using Lanes = Float32x8;
  if (!knowsNeighbours(sections)) findNeighbours(sections);
  const double diameter_mm = 2 * fibres_.radius_mm;
  const auto diameter = broadcast<Lanes>(diameter_mm), touching = broadcast<Lanes>(diameter_mm * diameter_mm),
             none = broadcast<Lanes>(1e-9 * diameter_mm);
  // A little further than touching, so that chains of contacts come to rest.
  const auto wanted = broadcast<Lanes>(1.002 * diameter_mm), half = broadcast<Lanes>(0.5);
  Lanes worst{};
  for (const auto& [i, j] : neighbours_) {
    PlaceLanes &from = sections[static_cast<size_t>(i)], &to = sections[static_cast<size_t>(j)];
    const Lanes square = fibres_.apartSquare(from, to);
    if (!any(square < touching)) continue;
    const Lanes distance = squareRoot(square);
    worst = most(worst, diameter - distance);
    const Lanes push = square < touching ? half * (wanted - distance) : Lanes{};
    const Lanes perLength = push / most(distance, none);
    const Lanes up = distance > none ? perLength * (to.up - from.up) : push;  // from the same place: apart upwards
    const Lanes across = perLength * (to.across - from.across);
    from.up -= up;
    from.across -= across;
    to.up += up;
    to.across += across;
  }
  return mostLane(worst);
}

}  // namespace loomlight
