#include "render/media/loomlight_medium.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/media/cloth_walk.h"
#include "render/media/fibre_exit.h"
#include "render/media/fibre_tangent.h"
#include "render/media/path_through.h"
#include "render/media/voxel_extinction.h"
#include "render/optics/fibre_frame.h"

namespace loomlight {
namespace {

/// Two points of the unit hemisphere about z, each uniform, on opposite sides of it, and one as high as the other is
/// low.
struct AntitheticPoints {
  glm::vec3 first, second;
  explicit AntitheticPoints(Random& random) {
    glm::vec2 side(0);
    float square = 0;
    do {
      const float u = random.uniform(), v = random.uniform();
      side = {2 * u - 1, 2 * v - 1};
      square = glm::dot(side, side);
    } while (square > 1 || square < 1e-12f);
    // Uniform heights are those of Lambert's equal-area map of the disc.
    const float height = square;
    side /= std::sqrt(square);
    first = {std::sqrt(1 - height * height) * side, height};
    second = {-std::sqrt(height * (2 - height)) * side, 1 - height};
  }
};

/// The share of extinction that is left of fibres near earlier flights, and beside the fibre that the last flight came
/// from: that one is met for itself, so a voxel must not count it again.
class CorrelationState {
 public:
  CorrelationState(const LoomlightMedium::Memory& memory, const ShellSegment& s, const VoxelGrid& grid,
                   glm::mat3 toCloth)
      : memory_(memory),
        grid_(grid),
        before_(s.clothOrigin + toCloth * (memory.before.axis - s.origin),
                glm::normalize(toCloth * memory.before.tangent), memory.before.radius_mm, grid_) {}

  float share(const FibreDistribution& fibres, float radius_mm, bool packed, YarnId yarnId, glm::vec3 point,
              glm::ivec3 voxel) const {
    float absent = 0;
    for (const RaySegment& flight : memory_.flights)
      if (flight.length_mm > 0)
        absent = std::max(absent, knownAbsent(flight, point, fibres.direction, fibres.spread, radius_mm));
    float before = 0;
    if (memory_.before.radius_mm > 0 && yarnId == memory_.before.yarnId && packed)
      before = std::min(1.0f, before_.lengthDensity(grid_.lower_mm(voxel)) / fibres.lengthDensity);
    return (1 - absent) * (1 - before);
  }

 private:
  const LoomlightMedium::Memory& memory_;
  const VoxelGrid& grid_;
  FibreInVoxels before_;
};

/// The offset h at which a fibre is met whose axis was drawn by a point w of the unit hemisphere about the ray.
class OffsetAcross {
 public:
  explicit OffsetAcross(const Collision& met) {
    const FibreFrame frame(met.incoming);
    const glm::vec3 b = glm::cross(met.tangent, met.incoming);
    // The shift leads from the surface to the axis, so the normal's component across is its negative.
    towards_ = -glm::vec2(glm::dot(frame.y, b), glm::dot(frame.z, b)) / glm::length(b);
  }
  float operator()(glm::vec3 w) const { return std::clamp(w.x * towards_.x + w.y * towards_.y, -1.0f, 1.0f); }

 private:
  glm::vec2 towards_;
};

bool isWithin(glm::vec3 place, glm::vec3 size) {
  return glm::all(glm::greaterThanEqual(place, glm::vec3(0))) && glm::all(glm::lessThan(place, size));
}

/// A collision with the cylinder that a path came from.
Collision collisionWith(const MetFibre& fibre, const ScenePoint& place, glm::vec3 direction, const TraceData& cloth) {
  Collision c;
  c.place = place;
  c.incoming = direction;
  c.tangent = fibre.tangent;
  c.axis = fibre.axis + glm::dot(place.world - fibre.axis, fibre.tangent) * fibre.tangent;
  c.normal = glm::normalize(place.world - c.axis);
  const glm::vec3 b = glm::cross(c.tangent, direction);
  c.offset = std::clamp(glm::dot(c.normal, b) / glm::length(b), -1.0f, 1.0f);
  c.yarnId = fibre.yarnId;
  c.yarn = fibre.yarn;
  c.end = fibre.end;
  c.pick = fibre.pick;
  c.optics = cloth.yarns[static_cast<int>(fibre.yarnId.system)][fibre.yarn];
  return c;
}

/// The share that a voxel's components have left, seen from its middle on the ray.
struct CorrelatedShare {
  const CorrelationState* unknown;  ///< null: all of it
  glm::vec3 middle;
  glm::ivec3 voxel;

