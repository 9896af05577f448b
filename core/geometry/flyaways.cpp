#include "core/geometry/flyaways.h"

#include <algorithm>
#include <cmath>

#include "core/base/random.h"

// How it works. Loops rise and come back, ends stand off, and most ends lie on the cloth: each rises from its yarn over
// the first quarter of its length and goes on at the height of the crowns, drifting to a side. Reaches are exponential,
// cut off at three means; roots are spread evenly along the yarn.

namespace loomlight {
namespace {

constexpr double kLoopShare = 0.4;
constexpr double kLoopReach = 0.4;    // of an end's
constexpr double kLyingShare = 0.8;   // of ends
constexpr double kLyingLength = 2.5;  // of one that stands
constexpr double kLifted = 0.25;      // of a lying end: what it takes to leave its yarn
constexpr double kMeanReach = 0.281;  // of the truncated exponential below

/// Exponential, cut off at three mean lengths and scaled to (0, 1].
double reachShare(Random& random) {
  return -std::log(1 - random.uniformDouble() * (1 - std::exp(-3.0))) / 3;
}

}  // namespace

std::vector<Flyaway> placeFlyaways(const YarnGeometry& g, double budget_mm) {
  const double length_mm = g.period * g.cellLength_mm;
  const double body = 0.5 * g.diameter_mm();
  const double meanReach_mm = kMeanReach * g.hairLength_mm;
  const double meanEnd_mm =
      (1 - kLyingShare) * 2 * meanReach_mm + kLyingShare * kLyingLength * (meanReach_mm + 0.5 * body);
  const double meanLength_mm = (1 - kLoopShare) * meanEnd_mm + kLoopShare * (2 * body + 4 * kLoopReach * meanReach_mm);
  const double wanted = std::min(
      {g.hairiness_per_mm * length_mm, budget_mm / std::max(meanLength_mm, 1e-9), static_cast<double>(kMaxFlyaways)});
  const int count = static_cast<int>(std::lround(wanted));

  Random random(g.seed ^ 0xF17AA5ull);
  std::vector<Flyaway> flyaways(static_cast<size_t>(count));
  for (int i = 0; i < count; ++i) {
    Flyaway& f = flyaways[i];
    f.loop = random.uniformDouble() < kLoopShare;
    f.rise_mm = g.hairLength_mm * reachShare(random) * (f.loop ? kLoopReach : 1.0);
    f.root_mm = body * (0.6 + 0.35 * random.uniformDouble());
    f.angle = 2 * kPi * random.uniformDouble();
    f.angleSpan = random.uniformDouble() - 0.5;
    f.backwards = random.uniformDouble() < 0.5;
    double span_mm = f.loop ? 2 * body + 4 * f.rise_mm : (f.rise_mm + 0.5 * body) * (0.5 + 3 * random.uniformDouble());
    f.lies = !f.loop && random.uniformDouble() < kLyingShare;
    if (f.lies) {
      // A length of its own, in any direction of the cloth's plane.
      const double length_mm = kLyingLength * (f.rise_mm + 0.5 * body), heading = 2 * kPi * random.uniformDouble();
      span_mm = length_mm * std::max(0.2, std::abs(std::cos(heading)));
      f.drift_mm = length_mm * std::sin(heading);
      f.curl = random.uniformDouble() - 0.5;
      f.rise_mm = g.fibreRadius_mm * (1.5 + 5 * random.uniformDouble());
    }
    f.start = g.period * (i + random.uniformDouble()) / count;
    f.end = f.start + std::min(span_mm / g.cellLength_mm, 0.5 * g.period);
  }
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
    return {bentBack(across), std::cos(angle) * (f.root_mm * axis.section.up + rise)};
  }
  const double share = glm::smoothstep(0.0, kLifted, x);
  const double root = std::cos(f.angle) * f.root_mm * axis.section.up;
  const double side = root < 0 ? -1 : 1;
  const double top = axis.crown_mm + axis.lift_mm + g.halfHeight_mm();
  const double onCloth = side * (top + f.rise_mm * (0.6 + 0.4 * bump)) - axis.here_mm;
  const double across = std::sin(f.angle) * f.root_mm * axis.section.across + f.drift_mm * (x + f.curl * bump * bump);
  return {bentBack(across), root + share * (onCloth - root)};
}

}  // namespace loomlight
