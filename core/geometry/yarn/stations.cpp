#include "core/geometry/yarn/stations.h"

#include <algorithm>
#include <cmath>

// How it works. Fibres are polylines, and a chord of length h misses a curve by h^2 / 8 times its second derivative.
// For each piece of the yarn's path (an arc or a line) that derivative is bounded for the outermost fibre, from the
// curvature of the path, the twists, the migration, the easing of the section and their products; so stations stand as
// far apart as the sagitta allows, and no cell has more than it needs. Twist does not run evenly along a transition: it
// has the same rate at both nodes whatever its length, eased between them (TwistEasing), so that fibres have no kink
// where two transitions meet.

namespace loomlight {
namespace {

/// Twist along a transition, in cells against the share x of its length: t' is one cell per cellLength at both nodes,
/// whatever lies beyond them, so fibres have no kinks, and one cell in all.
class TwistEasing {
 public:
  TwistEasing(double length_mm, double cellLength_mm) : length_(length_mm) {
    excess_ = std::clamp(length_mm / cellLength_mm, 0.3, 2.5) - 1;
  }
  double cells(double length_mm) const {
    const double x = length_mm / length_;
    return x + excess_ * x * (1 - x) * (1 - 2 * x);
  }
  double maxCellsPerMm() const { return (1 + std::max(excess_, -0.5 * excess_)) / length_; }

 private:
  double length_, excess_ = 0;
};

class CellStations {
 public:
  CellStations(const YarnModel& yarn, const Stretch& stretch, double pitch_mm)
      : yarn_(yarn), stretch_(stretch), pitch_(pitch_mm) {
    const double reach = yarn.bodyReach_mm * yarn.geometry.highest() * yarn.thickest();
    reach_ = reach;
    const int fibres = std::max(1, static_cast<int>(yarn.fibreCount()));
    maxStations_ = std::clamp(kMaxPointsPerCell / fibres, kLeastMaxStations, kMaxStations);
    // Beyond the nodes beside a cell nothing of the yarn may spill into it.
    const double nearest_mm = 0.499 * pitch_mm - yarn.geometry.evenness.crossingsDisplaced_mm;
    maxTilt_ = std::min(1.0, nearest_mm / std::max(reach, 1e-9));
  }

  /// The stations of a transition whose first node lies in the cell about s and has the given phase; its last station
  /// too if `last`.
  void add(const PathNode& from, const PathNode& to, double cell_mm, double phase, bool last) {
    const YarnGeometry& g = yarn_.geometry;
    const double s_mm = cell_mm + from.along_mm;
    const Transition path(from, to, spanBetween_mm(from, to, pitch_));
    const TwistEasing easing(path.length_mm(), g.cellLength_mm);
    const SectionEasing section(g.withinOutline({from.up, from.across}), g.withinOutline({to.up, to.across}),
                                g.withinOutline(g.free));
    RateBounds rates = ratesOf(section, path.length_mm(), easing.maxCellsPerMm(), swingOn(phase));
    const double leaning_mm = static_cast<double>(to.aside_mm) - from.aside_mm;
    rates.slope += 1.5 * std::abs(leaning_mm) / path.length_mm();  // of smoothstep, as below
    rates.bend += 6 * std::abs(leaning_mm) / (path.length_mm() * path.length_mm());
    const auto crownAt = [&](double share) {
      return std::abs(from.height_mm) + share * (std::abs(to.height_mm) - std::abs(from.height_mm));
    };
    const auto asideAt = [&](double share) { return from.aside_mm + leaning_mm * glm::smoothstep(0.0, 1.0, share); };
    double wanted = 0;
    for (const Transition::Piece& piece : path.pieces()) wanted += piece.length_mm / spacing(piece, rates);
    const double coarser = std::max(1.0, wanted / maxStations_);
    for (const Transition::Piece& piece : path.pieces()) {
      const int steps = static_cast<int>(std::ceil(piece.length_mm / (coarser * spacing(piece, rates))));
      for (int i = 0; i < steps; ++i) {
        const double length = piece.begin_mm + piece.length_mm * i / steps;
        const double share = length / path.length_mm();
        place(path.at(length), s_mm, phase + easing.cells(length), {crownAt(share), asideAt(share)}, section.at(share));
      }
    }
    if (last) place(path.at(path.length_mm()), s_mm, phase + 1, {crownAt(1), asideAt(1)}, section.at(1));
  }

