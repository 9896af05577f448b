#include "render/trace/loomlight_medium.h"

#include <algorithm>
#include <cmath>

#include "render/optics/fibre_frame.h"
#include "render/trace/cloth_walk.h"
#include "render/trace/fibre_exit.h"
#include "render/trace/fibre_tangent.h"
#include "render/trace/voxel_extinction.h"

namespace loomlight {
namespace {

/// Where a ray crosses the faces of the leaf voxels, which stand in one regular lattice over the whole cloth.
class VoxelFaces {
 public:
  VoxelFaces(glm::vec3 origin, glm::vec3 direction, const VoxelGrid& grid, float t) {
    const glm::vec3 o(origin.x, origin.y, origin.z - grid.zLower_mm);
    for (int axis = 0; axis < 3; ++axis) {
      const float d = direction[axis];
      if (std::abs(d) < 1e-6f) continue;
      between_[axis] = grid.size_mm[axis] / std::abs(d);
      const float voxel = std::floor((o[axis] + t * d) / grid.size_mm[axis]) + (d > 0 ? 1.0f : 0.0f);
      next_[axis] = (voxel * grid.size_mm[axis] - o[axis]) / d;
    }
  }
  /// The first face beyond t; t must not fall.
  float next(float t) {
    for (int axis = 0; axis < 3; ++axis)
      if (next_[axis] <= t) next_[axis] += between_[axis] * (1 + std::floor((t - next_[axis]) / between_[axis]));
    const float nearest = std::min({next_.x, next_.y, next_.z});
    return nearest > t ? nearest : std::nextafter(t, std::numeric_limits<float>::infinity());
  }

