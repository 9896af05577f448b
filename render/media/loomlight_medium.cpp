#include "render/media/loomlight_medium.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "render/media/fibre_exit.h"
#include "render/media/fibre_tangent.h"
#include "render/media/voxel_extinction.h"
#include "render/optics/fibre_frame.h"

// How it works. The header says what the law is. A voxel tells what meets a path in three draws: a walk finds the
// voxel; two antithetic points of a hemisphere say where the axis of the fibre could lie, and the voxels there, how
// likely each of the two is; of the voxel of the one that was taken a component, a tangent and a material are drawn.
// Whatever changes the extinction there, such as a way that is known to be free, changes the walk and the draws alike,
// or a white furnace would not stay white.
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

/// The share of extinction that a voxel's fibres have left near the flights before, and beside the fibre that the last
/// of these flights came from: that one is met for itself, so a voxel must not count it again.
class CorrelatedShare {
 public:
  CorrelatedShare(const KnownFibres& known, const FoundFibres& found, const VoxelGrid& grid, const glm::mat3& toCloth)
      : known_(known), middle_(found.middle), lower_(grid.lower_mm(found.content.voxel)) {
    const ShellSegment& s = found.segment;
    const KnownFibre& before = known.before;
    if (before.radius_mm <= 0) return;
    before_.emplace(s.clothOrigin + toCloth * (before.axis - s.origin), glm::normalize(toCloth * before.tangent),
                    before.radius_mm, grid);
  }

  float operator()(const FibreDistribution& fibres, const YarnOptics& optics,
                   const VoxelContent::YarnSpan& span) const {
    float absent = 0;
    for (const RaySegment& past : known_.pastSegments)
      if (past.length_mm > 0)
        absent = std::max(absent, knownAbsent(past, middle_, fibres.direction, fibres.spread, optics.fibreRadius_mm));
    float before = 0;
    if (before_ && YarnId{span.system, span.index} == known_.before.yarnId && optics.packed)
      before = std::min(1.0f, before_->lengthDensity(lower_) / fibres.lengthDensity);
    return (1 - absent) * (1 - before);
  }

 private:
  const KnownFibres& known_;
  glm::vec3 middle_;  ///< of the ray in the voxel, world
  glm::vec3 lower_;   ///< corner of the voxel
  std::optional<FibreInVoxels> before_;
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
  return std::min({place.x, place.y, place.z}) >= 0 && place.x < size.x && place.y < size.y && place.z < size.z;
}

}  // namespace

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

Collision LoomlightMedium::meet(const ScenePoint& from, glm::vec3 direction, const FoundFibres& found, Random& random,
                                Memory& memory) const {
  const ShellSegment& s = found.segment;
  Meeting& meeting = memory.meeting;
  Collision c;
  c.incoming = direction;
  c.distance_mm = found.t_mm;
  c.place = {from.world + found.t_mm * direction, s.tet};
  c.normal = s.drape.normal();
  const glm::mat3 toCloth = toClothOf(s.tet);
  const VoxelGrid& grid = cloth_->volume->grid();
  const auto take = [&](const VoxelContent& content, const auto& share) {
    const MetComponent met =
        chooseComponent(cloth_->yarns, content, s.drape, direction, random.uniform(), EventLaw::projected, share);
    c.tangent = eitherWay(projectedTangent(met.fibres, direction, random), random);
    c.optics = *met.optics;
    c.radius_mm = c.optics.fibreRadius_mm;
    c.yarnId = met.yarnId;
    c.yarn = met.yarn;
    c.end = content.end;
    c.pick = content.pick;
  };
  const auto takeFound = [&] {
    if (ingredients_.hotSpot && hasSeveralComponents(found.content))
      take(found.content, CorrelatedShare(memory.known, found, grid, toCloth));
    else
      take(found.content, WholeExtinction{});
  };
  if (!ingredients_.finiteRadius) {
    takeFound();
    c.offset = 2 * random.uniform() - 1;
    meeting.inOneVoxel = true;
  } else {
    const FibreFrame frame(direction);  // about the ray
    const glm::vec3 place = s.clothOrigin + (found.t_mm - s.passed) * s.clothDirection;
    const auto across = [&](glm::vec3 w) { return w.x * frame.y + w.y * frame.z; };
    // Most often the axis is looked for in the very voxel that was found.
    const glm::vec3 lower = grid.lower_mm(found.content.voxel);
    VoxelContent contents[2];
    float elsewhere[2] = {0, 0};  // extinction of what was found in other voxels
    const auto look = [&](glm::vec3 w, int i) {
      const glm::vec3 shift = radius_mm_ * across(w) + 2 * found.ahead_mm * w.z * direction;
      const glm::vec3 axis = place + toCloth * shift;
      if (isWithin(axis - lower, grid.size_mm)) return found.whole;
      meeting.inOneVoxel = false;
      found.cells.contentAt(axis, contents[i]);
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
      takeFound();
    meeting.points[0] = takesFirst ? w.first : w.second;
    meeting.points[1] = takesFirst ? w.second : w.first;
    meeting.inVoxel_mm = place - lower;
    meeting.ahead_mm = found.ahead_mm;
    c.offset = OffsetAcross(c)(meeting.points[0]);
  }
  c.axis = axisOf(c);
  c.material = drawMaterial(c.optics, random);
  return c;
}

Collision LoomlightMedium::meetBefore(const ScenePoint& place, glm::vec3 direction, float distance_mm, Random& random,
                                      Memory& memory) const {
  const KnownFibre& fibre = memory.known.before;
  Collision c;
  c.place = place;
  c.distance_mm = distance_mm;
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
  c.optics = cloth_->yarns[static_cast<int>(fibre.yarnId.system)][fibre.yarn];
  c.radius_mm = fibre.radius_mm;
  c.material = drawMaterial(c.optics, random);
  memory.meeting.inOneVoxel = false;
  return c;
}

void LoomlightMedium::remember(const Collision& met, Memory& memory) const {
  if (!ingredients_.hotSpot) return;
  KnownFibres& known = memory.known;
  known.before = known.leaving;
  known.leaving = {met.axis, met.tangent, met.radius_mm, met.yarnId, met.yarn, met.end, met.pick};
  known.pastSegments = {RaySegment{met.place.world, met.incoming, met.distance_mm}, known.pastSegments[0]};
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

glm::vec3 LoomlightMedium::exit(const Collision& met, glm::vec3 wi, float inside) const {
  return ingredients_.packing && met.optics.packed ? fibreExit(*cloth_, met, wi, inside) : met.place.world;
}

}  // namespace loomlight
