#include "core/fabric/weave/jacquard.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/glm.hpp>
#include <optional>

#include "core/base/units.h"

// How it works. The design is a function of the place in the repeat, made of shapes with a signed distance: leaves for
// petals, sepals and stems, ribbons for the trellis. The first shape that covers a spot decides in which structure it
// is woven.

namespace loomlight {
namespace {

/// What a spot of the design is woven in, from warp to weft on the face.
enum class Ground { satin, halfTone, twill, sateen };

constexpr double kTau = 2.0 * kPi;

/// Distance to the outline of a leaf (two arcs that meet in points), negative inside. It starts at the origin, points
/// to `angle` from straight up, turning right.
double leaf(glm::dvec2 p, double angle, double length, double width) {
  const double c = std::cos(angle), s = std::sin(angle);
  const glm::dvec2 q(std::abs(c * p.x - s * p.y), s * p.x + c * p.y - 0.5 * length);  // axis along y, middle at 0
  const double half = 0.5 * length;
  const double offset = (half * half - 0.25 * width * width) / width;  // centre of the arc, beyond the axis
  const double radius = offset + 0.5 * width;
  if (std::abs(q.y) * offset > half * (q.x + offset)) return glm::length(glm::dvec2(q.x, std::abs(q.y) - half));
  return glm::length(q + glm::dvec2(offset, 0.0)) - radius;
}

/// Distance to the middle rib of such a leaf.
double rib(glm::dvec2 p, double angle, double from, double to) {
  const double c = std::cos(angle), s = std::sin(angle);
  const glm::dvec2 q(c * p.x - s * p.y, s * p.x + c * p.y);
  return glm::length(glm::dvec2(q.x, q.y - std::clamp(q.y, from, to)));
}

struct Leaf {
  double angle_deg, length, width;
};
/// Of one half of the palmette; the other half is its mirror image.
constexpr Leaf kPetals[] = {{0, 0.255, 0.085}, {27, 0.235, 0.078}, {53, 0.205, 0.070}, {79, 0.170, 0.062}};
constexpr Leaf kSepals[] = {{118, 0.160, 0.062}, {158, 0.175, 0.060}};

/// Slender stems between the petals, each with a bud at its end.
constexpr Leaf kStems[] = {{13.5, 0.345, 0.034}, {40, 0.335, 0.034},  {66, 0.320, 0.034},
                           {96, 0.295, 0.034},   {138, 0.270, 0.034}, {180, 0.265, 0.034}};

constexpr double kOutline = 0.008;
constexpr double kRib = 0.0045;
constexpr double kBud = 0.075;

double radians(double degrees) {
  return degrees * kPi / 180.0;
}

/// What a petal shows at q; nothing where it does not cover q.
std::optional<Ground> petal(glm::dvec2 q, const Leaf& l, Ground inside) {
  const double d = leaf(q, radians(l.angle_deg), l.length, l.width);
  if (d > kOutline) return std::nullopt;
  if (d > 0) return Ground::halfTone;
  return rib(q, radians(l.angle_deg), 0.06, 0.80 * l.length) < kRib ? Ground::satin : inside;
}

std::optional<Ground> stem(glm::dvec2 q, const Leaf& l) {
  const double angle = radians(l.angle_deg);
  const glm::dvec2 budStart = (l.length - kBud) * glm::dvec2(std::sin(angle), std::cos(angle));
  const double d = leaf(q - budStart, angle, kBud, l.width);
  if (d < -0.006) return Ground::twill;
  if (d < 0 || rib(q, angle, 0.10, l.length - kBud) < kRib) return Ground::sateen;
  return std::nullopt;
}

/// The blossom around the origin, in units of the repeat; y up. Nothing where the ground shows.
std::optional<Ground> blossom(glm::dvec2 p) {
  const glm::dvec2 q(std::abs(p.x), p.y + 0.045);  // the leaves spring from below the middle
  const double r = glm::length(q);
  if (r < 0.030) return Ground::satin;
  if (r < 0.040) return Ground::sateen;
  if (r < 0.062) {  // a ring of seeds
    const double turn = std::atan2(q.x, q.y) * 14.0 / kTau;
    return std::abs(turn - std::round(turn)) < 0.28 ? Ground::satin : Ground::twill;
  }
  // Nearer petals lie on farther ones: the first that covers a spot decides.
  for (const Leaf& l : kPetals)
    if (const auto g = petal(q, l, Ground::sateen)) return g;
  for (const Leaf& l : kSepals)
    if (const auto g = petal(q, l, Ground::twill)) return g;
  for (const Leaf& l : kStems)
    if (const auto g = stem(q, l)) return g;
  return std::nullopt;
}

/// Six small petals where the ribbons of the trellis meet.
std::optional<Ground> rosette(glm::dvec2 p) {
  const double r = glm::length(p);
  if (r < 0.010) return Ground::sateen;
  if (r < 0.016) return Ground::satin;
  const double petalReach = 0.036 + 0.016 * std::cos(6.0 * std::atan2(p.x, p.y));
  if (r < petalReach) return Ground::sateen;
  if (r < petalReach + kOutline) return Ground::satin;
  return std::nullopt;
}

/// Two ribbons a repeat that part and meet around each blossom, with a twisted cord between their rims.
Ground trellis(glm::dvec2 p) {
  const double x = std::abs(p.x - std::round(p.x));
  const double y = p.y - std::round(p.y);
  // The lozenge |x| = 1/4 (1 + cos) with its points drawn out is an ogee.
  const double c = std::cos(kTau * y);
  const double ribbon = 0.25 * (1.0 + c) + 0.028 * std::sin(2.0 * kTau * std::abs(y));
  const double slope = std::abs(-0.25 * kTau * std::sin(kTau * y));
  const double d = std::abs(x - ribbon) / std::sqrt(1.0 + slope * slope);
  if (d < 0.0085) {
    const double strand = y * 46.0;
    return std::abs(strand - std::round(strand)) < 0.30 ? Ground::sateen : Ground::satin;
  }
  if (d < 0.0125) return Ground::satin;
  if (d < 0.0215) return Ground::sateen;
  if (d < 0.0260) return Ground::halfTone;
  return Ground::satin;
}

/// The design over one repeat, u and v in [0, 1): two blossoms in half drop, two rosettes between them, the trellis.
Ground design(double u, double v) {
  const auto around = [&](double x, double y) {
    const glm::dvec2 p(u - x, v - y);
    return p - glm::round(p);
  };
  for (const double half : {0.0, 0.5}) {
    if (const auto g = blossom(around(half, half))) return *g;
    if (const auto g = rosette(around(half, half + 0.5))) return *g;
  }
  return trellis({u, v});
}

/// Whether the warp is up: the sateen of eight with move three, `raised` of its eight ends up.
bool sateen8(int pick, int end, int raised) {
  return ((end - 3 * pick) % 8 + 8) % 8 < raised;
}

}  // namespace

Weave damaskJacquard(int ends, int picks) {
  assert(ends >= 8 && ends <= Weave::kMaxSide && picks >= 8 && picks <= Weave::kMaxSide);
  std::vector<Weave::SharedRow> rows(static_cast<size_t>(picks));
  for (int p = 0; p < picks; ++p) {
    Weave::Row row(static_cast<size_t>(ends));
    for (int e = 0; e < ends; ++e) {
      switch (design((e + 0.5) / ends, (p + 0.5) / picks)) {
        case Ground::satin:
          row[e] = sateen8(p, e, 7);
          break;
        case Ground::halfTone:
          row[e] = sateen8(p, e, 4);
          break;
        case Ground::twill:
          row[e] = (e + p) % 4 == 0;
          break;
        case Ground::sateen:
          row[e] = sateen8(p, e, 1);
          break;
      }
    }
    rows[p] = std::make_shared<const Weave::Row>(std::move(row));
  }
  return Weave(std::move(rows));
}

}  // namespace loomlight