  /// Only those that this cell's fibres need.
  std::vector<Station> take() {
    const float edge = static_cast<float>(0.5 * pitch_);
    const auto before = [edge](const Station& x) { return x.s_mm + x.spill_mm < -edge; };
    const auto beyond = [edge](const Station& x) { return x.s_mm - x.spill_mm > edge; };
    size_t first = 0, end = stations_.size();
    while (first + 1 < end && before(stations_[first + 1])) ++first;
    while (end > first + 2 && beyond(stations_[end - 2])) --end;
    return {stations_.begin() + static_cast<ptrdiff_t>(first), stations_.begin() + static_cast<ptrdiff_t>(end)};
  }

 private:
  /// By how much faster than evenly the transition from a phase on is twisted, at most: 0 where two stretches share it.
  double swingOn(double phase) const {
    const double cells = yarn_.geometry.period - 1.0, most = stretch_.twistSwing(), fastest = most > 0 ? 0.25 : 0.75;
    if (most == 0 || phase < 0 || phase + 1 > cells) return 0;
    const double from = phase / cells, to = (phase + 1) / cells;
    if (from < fastest && fastest < to) return std::abs(most);
    return std::max(most * std::sin(2 * kPi * from), most * std::sin(2 * kPi * to));
  }
  /// By the length of the axis, of the place in the round section times the section's factors: from the twists,
  /// migration, the easing of the section, how thickness changes, and the products of these. The same for both
  /// stretches that share a transition.
  RateBounds ratesOf(const SectionEasing<SectionScale>& section, double length_mm, double cellsPerMm,
                     double swing) const {
    const YarnGeometry& g = yarn_.geometry;
    const double twistPerMm = (1 + swing) * cellsPerMm, turn = 2 * kPi * twistPerMm / g.period;
    const double patterns = twistPerMm * yarn_.patterns / g.period;
    const double wander = patterns * yarn_.wandering.slope, wanderBend = patterns * patterns * yarn_.wandering.bend;
    const double spin = turn * (std::abs(g.plyTurns) + std::abs(g.yarnTurns) + std::abs(g.cableTurns));
    const double slope = turn * yarn_.twisting.slope + wander;
    const double hastened = swing == 0 ? 0.0 : 2 * kPi * std::abs(stretch_.twistSwing()) * cellsPerMm / (g.period - 1);
    const double bend = turn * turn * yarn_.twisting.bend + wanderBend + 2 * wander * spin + hastened * slope +
                        yarn_.shapeBend_per_mm * wander * (wander + 2 * turn * yarn_.twisting.slope);
    const double easing = section.slope() / length_mm, easingBend = section.bend() / (length_mm * length_mm);
    const double scale = section.largest() * yarn_.thickest();
    const auto [thickSlope, thickBend] = thicknessRates(cellsPerMm);
    const auto [asideSlope, asideBend] = easingRates(2 * yarn_.farthestOffSett_mm(), cellsPerMm);
    const double swollen = section.largest() * yarn_.bodyReach_mm + g.halfHeight_mm();  // it moves outwards, too
    return {scale * slope + easing * yarn_.bodyReach_mm + thickSlope * swollen + asideSlope,
            asideBend + scale * bend + 2 * (easing + section.largest() * thickSlope) * slope +
                easingBend * yarn_.bodyReach_mm + 2 * easing * thickSlope * yarn_.bodyReach_mm + thickBend * swollen};
  }
  /// Bounds on the derivatives of the factor on the radius, the root of a mass that eases from any state to any other
  /// by smoothstep (Stretch::massAt).
  RateBounds thicknessRates(double cellsPerMm) const {
    const double thinnest = yarn_.thinnest(), thickest = yarn_.thickest();
    const double apart = thickest * thickest - thinnest * thinnest;
    if (apart == 0) return {0, 0};
    const auto [slope, bend] = easingRates(apart, cellsPerMm);
    return {slope / (2 * thinnest), bend / (2 * thinnest) + slope * slope / (4 * thinnest * thinnest * thinnest)};
  }
  /// Bounds on the derivatives of what eases from one to another by smoothstep over a stretch.
  RateBounds easingRates(double apart, double cellsPerMm) const {
    if (apart == 0) return {0, 0};
    const double perMm = cellsPerMm / (yarn_.geometry.period - 1);
    return {1.5 * apart * perMm, 6 * apart * perMm * perMm};
  }

