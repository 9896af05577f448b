#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/random.h"
#include "core/shell/shell.h"
#include "core/volume/traverse/cloth_volume.h"

namespace loomlight::test {

/// The fibres of a flat piece as what they are before any model: solid, clear, smooth cylinders. Rays go from surface
/// to surface in double, mirrored or refracted at each (Snell, Fresnel for unpolarised light), and tell how far they
/// have travelled inside. Written apart from the tracer: nothing but the polylines of the fibres is shared.
///
/// From outside a fibre is the union of capsules, one about each piece of its polyline, as the tracer's are;
/// inside, a ray sees the straight cylinder of the piece that it came into. Surfaces are met from outside only, so that
/// where two fibres overlap by a little, the second one is passed through.
class GlassFibres {
 public:
  /// `index`: refractive, of the fibres against air.
  GlassFibres(const ClothGeometry& geometry, const Shell& shell, double index) : index_(index) {
    layFibres(geometry, glm::dvec3(shell.toCloth(0, glm::vec3(0))));
    sortIntoCells();
  }

  struct Path {
    bool met = false;        ///< any fibre
    bool escaped = true;     ///< false: given up, after so many surfaces
    int surfaces = 0;        ///< that it was mirrored or refracted at
    double inside_mm = 0;    ///< travelled in fibres
    glm::dvec3 direction{};  ///< in which it leaves, unit
  };
  Path follow(glm::dvec3 origin, glm::dvec3 direction, Random& random) const {
    constexpr int kMost = 100'000;
    Path path;
    while (path.surfaces < kMost) {
      const auto entry = enter(origin, direction);
      if (!entry) {
        path.direction = direction;
        return path;
      }
      path.met = true;
      ++path.surfaces;
      origin += entry->distance * direction;
      glm::dvec3 normal = normalAt(capsules_[entry->capsule], origin);
      if (!refracts(direction, normal, index_, random)) continue;
      while (path.surfaces < kMost) {
        const double length = chord(entry->capsule, origin, direction);
        path.inside_mm += length;
        origin += length * direction;
        ++path.surfaces;
        normal = normalAt(capsules_[entry->capsule], origin);
        if (refracts(direction, -normal, 1 / index_, random)) break;
      }
    }
    path.escaped = false;
    return path;
  }

 private:
  struct Capsule {
    glm::dvec3 from, axis;  ///< axis: unit
    double length = 0, radius = 0;
  };
  struct Crossing {
    double distance = 0;
    size_t capsule = 0;
  };
  struct Interval {
    double enter = std::numeric_limits<double>::infinity(), leave = -enter;
    void include(double t0, double t1) {
      enter = std::min(enter, t0);
      leave = std::max(leave, t1);
    }
  };

  void layFibres(const ClothGeometry& geometry, glm::dvec3 origin) {
    for (int pick = 0; pick < geometry.picks(); ++pick)
      for (int end = 0; end < geometry.ends(); ++end)
        for (const System system : {System::warp, System::weft}) {
          const CellStrands cell = geometry.strands(geometry.key(system, pick, end));
          const glm::dvec3 centre((end + 0.5) * geometry.warpPitch_mm(), (pick + 0.5) * geometry.weftPitch_mm(), 0);
          const auto world = [&](glm::dvec3 usz) {
            return centre - origin +
                   (system == System::warp ? glm::dvec3(usz.x, usz.y, usz.z) : glm::dvec3(usz.y, -usz.x, usz.z));
          };
          for (const CellStrands::Strand& strand : cell.strands)
            for (uint32_t i = strand.first; i + 1 < strand.first + strand.count; ++i) {
              const glm::dvec3 a = world(cell.points[i]), b = world(cell.points[i + 1]);
              capsules_.push_back({a, glm::normalize(b - a), glm::distance(a, b), cell.fibreRadius_mm});
            }
        }
  }

