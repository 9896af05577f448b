#include "core/geometry/yarn/yarn_geometry.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/fabric/model/changes.h"
#include "core/fabric/model/yarn_count.h"

// How it works. A yarn's radius follows from its mass, its fibres' density and how densely they are packed; plies and
// cords give way to one another about their common axis (ply_shape.h). At a crossing the section is pressed flat and
// keeps its area (pressing.h). The twist of the trade is then rounded so that a whole number of turns fits into a few
// cells: the shortest such period whose surface lies within a tolerance of the exact helix, so that one yarn needs few
// bricks.
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
  const double tangent = 2 * kPi * (ply * g.plyRadius_mm + plies * g.cordRadius_mm + cords * g.radius_mm);
  const double turns = (ply + plies + cords) * cellLength_mm;
  const double scale =
      std::min({1.0, kMaxHelixTangent / std::max(tangent, 1e-9), kMaxTurnsPerCell / std::max(turns, 1e-9)});
  return {twist.ply_per_mm * scale, twist.yarn_per_mm * scale, twist.cable_per_mm * scale};
}

/// Sets the ply's radius, and what it makes of the cords' and the yarn's.
void setPlyRadius(YarnGeometry& g, double radius_mm) {
  g.plyRadius_mm = radius_mm;
  // Cords of spun yarn press into one another where their plies stand out; wires cannot.
  g.cordRadius_mm = g.monofilament ? g.plyShape().reach_mm(radius_mm) : g.plyShape().silhouette_mm(radius_mm);
  g.radius_mm = g.cordShape().silhouette_mm(g.cordRadius_mm);
}

/// Ply radius: from the count directly; from a number of fibres through their take-up, which depends on the radius.
double plyRadius_mm(const YarnGeometry& g, const Yarn& yarn, const Fibre& fibre) {
  if (!yarn.fibresPerPly)
    return std::sqrt(yarn.count_tex * 1e-3 / (singlesIn(yarn) * fibre.density_g_cm3 * yarn.packing * kPi));
  const double r = fibre.radius_um * kMmPerUm;
  if (isMonofilament(yarn)) return r;
  YarnGeometry trial = g;
  double takeUp = 1;
  for (int i = 0; i < 20; ++i) {
    setPlyRadius(trial, r * std::sqrt(*yarn.fibresPerPly * takeUp / yarn.packing));
    takeUp = estimateTakeUp(trial, possibleTwist(trial, yarn, 0));
  }
  return trial.plyRadius_mm;
}

/// Section and rest of one state, made to fit between the yarn's neighbours: area is kept, and what rests on the yarn
/// goes up with it.
void fit(const YarnGeometry& g, SectionOutline& section, double& rest_mm) {
  constexpr double kTallest = 2;  // over its width
  const double radius = g.radius_mm, area = section.up * section.across;
  const double widest = std::max(0.5 * g.crossPitch_mm / radius, std::sqrt(area / kTallest));
  const double across = std::min({section.across, widest, 1.3 * g.crossPitch_mm / radius});
  const double up = std::min(area / across, std::max(section.up, kTallest * across));
  rest_mm *= up / section.up;
  section = {up, across};
}

/// Felting works fibres out of a yarn into the gaps beside it, until at 1 it touches its neighbours. It stays as high,
/// so that its fibres lie looser.
void spreadIntoGaps(const YarnGeometry& g, SectionOutline& section, double felting) {
  section.across += felting * std::max(0.0, 0.5 * g.crossPitch_mm / g.radius_mm - section.across);
}

void pressSections(YarnGeometry& g, const Yarn& yarn, double press, double felting) {
  constexpr double kUsualFlattening = 1.2;  // of the yarns that the law was found for
  constexpr SectionOutline kFree = {0.92, 0.97};
  const bool rigid = g.monofilament;
  // As high as a single of their area, plies are wider by what gaps between them they keep.
  const double single = g.plyRadius_mm * std::sqrt(static_cast<double>(g.singles()));
  const double flatter = rigid ? 1.0 : std::sqrt(yarn.flattening / kUsualFlattening) * g.radius_mm / single;
  const double closer = rigid ? 1.0 : std::sqrt(yarn.packing / packingAtCrossings(yarn.packing, felting));
  for (int state = 0; state < kFloatStates; ++state) {
    const Yielding yielding = rigid ? Yielding{} : yieldingOf(press, yarn.packing, state);
    SectionOutline& section = g.pressed[static_cast<size_t>(state)];
    double& rest_mm = g.rest_mm[static_cast<size_t>(state)];
    section = {yielding.section.up * closer / flatter, yielding.section.across * closer * flatter};
    rest_mm = yielding.apart * closer / flatter * g.radius_mm;
    if (rigid) continue;
    fit(g, section, rest_mm);
    spreadIntoGaps(g, section, felting);
  }
  if (rigid) return;
  double unused = 0;
  fit(g, g.free = {kFree.up / flatter, kFree.across * flatter}, unused);
  spreadIntoGaps(g, g.free, felting);
}

