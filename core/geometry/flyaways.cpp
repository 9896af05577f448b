#include "core/geometry/flyaways.h"

#include <algorithm>
#include <cmath>

#include "core/base/random.h"

namespace loomlight {
namespace {

constexpr double kLoopShare = 0.4;
constexpr double kLoopReach = 0.4;    // of an end's
constexpr double kMeanReach = 0.281;  // of the truncated exponential below

/// Exponential, cut off at three mean lengths and scaled to (0, 1].
double reachShare(Random& random) {
  return -std::log(1 - random.uniformDouble() * (1 - std::exp(-3.0))) / 3;
}

}  // namespace

std::vector<Flyaway> placeFlyaways(const YarnGeometry& g, double budget_mm) {
  const double length_mm = g.period * g.cellLength_mm;
  const double body = 0.5 * g.diameter_mm();
  const double meanLength_mm = (1 - kLoopShare) * 2 * kMeanReach * g.hairLength_mm +
                               kLoopShare * (2 * body + 4 * kLoopReach * kMeanReach * g.hairLength_mm);
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
    const double span_mm =
        f.loop ? 2 * body + 4 * f.rise_mm : (f.rise_mm + 0.5 * body) * (0.5 + 3 * random.uniformDouble());
    f.start = g.period * (i + random.uniformDouble()) / count;
    f.end = f.start + std::min(span_mm / g.cellLength_mm, 0.5 * g.period);
  }
  return flyaways;
}

glm::dvec2 flyawayOffset(const Flyaway& f, const YarnGeometry& g, double t) {
  double x = (t - f.start) / (f.end - f.start);
  if (f.backwards) x = 1 - x;
  const double bump = std::sin(kPi * x);
  const double rise = f.rise_mm * (f.loop ? bump * bump : x);
  const double angle = f.angle + f.angleSpan * x;
  const double round = 0.5 * g.diameter_mm();
  // Long hairs bend back before they leave the cells beside their own; the sine is nearly straight where most end.
  const double reach = 1.45 * g.crossPitch_mm;
  const double across = std::sin(angle) * (f.root_mm * g.halfWidth_mm / round + rise);
  return {reach * std::sin(across / reach), std::cos(angle) * (f.root_mm * g.halfHeight_mm / round + rise)};
}

}  // namespace loomlight