  /// A grid of cubes, each with the capsules whose bounds reach into it.
  void sortIntoCells() {
    glm::dvec3 upper(-std::numeric_limits<double>::infinity());
    lower_ = -upper;
    for (const Capsule& c : capsules_) {
      lower_ = glm::min(lower_, boundsOf(c).first);
      upper = glm::max(upper, boundsOf(c).second);
    }
    side_ = 3 * capsules_.front().radius;
    count_ = glm::ivec3(glm::floor((upper - lower_) / side_)) + 1;
    std::vector<uint32_t> filled;
    for (const bool counting : {true, false}) {
      for (size_t i = 0; i < capsules_.size(); ++i) {
        const auto [least, most] = boundsOf(capsules_[i]);
        const glm::ivec3 first = cellOf(least), last = cellOf(most);
        for (int z = first.z; z <= last.z; ++z)
          for (int y = first.y; y <= last.y; ++y)
            for (int x = first.x; x <= last.x; ++x) {
              const size_t cell = numberOf({x, y, z});
              if (counting) {
                ++begins_[cell + 1];
              } else {
                inCell_[filled[cell]++] = static_cast<uint32_t>(i);
              }
            }
      }
      if (!counting) return;
      for (size_t cell = 1; cell < begins_.size(); ++cell) begins_[cell] += begins_[cell - 1];
      inCell_.resize(begins_.back());
      filled = begins_;
    }
  }

  static std::pair<glm::dvec3, glm::dvec3> boundsOf(const Capsule& c) {
    const glm::dvec3 to = c.from + c.length * c.axis;
    return {glm::min(c.from, to) - c.radius, glm::max(c.from, to) + c.radius};
  }
  glm::ivec3 cellOf(glm::dvec3 point) const {
    return glm::clamp(glm::ivec3(glm::floor((point - lower_) / side_)), glm::ivec3(0), count_ - 1);
  }
  size_t numberOf(glm::ivec3 cell) {
    if (begins_.empty()) begins_.resize(static_cast<size_t>(count_.x) * count_.y * count_.z + 1);
    return std::as_const(*this).numberOf(cell);
  }
  size_t numberOf(glm::ivec3 cell) const {
    return (static_cast<size_t>(cell.z) * count_.y + cell.y) * count_.x + cell.x;
  }

  /// The part of a line that lies in a capsule: it is convex. Empty (enter > leave) where there is none.
  static Interval within(const Capsule& c, glm::dvec3 origin, glm::dvec3 direction) {
    const glm::dvec3 o = origin - c.from;
    const double along = glm::dot(direction, c.axis), start = glm::dot(o, c.axis), square = glm::dot(o, o);
    const double dot = glm::dot(o, direction), r2 = c.radius * c.radius;
    const double a = 1 - along * along, b = dot - along * start, rest = square - start * start - r2;
    const double discriminant = b * b - a * rest;
    Interval found;
    if (discriminant < 0 || (a <= 0 && rest > 0)) return found;  // beside the endless cylinder about it
    if (a > 0) {
      const double root = std::sqrt(discriminant);
      double t0 = (-b - root) / a, t1 = (-b + root) / a;
      if (along != 0) {
        const double s0 = -start / along, s1 = (c.length - start) / along;
        t0 = std::max(t0, std::min(s0, s1));
        t1 = std::min(t1, std::max(s0, s1));
      } else if (start < 0 || start > c.length) {
        t1 = t0 - 1;
      }
      if (t0 <= t1) found.include(t0, t1);
    }
    for (const double centre : {0.0, c.length}) {  // a ball at either end
      const double m = dot - centre * along, n = square - 2 * centre * start + centre * centre - r2;
      if (m * m >= n) found.include(-m - std::sqrt(m * m - n), -m + std::sqrt(m * m - n));
    }
    return found;
  }