  /// Of stations on a piece, so that chords stay within the sagitta: h^2 / 8 times the second derivative of the
  /// outermost fibre by the length of the axis. Its parts are the path's curvature, the fibre's own way, and the
  /// products of these.
  double spacing(const Transition::Piece& piece, const RateBounds& rates) const {
    const YarnGeometry& g = yarn_.geometry;
    const double bend = std::abs(piece.curvature_per_mm);
    const double second = bend * (1 + bend * reach_) + 2 * bend * rates.slope + rates.bend;
    double step = std::sqrt(8 * kSagitta * g.fibreRadius_mm / std::max(second, 1e-12));
    // Loops rise and fall within a yarn diameter.
    if (!yarn_.flyaways.empty()) step = std::min(step, 0.25 * g.diameter_mm());
    return std::max(step, 1e-9);
  }

  /// Where an even yarn's axis would lie in an even sett: uppermost, and from the middle of its cell.
  struct Axis {
    double crown_mm, aside_mm;
  };
  void place(const AxisPoint& at, double s_mm, double t, const Axis& axis, const SectionScale& section) {
    const YarnGeometry& g = yarn_.geometry;
    Station x;
    const double tilt = std::clamp(std::sin(at.angle), -maxTilt_, maxTilt_);
    x.s_mm = static_cast<float>(s_mm + at.s_mm);
    // Where it is thick the yarn lies further out: what it crosses stays where it is, and touches it still.
    const double thick = stretch_.radiusAt(t, g.period);
    const double outwards = at.z_mm * std::min(1.0, g.halfHeight_mm() / std::max(axis.crown_mm, 1e-9));
    x.z_mm = static_cast<float>(at.z_mm + (thick - 1) * outwards);
    x.aside_mm = static_cast<float>(axis.aside_mm + stretch_.asideAt_mm(t, g.period));
    x.up = static_cast<float>(section.up * thick);
    x.across = static_cast<float>(std::min(section.across * thick, yarn_.widest()));
    x.crown_mm = static_cast<float>(axis.crown_mm);
    x.lift_mm = static_cast<float>(std::max(0.0, 2 * (thick - 1) * g.halfHeight_mm()));
    x.normalS = static_cast<float>(-tilt);
    x.normalZ = static_cast<float>(std::sqrt(1 - tilt * tilt));
    x.spill_mm = static_cast<float>(1.001 * std::abs(tilt) * reach_);
    x.t = t;
    const double twisted = stretch_.twistAt(t, g.period), turn = 2 * kPi * twisted / g.period;
    const auto direction = [turn](int turns) { return glm::vec2(std::cos(turn * turns), std::sin(turn * turns)); };
    x.plyTurn = direction(g.plyTurns);
    if (g.plies > 1) x.yarnTurn = direction(g.yarnTurns);
    if (g.cords > 1) x.cableTurn = direction(g.cableTurns);
    if (!yarn_.plies.empty()) x.migration = yarn_.plies[0].at(twisted * yarn_.patterns / g.period);
    stations_.push_back(x);
  }

  const YarnModel& yarn_;
  const Stretch& stretch_;
  double pitch_, reach_ = 0, maxTilt_ = 1;
  int maxStations_ = kMaxStations;
  std::vector<Station> stations_;
};

}  // namespace

std::vector<Station> layStations(const YarnModel& yarn, const PathNode& previous, const PathNode& here,
                                 const PathNode& next, const CellOfYarn& cell, double pitch_mm) {
  CellStations stations(yarn, cell.stretch, pitch_mm);
  stations.add(previous, here, -pitch_mm, cell.phase - 1, false);
  stations.add(here, next, 0, cell.phase, true);
  return stations.take();
}

}  // namespace loomlight
