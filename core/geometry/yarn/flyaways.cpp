#include "core/geometry/yarn/flyaways.h"

#include <algorithm>
#include <cmath>

#include "core/base/random.h"

// How it works. Loops rise and come back, ends stand off, and most ends lie on the cloth: each rises from its yarn over
// the first quarter of its length and goes on at the height of the crowns, drifting to a side. Reaches are exponential,
// cut off at three means; roots are spread evenly along the yarn.

namespace loomlight {
namespace {

constexpr double kLifted = 0.25;  // of a lying end: what it takes to leave its yarn

/// Exponential, cut off at three mean lengths and scaled to (0, 1].
double reachShare(Random& random) {
  return -std::log(1 - random.uniformDouble() * (1 - std::exp(-3.0))) / 3;
}

/// An end that brushing has drawn up on the face: it leans over, all of them to about the same side.
void raise(Flyaway& f, const YarnGeometry& g, double length_mm, double& span_mm, Random& random) {
  constexpr double kLeast = 0.35, kMost = 0.9, kSpread = 1.4;  // of the angle to the cloth, and between headings
  const double lean = kLeast + (kMost - kLeast) * random.uniformDouble();
  const double heading = g.hairLie.heading + kSpread * (random.uniformDouble() - 0.5);
  f.angle = 2 * random.uniformDouble() - 1;
  f.isRaised = true;
  f.backwards = std::abs(heading) > 0.25 * kPi && f.backwards;
  span_mm = length_mm * std::cos(lean) * std::max(0.2, std::abs(std::cos(heading)));
  f.drift_mm = length_mm * std::cos(lean) * std::sin(heading);
  f.rise_mm = std::min(length_mm * std::sin(lean), g.hairLength_mm);
}

/// Turns around the body, as tight as they can be.
void addWrappers(const YarnGeometry& g, double budget_mm, std::vector<Flyaway>& flyaways) {
  constexpr double kMeanTurns = 3.5, kMeanAdvance = 0.8;  // over the diameter, a turn
  const double length_mm = g.period * g.cellLength_mm, diameter = g.diameter_mm();
  const double each_mm = kMeanTurns * diameter * std::hypot(kPi, kMeanAdvance);
  const auto count = static_cast<size_t>(
      std::lround(std::min({g.wrappers_per_mm * length_mm, budget_mm / each_mm, static_cast<double>(kMaxFlyaways)})));
  Random random(g.seed ^ 0x3A11B0ull);
  for (size_t i = 0; i < count; ++i) {
    Flyaway f;
    const double turns = kMeanTurns * (0.5 + random.uniformDouble());
    const double advance = kMeanAdvance * diameter * (0.5 + random.uniformDouble());
    const double cells = std::min(turns * advance / g.cellLength_mm, 0.5 * g.period);
    f.angle = 2 * kPi * random.uniformDouble();
    f.angleSpan = (random.uniformDouble() < 0.5 ? 2 : -2) * kPi * turns;
    f.root_mm = g.reach_mm() + g.fibreRadius_mm;
    f.start = g.period * random.uniformDouble();
    f.end = f.start + cells;
    flyaways.push_back(f);
  }
}

}  // namespace

std::vector<Flyaway> placeFlyaways(const YarnGeometry& g, double budget_mm) {
  const double length_mm = g.period * g.cellLength_mm;
  const double body = 0.5 * g.diameter_mm();
  const double meanLength_mm = meanHairLength_mm(g.hairLength_mm, g.diameter_mm(), g.hairLie.lyingShare);
  const double wanted = std::min(
      {g.hairiness_per_mm * length_mm, budget_mm / std::max(meanLength_mm, 1e-9), static_cast<double>(kMaxFlyaways)});
  const int count = static_cast<int>(std::lround(wanted));

  Random random(g.seed ^ 0xF17AA5ull);
  std::vector<Flyaway> flyaways(static_cast<size_t>(count));
  for (int i = 0; i < count; ++i) {
    Flyaway& f = flyaways[i];
    f.loop = random.uniformDouble() < kHairLoopShare;
    f.rise_mm = g.hairLength_mm * reachShare(random) * (f.loop ? kHairLoopReach : 1.0);
    f.root_mm = body * (0.6 + 0.35 * random.uniformDouble());
    f.angle = 2 * kPi * random.uniformDouble();
    f.angleSpan = random.uniformDouble() - 0.5;
    f.backwards = random.uniformDouble() < 0.5;
    double span_mm = f.loop ? 2 * body + 4 * f.rise_mm : (f.rise_mm + 0.5 * body) * (0.5 + 3 * random.uniformDouble());
    f.lies = !f.loop && (g.hairLie.isRaised || random.uniformDouble() < g.hairLie.lyingShare);
    if (f.lies) {
      // A length of its own, in any direction of the cloth's plane.
      const double length_mm = kLyingHairLength * (f.rise_mm + 0.5 * body), heading = 2 * kPi * random.uniformDouble();
      span_mm = length_mm * std::max(0.2, std::abs(std::cos(heading)));
      f.drift_mm = length_mm * std::sin(heading);
      f.curl = random.uniformDouble() - 0.5;
      f.rise_mm = g.fibreRadius_mm * (1.5 + 5 * random.uniformDouble());
      if (g.hairLie.isRaised) raise(f, g, length_mm, span_mm, random);
    }
    f.start = g.period * (i + random.uniformDouble()) / count;
    f.end = f.start + std::min(span_mm / g.cellLength_mm, 0.5 * g.period);
  }
  if (g.wrappers_per_mm > 0) addWrappers(g, budget_mm, flyaways);
  return flyaways;
}

glm::dvec2 flyawayOffset(const Flyaway& f, const YarnGeometry& g, double t, const AxisPosition& axis) {
  double x = (t - f.start) / (f.end - f.start);
  if (f.backwards) x = 1 - x;
  const double bump = std::sin(kPi * x);
  const double rise = f.rise_mm * (f.loop ? bump * bump : x);
  const double angle = f.angle + f.angleSpan * x;
  // Long hairs bend back before they leave the cells beside their own; the sine is nearly straight where most end.
  const double reach = 1.45 * g.crossPitch_mm;
  const auto bentBack = [reach](double across) {
    return reach * std::sin(std::clamp(across / reach, -0.5 * kPi, 0.5 * kPi));
  };
  if (!f.lies) {
    const double across = std::sin(angle) * (f.root_mm * axis.section.across + rise);
    return {bentBack(axis.aside_mm + across), std::cos(angle) * (f.root_mm * axis.section.up + rise)};
  }
  const double share = glm::smoothstep(0.0, kLifted, x);
  const double root = std::cos(f.angle) * f.root_mm * axis.section.up;
  const double side = root < 0 ? -1 : 1;
  const double top = axis.crown_mm + axis.lift_mm + g.halfHeight_mm();
  const double height = f.isRaised ? f.rise_mm * x : f.rise_mm * (0.6 + 0.4 * bump);
  const double onCloth = side * (top + height) - axis.here_mm;
  const double across = std::sin(f.angle) * f.root_mm * axis.section.across + f.drift_mm * (x + f.curl * bump * bump);
  return {bentBack(axis.aside_mm + across), root + share * (onCloth - root)};
}

}  // namespace loomlight