  float operator()(const FibreDistribution& fibres, const YarnOptics& optics, const VoxelContent::Part& part) const {
    if (!unknown) return 1;
    return unknown->share(fibres, optics.fibreRadius_mm, optics.packed, {part.system, part.index}, middle, voxel);
  }
};

}  // namespace

/// A ray on its way through the stretches along which light can meet fibres whose axes lie in one voxel, in order.
class LoomlightMedium::Stretches {
 public:
  Stretches(const LoomlightMedium& medium, const ScenePoint& from, const Memory& memory, glm::vec3 direction,
            float tMax)
      : medium_(medium), memory_(memory), direction_(direction), shell_(*medium.cloth_, from, direction, tMax) {}

  /// False where nothing is left.
  bool next() {
    for (;;) {
      while (!march_ || !march_->next())
        if (!enterSegment()) return false;
      if (enterVoxel()) return true;
    }
  }

  // Of the stretch where it stands, until it goes on. It is [t, t + length] from the start of the flight. Up to t +
  // near the light is still in the voxel before, or in none, and the gaps are as wide as there.
  float t = 0, length = 0, near = 0;
  float sigmaNear = 0, sigma = 0;  ///< 1/mm
  float ahead = 0;                 ///< of the light, the axes: c
  VoxelExtinction extinction;

  float depthNear() const { return sigmaNear * near; }
  float depth() const { return depthNear() + sigma * (length - near); }
  const VoxelContent& content() const { return march_->content(); }
  const ShellSegment& segment() const { return shell_.segment(); }
  CorrelatedShare share() const {
    const glm::vec3 middle = segment().origin + 0.5f * (march_->enter() + march_->leave()) * direction_;
    return {medium_.ingredients_.hotSpot ? &*unknown_ : nullptr, middle, content().voxel};
  }

 private:
  bool enterSegment() {
    if (!shell_.next()) return false;
    const ShellSegment& s = segment();
    unknown_.emplace(memory_, s, medium_.cloth_->volume->grid(), medium_.toClothOf(s.tet));
    last_ = -1;
    filled_ = 0;
    march_.emplace(*medium_.cloth_->volume, s.clothOrigin, s.clothDirection, s.tEnter, s.tLeave + medium_.farthest_mm_);
    return true;
  }

  /// The axes lie ahead of the light: u is where they are, t where the light is. False where none is in the voxel while
  /// the light is in the segment.
  bool enterVoxel() {
    constexpr float kFullest = 0.9f;  // of space; no gap is so narrow that light could not be in it
    const ShellSegment& s = segment();
    const float uEnter = march_->enter(), uLeave = march_->leave();
    const float filledBefore = uEnter - last_ < 1e-5f ? filled_ : 0.0f;
    extinction = sumExtinction(medium_.cloth_->yarns, content(), s.drape, direction_, share());
    last_ = uLeave;
    filled_ = medium_.ingredients_.packing ? std::min(extinction.packed, kFullest) : 0.0f;
    ahead = std::min(0.5f * extinction.solid / extinction.whole, medium_.farthest_mm_);
    const float start = std::max(uEnter, s.tEnter + ahead), stop = std::min(uLeave, s.tLeave + ahead);
    if (!(start < stop)) return false;
    t = s.passed + start - ahead;
    length = stop - start;
    near = std::clamp(uEnter + ahead - start, 0.0f, length);
    sigmaNear = extinction.total / (1 - filledBefore);
    sigma = extinction.total / (1 - filled_);
    return true;
  }