Evenness evennessOf(const Yarn& yarn) {
  if (isMonofilament(yarn)) return {};
  Evenness evenness;
  evenness.massCv = yarn.evennessCv_percent / 100;
  if (yarn.slubs_per_m > 0) {
    evenness.slubs_per_mm = yarn.slubs_per_m * 1e-3;
    evenness.slubLength_mm = yarn.slubLength_mm;
    evenness.slubMass = yarn.slubRatio;
  }
  return evenness;
}

}  // namespace

SectionScale YarnGeometry::withinOutline(const SectionOutline& outline) const {
  const auto within = [this](double factor) {
    return std::max(0.5 * factor, (factor * radius_mm - rim_mm) / (radius_mm - rim_mm));
  };
  return {within(outline.up), within(outline.across)};
}

double YarnGeometry::highest() const {
  double most = free.up;
  for (const SectionOutline& section : pressed) most = std::max(most, section.up);
  return std::max(most, withinOutline({most, most}).up);
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
  // Over all fibres the three circular motions are independent. That plies are not quite round is neglected: what is
  // laid is measured.
  return std::sqrt(1 + 0.5 * square(fibres * g.plyRadius_mm) + square(plies * g.plyShape().orbit_mm()) +
                   square(cords * g.cordShape().orbit_mm()));
}

YarnGeometry outlineYarn(const Yarn& yarn, const Fibre& fibre, double pitch_mm, double crossPitch_mm, double press,
                         double felting) {
  YarnGeometry g;
  g.cords = yarn.cords;
  g.plies = yarn.plies;
  g.monofilament = isMonofilament(yarn);
  g.fibreDensity_g_cm3 = fibre.density_g_cm3;
  g.pitch_mm = pitch_mm;
  g.crossPitch_mm = crossPitch_mm;
  g.migration = yarn.migration;
  g.disorder = std::tan(yarn.fibreDisorder_deg * kPi / 180);
  g.hairiness_per_mm = yarn.hairiness_per_mm;
  g.hairLength_mm = yarn.hairiness_per_mm > 0 ? yarn.hairLength_mm : 0.0;
  g.wrappers_per_mm = g.monofilament ? 0.0 : 0.1 * yarn.wrappers_per_cm;
  g.evenness = evennessOf(yarn);
  g.layout = yarn.layout;
  setPlyRadius(g, plyRadius_mm(g, yarn, fibre));
  g.fibreArea_mm2 = (g.monofilament ? 1.0 : yarn.packing) * g.singles() * kPi * g.plyRadius_mm * g.plyRadius_mm;
  pressSections(g, yarn, press, felting);
  return g;
}

void resolveTwist(YarnGeometry& g, const Yarn& yarn, double cellLength_mm) {
  g.cellLength_mm = cellLength_mm;
  const Twist twist = possibleTwist(g, yarn, cellLength_mm);
  const bool varied =
      g.migration > 0 || g.disorder > 0 || g.hairiness_per_mm > 0 || g.wrappers_per_mm > 0 || !g.evenness.isEven();
  double best = -1;
  for (int period = varied ? kMinVariedPeriod : kMinPeriod; period <= kMaxPeriod; ++period) {
    const double length_mm = cellLength_mm * period;
    const auto wholeTurns = [&](double turns_per_mm) { return std::round(turns_per_mm * length_mm); };
    const auto error_mm = [&](double turns_per_mm, double radius_mm) {
      return std::abs(wholeTurns(turns_per_mm) / length_mm - turns_per_mm) * radius_mm;
    };
    const double error =
        2 * kPi *
        std::max({error_mm(twist.ply_per_mm, g.plyRadius_mm), error_mm(twist.yarn_per_mm, g.cordRadius_mm),
                  error_mm(twist.cable_per_mm, g.radius_mm)});
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
