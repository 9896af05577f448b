#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "render/scene/scene.h"

namespace loomlight::test {

/// The strands of a flat piece, met by looking at each segment in turn: slow, in double, and written apart from the
/// tracer. A segment is a cylinder with a ball at either end.
class FibreOracle {
 public:
  struct Segment {
    glm::dvec3 a, b;
    double radius = 0;
    System system = System::warp;
    int across = 0;     ///< which end or pick
    size_t strand = 0;  ///< of its cell
    bool sameFibre(const Segment& s) const { return system == s.system && across == s.across && strand == s.strand; }
    glm::dvec3 tangent() const { return glm::normalize(b - a); }
  };
  struct Hit {
    double distance = 0;
    double offset = 0;  ///< h: how far aside of the segment's axis the ray passes, in radii, signed
    const Segment* segment = nullptr;
  };

  explicit FibreOracle(const Scene& scene) {
    const ClothGeometry& geometry = scene.cloth->volume->geometry();
    const glm::dvec3 origin(scene.cloth->shell->toCloth(0, glm::vec3(0)));
    for (int pick = 0; pick < geometry.picks(); ++pick)
      for (int end = 0; end < geometry.ends(); ++end)
        for (const System system : {System::warp, System::weft}) {
          const CellStrands cell = geometry.strands(geometry.key(system, pick, end));
          const glm::dvec3 centre((end + 0.5) * geometry.warpPitch_mm(), (pick + 0.5) * geometry.weftPitch_mm(), 0);
          const auto world = [&](glm::dvec3 usz) {
            return centre - origin +
                   (system == System::warp ? glm::dvec3(usz.x, usz.y, usz.z) : glm::dvec3(usz.y, -usz.x, usz.z));
          };
          for (size_t s = 0; s < cell.strands.size(); ++s) {
            const auto& strand = cell.strands[s];
            for (uint32_t i = strand.first; i + 1 < strand.first + strand.count; ++i)
              segments_.push_back({world(cell.points[i]), world(cell.points[i + 1]), cell.fibreRadius_mm, system,
                                   system == System::warp ? end : pick, s});
          }
        }
  }

  const std::vector<Segment>& segments() const { return segments_; }

  /// The first surface that a ray enters within `length`; not that of `own` nearer than `clearance`.
  std::optional<Hit> meet(glm::dvec3 origin, glm::dvec3 direction,
                          double length = std::numeric_limits<double>::infinity(), const Segment* own = nullptr,
                          double clearance = 0) const {
    std::optional<Hit> first;
    for (const Segment& s : segments_) {
      const double t = enter(s, origin, direction);
      if (!(t >= 0 && t < length) || (own && t < clearance && s.sameFibre(*own))) continue;
      if (isInside(s, origin + t * direction)) continue;
      length = t;
      first = Hit{t, offset(s, origin, direction), &s};
    }
    return first;
  }

  /// Whether rounding may decide what the ray meets: it passes a silhouette, or starts on a surface other than `own`.
  bool isDelicate(glm::dvec3 origin, glm::dvec3 direction, const Segment* own, double tolerance) const {
    for (const Segment& s : segments_) {
      const double aside = std::abs(offset(s, origin, direction));
      const double above = distanceToAxis(s, origin) / s.radius;
      if (std::abs(aside - 1) < tolerance) return true;
      if (std::abs(above - 1) < tolerance && !(own && s.sameFibre(*own))) return true;
    }
    return false;
  }

  /// The line's signed distance from that of the axis, in radii, as BCSDFs have it: along tangent x direction.
  static double offset(const Segment& s, glm::dvec3 origin, glm::dvec3 direction) {
    const glm::dvec3 across = glm::cross(s.tangent(), direction);
    return glm::dot(origin - s.a, across) / (glm::length(across) * s.radius);
  }

 private:
  /// Whether the surface of a segment is hidden in another of its fibre.
  bool isInside(const Segment& of, glm::dvec3 point) const {
    return std::any_of(segments_.begin(), segments_.end(), [&](const Segment& s) {
      return &s != &of && s.sameFibre(of) && distanceToAxis(s, point) < (1 - 1e-6) * s.radius;
    });
  }
  static double distanceToAxis(const Segment& s, glm::dvec3 p) {
    const glm::dvec3 axis = s.b - s.a;
    const double x = std::clamp(glm::dot(p - s.a, axis) / glm::dot(axis, axis), 0.0, 1.0);
    return glm::distance(p, s.a + x * axis);
  }
  /// Where a ray from outside enters the segment; NaN where it does not.
  static double enter(const Segment& s, glm::dvec3 origin, glm::dvec3 direction) {
    double t = std::numeric_limits<double>::quiet_NaN();
    const auto keep = [&t](double candidate) {
      if (candidate >= 0 && !(t <= candidate)) t = candidate;
    };
    for (const glm::dvec3 centre : {s.a, s.b}) {
      const glm::dvec3 o = origin - centre;
      const double b = glm::dot(o, direction), c = glm::dot(o, o) - s.radius * s.radius;
      if (b * b >= c) keep(-b - std::sqrt(b * b - c));
    }
    const glm::dvec3 m = s.tangent(), o = origin - s.a;
    const glm::dvec3 d = direction - glm::dot(direction, m) * m, p = o - glm::dot(o, m) * m;
    const double a = glm::dot(d, d), b = glm::dot(d, p), c = glm::dot(p, p) - s.radius * s.radius;
    if (a > 0 && b * b >= a * c) {
      const double wall = (-b - std::sqrt(b * b - a * c)) / a, along = glm::dot(o + wall * direction, m);
      if (along >= 0 && along <= glm::distance(s.a, s.b)) keep(wall);
    }
    return t;
  }

  std::vector<Segment> segments_;
};

}  // namespace loomlight::test