 private:
  glm::vec3 next_{std::numeric_limits<float>::infinity()}, between_{std::numeric_limits<float>::infinity()};
};

/// Uniform on the unit hemisphere about z (Lambert's equal-area map of a disc).
glm::vec3 sampleHemisphere(Random& random) {
  for (;;) {
    const float u1 = random.uniform(), u2 = random.uniform();
    const float x = 2 * u1 - 1, y = 2 * u2 - 1, square = x * x + y * y;
    if (square > 1) continue;
    const float scale = std::sqrt(2 - square);
    return {x * scale, y * scale, 1 - square};
  }
}

/// The share of fibres through a point, with tangent m, that would also block the trail: those are not there.
float knownAbsent(const Trail& trail, glm::vec3 point, glm::vec3 m, float spread, float radius_mm) {
  // Seen along m, fibres are discs, and the trail a line.
  const glm::vec3 offset = point - trail.end;
  const glm::vec3 line = trail.direction - glm::dot(trail.direction, m) * m;
  const float lineSquare = glm::dot(line, line);
  if (lineSquare < 1e-6f) return 0;
  const float along = -glm::dot(offset, line) / lineSquare;  // distance back on the trail
  if (along <= 0 || along >= trail.length_mm) return 0;
  const glm::vec3 across = glm::cross(m, line);
  // Tangents that spread see the two ways apart by a little more; not where one way is the other, reversed.
  const glm::vec3 separation = offset - glm::dot(offset, trail.direction) * trail.direction;
  const float apart = std::abs(glm::dot(offset, across)) / std::sqrt(lineSquare) + spread * glm::length(separation);
  return std::max(0.0f, 1 - apart / (2 * radius_mm));
}

/// Distance at which a ray from outside comes to a straight fibre; infinite if it does not.
float distanceTo(const MetFibre& fibre, glm::vec3 origin, glm::vec3 direction) {
  constexpr float kNever = std::numeric_limits<float>::infinity();
  if (fibre.radius_mm <= 0) return kNever;
  const glm::vec3 m = fibre.tangent, o = origin - fibre.axis;
  const glm::vec3 across = direction - glm::dot(direction, m) * m, from = o - glm::dot(o, m) * m;
  const float a = glm::dot(across, across), b = glm::dot(across, from);
  const float c = glm::dot(from, from) - fibre.radius_mm * fibre.radius_mm;
  const float discriminant = b * b - a * c;
  if (b >= 0 || c <= 0 || discriminant <= 0) return kNever;
  return (-b - std::sqrt(discriminant)) / a;
}

/// A collision with the cylinder that a path came from.
Collision collisionWith(const MetFibre& fibre, glm::vec3 point, const Scene& scene) {
  Collision c;
  c.tangent = fibre.tangent;
  c.axis = fibre.axis + glm::dot(point - fibre.axis, fibre.tangent) * fibre.tangent;
  c.yarn = fibre.yarn;
  c.end = fibre.end;
  c.pick = fibre.pick;
  const Yarn& yarn = scene.fabric->yarns[fibre.yarn];
  c.optics = {yarn.fibre, yarn.layout == FibreLayout::packed, fibre.radius_mm};
  return c;
}

}  // namespace

LoomlightMedium::LoomlightMedium(const Scene& scene, Ingredients ingredients)
    : scene_(scene), ingredients_(ingredients) {
  float sum = 0;
  int count = 0;
  for (const auto& system : scene.yarns)
    for (const YarnOptics& optics : system)
      if (optics.fibreRadius_mm > 0) {
        sum += optics.fibreRadius_mm;
        ++count;
      }
  if (ingredients.finiteRadius && count > 0) shiftRadius_mm_ = sum / static_cast<float>(count);
  const glm::vec3 voxel = scene.volume->grid().size_mm;
  step_mm_ = 0.75f * std::min({voxel.x, voxel.y, voxel.z});
}

/// Calls onStep(const VoxelExtinction&, const FibreShift& w, float t, float length, const ShellSegment&, const
/// VoxelContent&) for every step of the ray that has content, t being the world distance from `from` at which it
/// begins; until it returns false. The look-up of a step is at a random point of it, displaced by the finite radius.
template <class OnStep>
bool LoomlightMedium::advance(const Departure& from, glm::vec3 direction, float tMax, Random& random,
                              TraceCounts& counts, OnStep&& onStep) const {
  const FibreFrame frame(direction);  // about the ray
  ClothVolume::Probe probe(*scene_.volume);
  VoxelContent content;
  const float r = shiftRadius_mm_;
  constexpr float kHalfPi = static_cast<float>(kPi / 2);
  const float margin = 2 * kHalfPi * r;  // two displacements apart
  return walkShell(scene_, from.place, direction, tMax, [&](const ShellSegment& s) {
    const glm::mat3 toCloth = s.drape.isometric ? glm::mat3(1.0f) : scene_.shell->tets()[s.tet].toCloth;
    VoxelFaces faces(s.clothOrigin, s.clothDirection, scene_.volume->grid(), s.tEnter);
    for (float t = s.tEnter; t < s.tLeave;) {
      const float length = std::min(faces.next(t), s.tLeave) - t;
      const float at = t + 0.5f * length;
      const glm::vec3 w = sampleHemisphere(random);
      const glm::vec3 shift = r * (w.x * frame.y + w.y * frame.z + kHalfPi * w.z * direction);
      const float empty = probe.look(s.clothOrigin + at * s.clothDirection + toCloth * shift, content);
      if (content.count == 0) {
        t = std::max(t + length, at + empty - margin);
        continue;
      }
      ++counts.steps;
      const glm::vec3 point = s.origin + at * direction;
      const VoxelExtinction voxel(
          scene_, content, s.drape, direction, [&](const FibreDistribution& fibres, const YarnOptics& optics) {
            float factor = 1;
            if (ingredients_.packing && optics.packed) factor /= 1 - fibres.packing;
            if (ingredients_.hotSpot)
              factor *= 1 - knownAbsent(from.trail, point, fibres.direction, fibres.spread, optics.fibreRadius_mm);
            return factor;
          });
      const glm::vec3 across = w.x * frame.y + w.y * frame.z;
      if (!onStep(voxel, across, s.passed + t, length, s, content)) return false;
      t += length;
    }
    return true;
  });
}

std::optional<Collision> LoomlightMedium::collide(const Departure& from, glm::vec3 direction, Random& random,
                                                  TraceCounts& counts) const {
  ++counts.rays;
  const float toPrevious = ingredients_.hotSpot ? distanceTo(from.trail.from, from.place.world, direction)
                                                : std::numeric_limits<float>::infinity();
  float opticalDepth = -std::log1p(-random.uniform());
  std::optional<Collision> met;
  int tet = from.place.tet;
  const bool free =
      advance(from, direction, toPrevious, random, counts,
              [&](const VoxelExtinction& voxel, glm::vec3 across, float t, float length, const ShellSegment& segment,
                  const VoxelContent& content) {
                tet = segment.tet;
                const float depth = voxel.total() * length;
                if (opticalDepth >= depth) {
                  opticalDepth -= depth;
                  return true;
                }
                const VoxelExtinction::Entry& entry = voxel.choose(random.uniform(), EventLaw::projected);
                Collision c;
                c.distance_mm = t + opticalDepth / voxel.total();
                c.tangent = projectedTangent(inWorld(entry.component->decode(), segment.drape), direction, random);
                c.optics = *entry.optics;
                c.yarn = entry.yarn;
                c.end = content.end;
                c.pick = content.pick;
                c.normal = segment.drape.normal();
                // The shift leads from the surface to the axis, so the normal's component across is its negative.
                const glm::vec3 b = glm::cross(c.tangent, direction);
                c.offset = ingredients_.finiteRadius ? std::clamp(-glm::dot(across, b) / glm::length(b), -1.0f, 1.0f)
                                                     : 2 * random.uniform() - 1;
                met = c;
                return false;
              });
  if (free) {
    if (toPrevious == std::numeric_limits<float>::infinity()) return std::nullopt;
    const glm::vec3 point = from.place.world + toPrevious * direction;
    met = collisionWith(from.trail.from, point, scene_);
    met->distance_mm = toPrevious;
    const glm::vec3 b = glm::cross(met->tangent, direction);
    met->normal = glm::normalize(point - met->axis);
    met->offset = std::clamp(glm::dot(met->normal, b) / glm::length(b), -1.0f, 1.0f);
  }
  Collision& c = *met;
  c.place = {from.place.world + c.distance_mm * direction, tet};
  c.incoming = direction;
  c.events = from.events + 1;
  c.before = from.leaving;
  if (!free) {
    const glm::vec3 forward = direction - glm::dot(direction, c.tangent) * c.tangent;
    const glm::vec3 b = glm::cross(c.tangent, direction);
    const glm::vec3 normal = (c.offset * b - std::sqrt(1 - c.offset * c.offset) * forward) / glm::length(b);
    c.axis = c.place.world - c.optics.fibreRadius_mm * normal;
  }
  ++counts.events;
  return met;
}

float LoomlightMedium::transmittance(const Departure& from, glm::vec3 direction, float distance, Random& random,
                                     TraceCounts& counts) const {
  ++counts.rays;
  if (ingredients_.hotSpot && distanceTo(from.trail.from, from.place.world, direction) < distance) return 0;
  constexpr float kExactDepth = 4.0f;
  const float deepest = kExactDepth - std::log1p(-random.uniform());
  float depth = 0;
  const bool through = advance(
      from, direction, distance, random, counts,
      [&](const VoxelExtinction& voxel, glm::vec3, float, float length, const ShellSegment&, const VoxelContent&) {
        depth += voxel.total() * length;
        return depth < deepest;
      });
  return through ? std::exp(-std::min(depth, kExactDepth)) : 0.0f;
}

Departure LoomlightMedium::leave(const Collision& c, glm::vec3 wi, int order) const {
  Departure departure;
  departure.place = c.place;
  departure.events = c.events;
  if (ingredients_.packing && c.optics.packed) departure.place.world = fibreExit(scene_, c, wi, order);
  if (ingredients_.hotSpot) {
    departure.leaving = {c.axis, c.tangent, c.optics.fibreRadius_mm, c.yarn, c.end, c.pick};
    departure.trail = {c.place.world, c.incoming, c.distance_mm, c.before};
  }
  return departure;
}

}  // namespace loomlight