  /// The first surface ahead that the ray comes to from outside.
  std::optional<Crossing> enter(glm::dvec3 origin, glm::dvec3 direction) const {
    constexpr double kAway_mm = 1e-9;  // more than rounding, and far less than a fibre
    const glm::dvec3 inverse = 1.0 / direction;
    const glm::dvec3 a = (lower_ - origin) * inverse, b = (lower_ + glm::dvec3(count_) * side_ - origin) * inverse;
    const glm::dvec3 least = glm::min(a, b), most = glm::max(a, b);
    const double begin = std::max({0.0, least.x, least.y, least.z}), end = std::min({most.x, most.y, most.z});
    if (!(begin < end)) return std::nullopt;
    glm::ivec3 cell = cellOf(origin + begin * direction);
    glm::dvec3 next;
    for (int axis = 0; axis < 3; ++axis)
      next[axis] = direction[axis] == 0
                       ? std::numeric_limits<double>::infinity()
                       : (lower_[axis] + side_ * (cell[axis] + (direction[axis] > 0)) - origin[axis]) * inverse[axis];
    Crossing first{std::numeric_limits<double>::infinity(), 0};
    for (;;) {
      const size_t number = numberOf(cell);
      for (uint32_t i = begins_[number]; i < begins_[number + 1]; ++i) {
        const Interval in = within(capsules_[inCell_[i]], origin, direction);
        if (in.enter > kAway_mm && in.enter < first.distance && in.enter <= in.leave) first = {in.enter, inCell_[i]};
      }
      const int axis = next.x < next.y ? (next.x < next.z ? 0 : 2) : (next.y < next.z ? 1 : 2);
      if (first.distance <= next[axis]) return first;
      cell[axis] += direction[axis] > 0 ? 1 : -1;
      if (cell[axis] < 0 || cell[axis] >= count_[axis]) {
        if (std::isfinite(first.distance)) return first;
        return std::nullopt;
      }
      next[axis] += side_ * std::abs(inverse[axis]);
    }
  }

  /// How far a ray goes from the surface of a capsule's cylinder to that surface again, through the inside.
  double chord(size_t capsule, glm::dvec3 origin, glm::dvec3 direction) const {
    const Capsule& c = capsules_[capsule];
    const glm::dvec3 o = origin - c.from;
    const glm::dvec3 across = direction - glm::dot(direction, c.axis) * c.axis;
    return std::max(0.0, -2 * glm::dot(across, o) / glm::dot(across, across));
  }

  static glm::dvec3 normalAt(const Capsule& c, glm::dvec3 point) {
    const glm::dvec3 o = point - c.from;
    return glm::normalize(o - glm::dot(o, c.axis) * c.axis);
  }

  /// Sends a ray on from a surface: through it, or mirrored, with the probability that Fresnel's equations give. The
  /// normal is on the side that the ray comes from; `index` is that of the far side over that of the near side.
  static bool refracts(glm::dvec3& direction, glm::dvec3 normal, double index, Random& random) {
    const double cosine = std::min(1.0, std::max(0.0, -glm::dot(direction, normal)));
    const double sineSquared = (1 - cosine * cosine) / (index * index);
    if (sineSquared < 1) {
      const double beyond = std::sqrt(1 - sineSquared);
      const double s = (cosine - index * beyond) / (cosine + index * beyond);
      const double p = (index * cosine - beyond) / (index * cosine + beyond);
      if (random.uniformDouble() >= 0.5 * (s * s + p * p)) {
        direction = glm::normalize((direction + cosine * normal) / index - beyond * normal);
        return true;
      }
    }
    direction = glm::normalize(direction + 2 * cosine * normal);
    return false;
  }

  double index_;
  std::vector<Capsule> capsules_;
  glm::dvec3 lower_{};
  double side_ = 0;
  glm::ivec3 count_{};
  std::vector<uint32_t> begins_, inCell_;  ///< of each cell, into inCell_: capsules
};

}  // namespace loomlight::test