  const LoomlightMedium& medium_;
  const Memory& memory_;
  glm::vec3 direction_;
  ShellWalk shell_;
  std::optional<CorrelationState> unknown_;  ///< of the segment
  std::optional<ClothVolume::March> march_;
  float last_ = -1, filled_ = 0;  ///< where the voxel before ended, and how much of it is fibre
};

LoomlightMedium::LoomlightMedium(std::shared_ptr<const TraceData> cloth, Ingredients ingredients)
    : cloth_(std::move(cloth)), ingredients_(ingredients) {
  float sum = 0;
  int count = 0;
  for (const auto& system : cloth_->yarns)
    for (const YarnOptics& optics : system)
      if (optics.fibreRadius_mm > 0) {
        sum += optics.fibreRadius_mm;
        ++count;
      }
  if (!ingredients.finiteRadius || count == 0) return;
  radius_mm_ = sum / static_cast<float>(count);
  farthest_mm_ = static_cast<float>(kPi) * radius_mm_;  // four times that of a fibre across the ray
}

glm::mat3 LoomlightMedium::toClothOf(int tet) const {
  return cloth_->shell->isFlat() ? glm::mat3(1.0f) : cloth_->shell->tets()[tet].toCloth;
}

/// Which fibre is met at t.
Collision LoomlightMedium::meet(const ScenePoint& from, glm::vec3 direction, const Stretches& stretch, float t,
                                Random& random, Meeting& meeting) const {
  const ShellSegment& s = stretch.segment();
  Collision c;
  c.incoming = direction;
  c.distance_mm = t;
  c.place = {from.world + t * direction, s.tet};
  c.normal = s.drape.normal();
  const auto take = [&](const VoxelContent& content, const auto& share) {
    const MetComponent met =
        chooseComponent(cloth_->yarns, content, s.drape, direction, random.uniform(), EventLaw::projected, share);
    c.tangent = eitherWay(projectedTangent(met.fibres, direction, random), random);
    c.optics = *met.optics;
    c.yarnId = met.yarnId;
    c.yarn = met.yarn;
    c.end = content.end;
    c.pick = content.pick;
  };
  if (!ingredients_.finiteRadius) {
    take(stretch.content(), stretch.share());
    c.offset = 2 * random.uniform() - 1;
    meeting.inOneVoxel = true;
    return c;
  }
  const FibreFrame frame(direction);  // about the ray
  const glm::mat3 toCloth = toClothOf(s.tet);
  const glm::vec3 place = s.clothOrigin + (t - s.passed) * s.clothDirection;
  const auto across = [&](glm::vec3 w) { return w.x * frame.y + w.y * frame.z; };
  // Most often the axis is looked for in the very voxel that the stretch is in.
  const VoxelGrid& grid = cloth_->volume->grid();
  const glm::vec3 lower = grid.lower_mm(stretch.content().voxel);
  ClothVolume::Probe probe(*cloth_->volume);
  VoxelContent contents[2];
  float elsewhere[2] = {0, 0};  // extinction of what was found in other voxels
  const auto look = [&](glm::vec3 w, int i) {
    const glm::vec3 shift = radius_mm_ * across(w) + 2 * stretch.ahead * w.z * direction;
    const glm::vec3 axis = place + toCloth * shift;
    if (isWithin(axis - lower, grid.size_mm)) return stretch.extinction.whole;
    meeting.inOneVoxel = false;
    probe.look(axis, contents[i]);
    return elsewhere[i] = sumExtinction(cloth_->yarns, contents[i], s.drape, direction).whole;
  };
  const AntitheticPoints w(random);
  meeting.inOneVoxel = true;
  const float first = look(w.first, 0), second = look(w.second, 1);
  const bool takesFirst = random.uniform() * (first + second) < first;
  const int taken = takesFirst ? 0 : 1;
  if (elsewhere[taken] > 0)
    take(contents[taken], WholeExtinction{});
  else
    take(stretch.content(), stretch.share());
  meeting.points[0] = takesFirst ? w.first : w.second;
  meeting.points[1] = takesFirst ? w.second : w.first;
  meeting.inVoxel_mm = place - lower;
  meeting.ahead_mm = stretch.ahead;
  c.offset = OffsetAcross(c)(meeting.points[0]);
  return c;
}

/// What a meeting is with hangs on the voxel that the axis lies in, and on nothing else of the two antithetic points.
/// So where both lay in one voxel, all other pairs of points that do belong to the same component and tangent.
size_t LoomlightMedium::offsetsAcross(const Collision& met, const Memory& memory, std::span<float> offsets,
                                      Random& random) const {
  offsets[0] = met.offset;
  const Meeting& meeting = memory.meeting;
  if (!meeting.inOneVoxel) return 1;
  if (!ingredients_.finiteRadius) return evenOffsets(met.offset, offsets);
  const OffsetAcross offset(met);
  const FibreFrame frame(met.incoming);
  const glm::mat3 toCloth = toClothOf(met.place.tet);
  const glm::vec3 size_mm = cloth_->volume->grid().size_mm;
  const auto isInVoxel = [&](glm::vec3 w) {
    const glm::vec3 shift = radius_mm_ * (w.x * frame.y + w.y * frame.z) + 2 * meeting.ahead_mm * w.z * met.incoming;
    return isWithin(meeting.inVoxel_mm + toCloth * shift, size_mm);
  };
  size_t count = 1;
  offsets[count++] = offset(meeting.points[1]);
  for (size_t tried = 2; tried + 1 < offsets.size(); tried += 2) {
    const AntitheticPoints w(random);
    if (!isInVoxel(w.first) || !isInVoxel(w.second)) continue;
    offsets[count++] = offset(w.first);
    offsets[count++] = offset(w.second);
  }
  return count;
}

std::unique_ptr<MediumPath> LoomlightMedium::path() const {
  return std::make_unique<PathThrough<LoomlightMedium>>(*this);
}

std::optional<Collision> LoomlightMedium::collide(const ScenePoint& from, Memory& memory, glm::vec3 direction,
                                                  Random& random, TraceCounts& counts) const {
  constexpr float kNever = std::numeric_limits<float>::infinity();
  ++counts.rays;
  const float toBefore = ingredients_.hotSpot ? distanceTo(memory.before, from.world, direction) : kNever;
  float opticalDepth = -std::log(1 - random.uniform());
  std::optional<Collision> met;
  int tet = from.tet;
  for (Stretches stretch(*this, from, memory, direction, toBefore); !met && stretch.next();) {
    ++counts.steps;
    tet = stretch.segment().tet;
    const float depth = stretch.depth();
    if (opticalDepth >= depth) {
      opticalDepth -= depth;
      continue;
    }
    const float beyondNear = opticalDepth - stretch.depthNear();
    const float t =
        stretch.t + (beyondNear < 0 ? opticalDepth / stretch.sigmaNear : stretch.near + beyondNear / stretch.sigma);
    met = meet(from, direction, stretch, t, random, memory.meeting);
    met->axis = axisOf(*met);
  }
  if (!met) {
    if (toBefore == kNever) return std::nullopt;
    met = collisionWith(memory.before, {from.world + toBefore * direction, tet}, direction, *cloth_);
    memory.meeting.inOneVoxel = false;
    met->distance_mm = toBefore;
  }
  met->material = drawMaterial(met->optics, random);
  if (ingredients_.hotSpot) {
    memory.before = memory.leaving;
    memory.leaving = {met->axis, met->tangent, met->optics.fibreRadius_mm, met->yarnId, met->yarn, met->end, met->pick};
    memory.flights = {RaySegment{met->place.world, direction, met->distance_mm}, memory.flights[0]};
  }
  return met;
}

float LoomlightMedium::transmittance(const ScenePoint& from, const Memory& memory, glm::vec3 direction, float distance,
                                     Random& random, TraceCounts& counts) const {
  ++counts.rays;
  if (ingredients_.hotSpot && distanceTo(memory.before, from.world, direction) < distance) return 0;
  constexpr float kExactDepth = 4.0f;
  const float deepest = kExactDepth - std::log(1 - random.uniform());
  float depth = 0;
  for (Stretches stretch(*this, from, memory, direction, distance); stretch.next();) {
    ++counts.steps;
    depth += stretch.depth();
    if (!(depth < deepest)) return 0;
  }
  return std::exp(-std::min(depth, kExactDepth));
}

glm::vec3 LoomlightMedium::exit(const Collision& met, glm::vec3 wi, int order) const {
  return ingredients_.packing && met.optics.packed ? fibreExit(*cloth_, met, wi, order) : met.place.world;
}

}  // namespace loomlight
