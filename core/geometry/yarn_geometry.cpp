#include "core/geometry/yarn_geometry.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/fabric/model/changes.h"
#include "core/fabric/model/yarn_count.h"

namespace loomlight {
namespace {

constexpr int kMinPeriod = 4, kMinVariedPeriod = 8;

Twist nominalTwist(const Yarn& yarn) {
  const auto signedTurns = [](double turns_per_m, TwistDirection direction) {
    return (direction == TwistDirection::z ? 1e-3 : -1e-3) * turns_per_m;
  };
  return {signedTurns(yarn.plyTwist_per_m, yarn.plyTwistDirection),
          yarn.plies > 1 ? signedTurns(yarn.yarnTwist_per_m, yarn.yarnTwistDirection) : 0.0,
          yarn.cords > 1 ? signedTurns(yarn.cableTwist_per_m, yarn.cableTwistDirection) : 0.0};
}

/// The twist that a yarn can take: what is asked, within the physical bounds.
Twist possibleTwist(const YarnGeometry& g, const Yarn& yarn, double cellLength_mm) {
  const Twist twist = nominalTwist(yarn);
  const double ply = std::abs(twist.ply_per_mm), plies = std::abs(twist.yarn_per_mm),
               cords = std::abs(twist.cable_per_mm);
  const double tangent = 2 * kPi * (ply * g.plyRadius_mm + plies * g.cordRadius_mm() + cords * 0.5 * g.diameter_mm());
  const double turns = (ply + plies + cords) * cellLength_mm;
  const double scale =
      std::min({1.0, kMaxHelixTangent / std::max(tangent, 1e-9), kMaxTurnsPerCell / std::max(turns, 1e-9)});
  return {twist.ply_per_mm * scale, twist.yarn_per_mm * scale, twist.cable_per_mm * scale};
}

/// Distance from their common axis of circles that touch.
double orbit(int circles, double radius_mm) {
  return circles > 1 ? radius_mm / std::sin(kPi / circles) : 0.0;
}

/// Mean height of the topmost of circles on that orbit as they turn, over the orbit.
double meanTop(int circles) {
  return circles / kPi * std::sin(kPi / circles);
}

/// Sets the ply's radius, and where it puts plies and cords.
void setPlyRadius(YarnGeometry& g, double radius_mm) {
  g.plyRadius_mm = radius_mm;
  g.plyOrbit_mm = orbit(g.plies, radius_mm);
  g.cordOrbit_mm = orbit(g.cords, g.cordRadius_mm());
}

/// Ply radius: from the count directly; from a number of fibres through their take-up, which depends on the radius.
double plyRadius_mm(const YarnGeometry& g, const Yarn& yarn, const Fibre& fibre) {
  if (!yarn.fibresPerPly)
    return std::sqrt(yarn.count_tex * 1e-3 / (singlesIn(yarn) * fibre.density_g_cm3 * yarn.packing * kPi));
  const double r = fibre.radius_um * kMmPerUm;
  if (*yarn.fibresPerPly == 1) return r;
  YarnGeometry trial = g;
  double takeUp = 1;
  for (int i = 0; i < 20; ++i) {
    setPlyRadius(trial, r * std::sqrt(*yarn.fibresPerPly * takeUp / yarn.packing));
    takeUp = estimateTakeUp(trial, possibleTwist(trial, yarn, 0));
  }
  return trial.plyRadius_mm;
}

void flatten(YarnGeometry& g, double flattening) {
  const double round = 0.5 * g.diameter_mm();
  double a = round * std::sqrt(flattening);
  a = std::min(a, std::max(0.5 * g.crossPitch_mm / g.contactShare(), round * std::sqrt(0.5)));
  a = std::min(a, 1.3 * g.crossPitch_mm);
  g.halfWidth_mm = a;
  g.halfHeight_mm = std::min(round * round / a, 2 * a);
}

}  // namespace

double YarnGeometry::contactShare() const {
  return 2 * (plyRadius_mm + meanTop(plies) * plyOrbit_mm + meanTop(cords) * cordOrbit_mm) / diameter_mm();
}

std::vector<int> geometryClasses(const Fabric& fabric) {
  std::vector<int> classes, firstYarns;  // of a class
  for (int yarn = 0; yarn < static_cast<int>(fabric.yarns.size()); ++yarn) {
    const auto found = std::find_if(firstYarns.begin(), firstYarns.end(),
                                    [&](int first) { return sameShape(fabric, first, fabric, yarn); });
    classes.push_back(static_cast<int>(found - firstYarns.begin()));
    if (found == firstYarns.end()) firstYarns.push_back(yarn);
  }
  return classes;
}

Twist twistOf(const YarnGeometry& g) {
  const double length_mm = g.period * g.cellLength_mm;
  return {g.plyTurns / length_mm, g.yarnTurns / length_mm, g.cableTurns / length_mm};
}

double estimateTakeUp(const YarnGeometry& g, const Twist& twist) {
  const auto square = [](double x) { return x * x; };
  const double cords = 2 * kPi * twist.cable_per_mm;
  const double plies = cords + 2 * kPi * twist.yarn_per_mm;
  const double fibres = plies + 2 * kPi * twist.ply_per_mm;
  // Over all fibres the three circular motions are independent.
  return std::sqrt(1 + 0.5 * square(fibres * g.plyRadius_mm) + square(plies * g.plyOrbit_mm) +
                   square(cords * g.cordOrbit_mm));
}

YarnGeometry outlineYarn(const Yarn& yarn, const Fibre& fibre, double pitch_mm, double crossPitch_mm) {
  YarnGeometry g;
  g.cords = yarn.cords;
  g.plies = yarn.plies;
  g.fibreDensity_g_cm3 = fibre.density_g_cm3;
  g.pitch_mm = pitch_mm;
  g.crossPitch_mm = crossPitch_mm;
  g.migration = yarn.migration;
  g.disorder = std::tan(yarn.fibreDisorder_deg * kPi / 180);
  g.hairiness_per_mm = yarn.hairiness_per_mm;
  g.hairLength_mm = yarn.hairiness_per_mm > 0 ? yarn.hairLength_mm : 0.0;
  g.layout = yarn.layout;
  setPlyRadius(g, plyRadius_mm(g, yarn, fibre));
  flatten(g, yarn.flattening);
  return g;
}

void resolveTwist(YarnGeometry& g, const Yarn& yarn, double cellLength_mm) {
  g.cellLength_mm = cellLength_mm;
  const Twist twist = possibleTwist(g, yarn, cellLength_mm);
  const bool varied = g.migration > 0 || g.disorder > 0 || g.hairiness_per_mm > 0;
  double best = -1;
  for (int period = varied ? kMinVariedPeriod : kMinPeriod; period <= kMaxPeriod; ++period) {
    const double length_mm = cellLength_mm * period;
    const auto wholeTurns = [&](double turns_per_mm) { return std::round(turns_per_mm * length_mm); };
    const auto error_mm = [&](double turns_per_mm, double radius_mm) {
      return std::abs(wholeTurns(turns_per_mm) / length_mm - turns_per_mm) * radius_mm;
    };
    const double error =
        2 * kPi *
        std::max({error_mm(twist.ply_per_mm, g.plyRadius_mm), error_mm(twist.yarn_per_mm, g.cordRadius_mm()),
                  error_mm(twist.cable_per_mm, 0.5 * g.diameter_mm())});
    if (best >= 0 && error >= best) continue;
    best = error;
    g.period = period;
    g.plyTurns = static_cast<int>(wholeTurns(twist.ply_per_mm));
    g.yarnTurns = static_cast<int>(wholeTurns(twist.yarn_per_mm));
    g.cableTurns = static_cast<int>(wholeTurns(twist.cable_per_mm));
    if (error <= kTwistTolerance) break;
  }
  if (!varied && g.plyTurns == 0 && g.yarnTurns == 0 && g.cableTurns == 0) g.period = 1;
}

}  // namespace loomlight
