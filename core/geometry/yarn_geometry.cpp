#include "core/geometry/yarn_geometry.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "core/fabric/yarn_count.h"

namespace loomlight {
namespace {

constexpr int kMinPeriod = 4, kMinVariedPeriod = 8;

struct Twist {
  double ply = 0;  ///< signed turns per length; Z positive
  double yarn = 0;
};

Twist nominalTwist_per_mm(const Yarn& yarn) {
  const auto signedTurns = [](double turns_per_m, TwistDirection direction) {
    return (direction == TwistDirection::z ? 1e-3 : -1e-3) * turns_per_m;
  };
  return {signedTurns(yarn.plyTwist_per_m, yarn.plyTwistDirection),
          yarn.plies > 1 ? signedTurns(yarn.yarnTwist_per_m, yarn.yarnTwistDirection) : 0.0};
}

/// The twist that a yarn can take: what is asked, within the physical bounds.
Twist possibleTwist_per_mm(const YarnGeometry& g, const Yarn& yarn, double cellLength_mm) {
  Twist twist = nominalTwist_per_mm(yarn);
  const double tangent =
      2 * kPi * (std::abs(twist.ply) * g.plyRadius_mm + std::abs(twist.yarn) * 0.5 * g.diameter_mm());
  const double turns = (std::abs(twist.ply) + std::abs(twist.yarn)) * cellLength_mm;
  const double scale =
      std::min({1.0, kMaxHelixTangent / std::max(tangent, 1e-9), kMaxTurnsPerCell / std::max(turns, 1e-9)});
  return {twist.ply * scale, twist.yarn * scale};
}

double orbit(int plies, double plyRadius_mm) {
  return plies > 1 ? plyRadius_mm / std::sin(kPi / plies) : 0.0;
}

/// Ply radius: from the count directly; from a number of fibres through their take-up, which depends on the radius.
double plyRadius_mm(const YarnGeometry& g, const Yarn& yarn, const Fibre& fibre) {
  if (!yarn.fibresPerPly)
    return std::sqrt(yarn.count_tex * 1e-3 / (yarn.plies * fibre.density_g_cm3 * yarn.packing * kPi));
  const double r = fibre.radius_um * kMmPerUm;
  if (*yarn.fibresPerPly == 1) return r;
  YarnGeometry trial = g;
  double takeUp = 1;
  for (int i = 0; i < 20; ++i) {
    trial.plyRadius_mm = r * std::sqrt(*yarn.fibresPerPly * takeUp / yarn.packing);
    trial.plyOrbit_mm = orbit(yarn.plies, trial.plyRadius_mm);
    const Twist twist = possibleTwist_per_mm(trial, yarn, 0);
    takeUp = estimateTakeUp(trial, twist.ply, twist.yarn);
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

/// What the fibres depend on, and nothing else.
auto shapeOf(const Yarn& y, const Fibre& f) {
  const Twist twist = nominalTwist_per_mm(y);
  return std::tuple(f.radius_um, f.density_g_cm3, y.fibresPerPly, y.fibresPerPly ? 0.0 : y.count_tex, y.plies,
                    twist.ply, twist.yarn, y.packing, y.flattening, y.hairiness_per_mm,
                    y.hairiness_per_mm > 0 ? y.hairLength_mm : 0.0, y.migration, y.layout);
}

}  // namespace

double YarnGeometry::contactShare() const {
  if (plies == 1) return 1;
  const double mean = plies / kPi * std::sin(kPi / plies);
  return (plyRadius_mm + mean * plyOrbit_mm) / (plyRadius_mm + plyOrbit_mm);
}

std::vector<int> geometryClasses(const Fabric& fabric) {
  std::vector<int> classes;
  std::vector<decltype(shapeOf(Yarn{}, Fibre{}))> shapes;
  for (const Yarn& yarn : fabric.yarns) {
    const auto shape = shapeOf(yarn, meanFibre(yarn, fabric.fibres));
    const auto found = std::find(shapes.begin(), shapes.end(), shape);
    classes.push_back(static_cast<int>(found - shapes.begin()));
    if (found == shapes.end()) shapes.push_back(shape);
  }
  return classes;
}

double estimateTakeUp(const YarnGeometry& g, double plyTurns_per_mm, double yarnTurns_per_mm) {
  const double spin = 2 * kPi * (plyTurns_per_mm + yarnTurns_per_mm), swing = 2 * kPi * yarnTurns_per_mm;
  const double meanSquareSlope =
      0.5 * spin * spin * g.plyRadius_mm * g.plyRadius_mm + swing * swing * g.plyOrbit_mm * g.plyOrbit_mm;
  return std::sqrt(1 + meanSquareSlope);
}

YarnGeometry outlineYarn(const Yarn& yarn, const Fibre& fibre, double pitch_mm, double crossPitch_mm) {
  YarnGeometry g;
  g.plies = yarn.plies;
  g.fibreDensity_g_cm3 = fibre.density_g_cm3;
  g.packing = yarn.packing;
  g.pitch_mm = pitch_mm;
  g.crossPitch_mm = crossPitch_mm;
  g.migration = yarn.migration;
  g.hairiness_per_mm = yarn.hairiness_per_mm;
  g.hairLength_mm = yarn.hairiness_per_mm > 0 ? yarn.hairLength_mm : 0.0;
  g.layout = yarn.layout;
  g.plyRadius_mm = plyRadius_mm(g, yarn, fibre);
  g.plyOrbit_mm = orbit(g.plies, g.plyRadius_mm);
  flatten(g, yarn.flattening);
  return g;
}

void resolveTwist(YarnGeometry& g, const Yarn& yarn, double cellLength_mm) {
  g.cellLength_mm = cellLength_mm;
  const Twist twist = possibleTwist_per_mm(g, yarn, cellLength_mm);
  const bool varied = g.migration > 0 || g.hairiness_per_mm > 0;
  double best = -1;
  for (int period = varied ? kMinVariedPeriod : kMinPeriod; period <= kMaxPeriod; ++period) {
    const double plyTurns = std::round(twist.ply * cellLength_mm * period);
    const double yarnTurns = std::round(twist.yarn * cellLength_mm * period);
    const double plyError = std::abs(plyTurns / (cellLength_mm * period) - twist.ply);
    const double yarnError = std::abs(yarnTurns / (cellLength_mm * period) - twist.yarn);
    const double error = 2 * kPi * std::max(plyError * g.plyRadius_mm, yarnError * 0.5 * g.diameter_mm());
    if (best >= 0 && error >= best) continue;
    best = error;
    g.period = period;
    g.plyTurns = static_cast<int>(plyTurns);
    g.yarnTurns = static_cast<int>(yarnTurns);
    if (error <= kTwistTolerance) break;
  }
  if (!varied && g.plyTurns == 0 && g.yarnTurns == 0) g.period = 1;
}

}  // namespace loomlight
