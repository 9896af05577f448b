#include "render/media/loomlight_meetings.h"

#include "core/base/columns.h"
#include "render/media/across_fibre.h"
#include "render/media/antithetic_points.h"
#include "render/media/fibre_tangent.h"
#include "render/media/known_lanes.h"

// How it works. A walk has found the voxel in which the depth of a ray is used up. Two antithetic points of the
// hemisphere about the ray (AntitheticPoints) say where the axis of the fibre could lie instead, and the extinction of
// the voxels there how likely each of the two is: where that is not the part of the found voxel in which all of its
// components are, render/walk looks there, for all meetings at once. Then a component is drawn of those at the point
// that was taken, a tangent of it, and how the fibre lies across the ray follows from the point. Whatever changes the
// extinction in a voxel, such as a way that is known to be free, changes the walk and the choice of a component alike,
// or a white furnace would not stay white; which of the two points is taken hangs on all fibres, known or not.
//
// Most voxels hold one component, which the walk names; where there are several, render/walk chooses.
namespace loomlight {
namespace {

/// A component's fibres as they lie in the world.
FibreDistribution inWorld(FibreDistribution fibres, const LocalDrape& drape) {
  if (!drape.isometric) {
    float stretch = 1;
    fibres.direction = drape.tangent(fibres.direction, stretch);
    fibres.lengthDensity *= stretch * drape.densityScale;
  }
  return fibres;
}

glm::vec3 lightOf(const LoomlightMeetings::Meeting& meeting) {
  return meeting.from->world + meeting.found->t_mm * meeting.direction;
}

}  // namespace

struct LoomlightMeetings::Fibres {
  Vectors direction{};
  Lanes spread{};
  Lanes radius_mm{};

  void put(size_t lane, const FibreDistribution& fibres, float radius) {
    direction.x[lane] = fibres.direction.x;
    direction.y[lane] = fibres.direction.y;
    direction.z[lane] = fibres.direction.z;
    spread[lane] = fibres.spread;
    radius_mm[lane] = radius;
  }
};

LoomlightMeetings::LoomlightMeetings(const LoomlightMedium& medium, LaneWalker& walker)
    : medium_(medium),
      cloth_(medium.cloth()),
      walker_(walker),
      looks_(std::make_unique<LookLanes>()),
      choices_(std::make_unique<ChoiceLanes>()) {
  *looks_ = {};
  *choices_ = {};
}

void LoomlightMeetings::meet(std::span<const Meeting> meetings) {
  const size_t count = meetings.size();
  std::array<Random*, kMost> randoms{};
  for (size_t lane = 0; lane < count; ++lane) randoms[lane] = meetings[lane].random;
  RandomLanes<Lanes> random(randoms);
  const auto direction = columnsOf<Lanes>(count, [&](size_t i) { return meetings[i].direction; });
  for (size_t lane = 0; lane < count; ++lane) common_[lane] = commonPart(meetings[lane]);
  Lanes offset{};
  if (medium_.ingredients().finiteRadius) {
    lookForAxes(meetings, direction, random);
  } else {
    offset = 2 * random.uniform() - 1;
    takenLook_ = broadcast<Lanes>(kNone);
    amongAll_ = random.inUse();
  }
  chooseFibres(meetings);
  Fibres fibres;
  for (size_t lane = 0; lane < count; ++lane) take(meetings[lane], lane, fibres);
  const Vectors drawn = medium_.ingredients().law == EventLaw::report
                            ? anyTangent<Lanes>(fibres.direction, fibres.spread, random)
                            : projectedTangent<Lanes>(fibres.direction, fibres.spread, direction, random);
  Lanes way = broadcast<Lanes>(1);
  for (size_t lane = 0; lane < count; ++lane) way[lane] = eitherWay(*meetings[lane].random);
  const Vectors tangent = way * drawn;
  if (medium_.ingredients().finiteRadius) offset = OffsetAcross<Lanes>(direction, tangent)(points_[0]);
  const Vectors inwards = -fibres.radius_mm * surfaceNormal<Lanes>(direction, tangent, offset);
  for (size_t lane = 0; lane < count; ++lane) tell(meetings[lane], lane, tangent, offset[lane], inwards);
}

/// Draws the two points of each meeting, and which of them is taken.
void LoomlightMeetings::lookForAxes(std::span<const Meeting> meetings, const Vectors& direction,
                                    RandomLanes<Lanes>& random) {
  const size_t count = meetings.size();
  const FibreFrameOf<Vectors> frame(direction);  // about the ray
  const AntitheticPoints<Lanes> w(random);
  const Lanes ahead = columnOf<Lanes>(count, [&](size_t i) { return meetings[i].found->ahead_mm; });
  const auto shift = [&](const Vectors& point) {
    return broadcast<Lanes>(medium_.radius_mm()) * (point.x * frame.y + point.y * frame.z) +
           (2 * ahead * point.z) * direction;
  };
  const Vectors axes[2] = {axisAfter(meetings, shift(w.first)), axisAfter(meetings, shift(w.second))};
  looks_->wanted.fill(0);
  const Mask firstStays = lookThere(meetings, 0, axes[0]), secondStays = lookThere(meetings, 1, axes[1]);
  amongAll_ = firstStays & secondStays;
  if (any(~amongAll_)) look(walker_.field(), *looks_);

  const Lanes found = columnOf<Lanes>(count, [&](size_t i) { return meetings[i].found->whole; });
  Lanes elsewhere[2];
  for (size_t point = 0; point < 2; ++point)
    for (size_t lane = 0; lane < kMost; ++lane) {
      const size_t look = point * kMost + lane;
      elsewhere[point][lane] = looks_->wanted[look] ? looks_->found.whole[look] : 0.0f;
    }
  const Lanes first = firstStays ? found : elsewhere[0], second = secondStays ? found : elsewhere[1];
  const Mask takesFirst = random.uniform() * (first + second) < first;
  points_[0] = {takesFirst ? w.first.x : w.second.x, takesFirst ? w.first.y : w.second.y,
                takesFirst ? w.first.z : w.second.z};
  points_[1] = {takesFirst ? w.second.x : w.first.x, takesFirst ? w.second.y : w.first.y,
                takesFirst ? w.second.z : w.first.z};
  const Lanes none = broadcast<Lanes>(kNone), among = broadcast<Lanes>(kAmongAll);
  const Lanes lanes = {0, 1, 2, 3, 4, 5, 6, 7};
  const Lanes firstLook = elsewhere[0] > 0 ? lanes : none, secondLook = elsewhere[1] > 0 ? lanes + kMost : none;
  takenLook_ = takesFirst ? (firstStays ? among : firstLook) : (secondStays ? among : secondLook);
}

/// Where in the found voxel all of its components are.
LoomlightMeetings::VoxelPart LoomlightMeetings::commonPart(const Meeting& meeting) {
  const FoundFibres& found = *meeting.found;
  if (found.component >= 0) {
    const VoxelBox box = cloth_.volume->components()[found.component].box();
    return {box.lowerCorner(), box.upperCorner()};
  }
  VoxelContent content;
  walker_.cells().bricksIn(found.cell).content(*cloth_.volume, found.voxel, content);
  VoxelPart common;
  for (int span = 0; span < content.count; ++span)
    for (const Component& component : content.spans[span].components) {
      common.lower = glm::max(common.lower, component.box().lowerCorner());
      common.upper = glm::min(common.upper, component.box().upperCorner());
    }
  return common;
}

/// Where the axis of the fibre is, if it is so far from the light, in the world: counted in cloth space from the corner
/// of the light's cell.
LoomlightMeetings::Vectors LoomlightMeetings::axisAfter(std::span<const Meeting> meetings, const Vectors& shift) const {
  const size_t count = meetings.size();
  Vectors inCloth = shift;
  if (!cloth_.shell->isFlat()) {
    const auto column = [&](int k) {
      return columnsOf<Lanes>(count, [&](size_t i) { return cloth_.shell->tets()[meetings[i].found->tet].toCloth[k]; });
    };
    inCloth = shift.x * column(0) + shift.y * column(1) + shift.z * column(2);
  }
  return columnsOf<Lanes>(count, [&](size_t i) { return meetings[i].found->inCell_mm; }) + inCloth;
}

/// Which axes, of one point of each meeting, are in the common part. The others want a look, but for the rest of a
/// voxel of one component alone, where nothing is.
LoomlightMeetings::Mask LoomlightMeetings::lookThere(std::span<const Meeting> meetings, size_t point,
                                                     const Vectors& axis) {
  const size_t count = meetings.size();
  const glm::vec3 size = cloth_.volume->grid().size_mm;
  const auto voxel = columnsOf<Lanes>(count, [&](size_t i) { return glm::vec3(meetings[i].found->voxel); });
  const Vectors inVoxel = axis - Vectors{size.x * voxel.x, size.y * voxel.y, size.z * voxel.z};
  const auto isWithin = [&inVoxel](const Vectors& lower, const Vectors& upper) {
    return (inVoxel.x >= lower.x) & (inVoxel.y >= lower.y) & (inVoxel.z >= lower.z) & (inVoxel.x < upper.x) &
           (inVoxel.y < upper.y) & (inVoxel.z < upper.z);
  };
  const Vectors whole{broadcast<Lanes>(size.x), broadcast<Lanes>(size.y), broadcast<Lanes>(size.z)};
  const Mask inSame = isWithin(Vectors{}, whole);
  const auto lower = columnsOf<Lanes>(count, [&](size_t i) { return size * common_[i].lower; });
  const auto upper = columnsOf<Lanes>(count, [&](size_t i) { return size * common_[i].upper; });
  const Mask inCommon = isWithin(lower, upper);
  for (size_t lane = 0; lane < count; ++lane) {
    const bool mayBeElsewhere = inSame[lane] == 0 || meetings[lane].found->component < 0;
    if (inCommon[lane] == 0 && mayBeElsewhere)
      wantLook(meetings[lane], point * kMost + lane, {axis.x[lane], axis.y[lane], axis.z[lane]});
  }
  return inCommon;
}

/// Into the voxel around a point, which is counted from the corner of the cell in which the light is. Outside of the
/// piece there is none.
void LoomlightMeetings::wantLook(const Meeting& meeting, size_t lane, glm::vec3 axis_mm) {
  const auto place = cloth_.volume->locate(meeting.found->cell, axis_mm);
  if (!place) return;
  lookPlaces_[lane] = *place;
  fill(*looks_, lane, *place, meeting);
}

/// What a lane has of a place, and of a ray that comes to it.
void LoomlightMeetings::fill(VoxelPlaceLanes& lanes, size_t lane, const ClothVolume::PlaceInVoxel& place,
                             const Meeting& meeting) {
  lanes.wanted[lane] = 1;
  put(lanes.direction, lane, meeting.direction);
  put(lanes.voxel, lane, place.voxel);
  put(lanes.inVoxel, lane, place.inVoxel);
  if (const LocalDrape& drape = meeting.found->drape; !drape.isometric) {
    for (int column = 0; column < 3; ++column) put(lanes.frame[column], lane, drape.frame[column]);
    lanes.densityScale[lane] = drape.densityScale;
  }
  walker_.cells().fill(place.cell, lanes.cell, lane);
}

/// Where the axis of the fibre is; in the found voxel this only says whose boxes it is in.
ClothVolume::PlaceInVoxel LoomlightMeetings::placeOfAxis(const Meeting& meeting, size_t lane) const {
  const FoundFibres& found = *meeting.found;
  const auto look = static_cast<int>(takenLook_[lane]);
  if (look >= 0) return lookPlaces_[static_cast<size_t>(look)];
  if (look == kAmongAll) return {found.cell, found.voxel, 0.5f * (common_[lane].lower + common_[lane].upper)};
  const glm::vec3 ahead = medium_.toClothOf(found.tet) * (found.ahead_mm * meeting.direction);
  return {found.cell, found.voxel, (found.inCell_mm + ahead) / cloth_.volume->grid().size_mm - glm::vec3(found.voxel)};
}

/// Names the component of each meeting.
void LoomlightMeetings::chooseFibres(std::span<const Meeting> meetings) {
  choices_->wanted.fill(0);
  bool anyWanted = false;
  for (size_t lane = 0; lane < meetings.size(); ++lane) {
    const FoundFibres& found = *meetings[lane].found;
    Met& met = met_[lane];
    met = {found.cell, found.component, found.slot};
    if (const auto look = static_cast<int>(takenLook_[lane]); look >= 0) {
      const FoundLanes& there = looks_->found;
      const auto i = static_cast<size_t>(look);
      met = {lookPlaces_[i].cell, there.component[i], there.slot[i]};
    }
    if (met.component != FoundLanes::kSeveral) continue;
    wantChoice(meetings[lane], lane, placeOfAxis(meetings[lane], lane));
    anyWanted = true;
  }
  if (!anyWanted) return;
  chooseComponents(walker_.field(), *choices_);
  for (size_t lane = 0; lane < meetings.size(); ++lane) {
    if (choices_->wanted[lane] == 0) continue;
    met_[lane].component = choices_->component[lane];
    met_[lane].slot = choices_->slot[lane];
  }
}

/// What the path knows counts in the voxel that the walk has found, as it did in the walk.
void LoomlightMeetings::wantChoice(const Meeting& meeting, size_t lane, const ClothVolume::PlaceInVoxel& place) {
  const FoundFibres& found = *meeting.found;
  ChoiceLanes& choices = *choices_;
  fill(choices, lane, place, meeting);
  choices.u[lane] = meeting.random->uniform();
  if (!medium_.ingredients().hotSpot) return;
  const bool isFound = place.cell == found.cell && place.voxel == found.voxel;
  const KnownFibres known = isFound ? meeting.memory->known : KnownFibres();
  const glm::vec3 light = lightOf(meeting);
  const FibreInCloth before(known.before, light, *cloth_.shell, found.tet);
  putPastSegments(choices.known, lane, known, light);
  putBefore(choices.known.before, lane, known.before, before);
  put(choices.known.before.axis_mm, lane, found.inCell_mm + before.toAxis_mm);
  choices.middle_mm[lane] = found.toMiddle_mm;
}

/// Takes the component that a meeting is with.
void LoomlightMeetings::take(const Meeting& meeting, size_t lane, Fibres& fibres) {
  const Met& met = met_[lane];
  const ClothVolume::CellBricks::Brick& brick =
      walker_.cells().bricksIn(met.cell).bricks[static_cast<size_t>(met.slot)];
  Collision& c = meeting.met->emplace();
  c.optics = cloth_.yarns[static_cast<size_t>(brick.system)][static_cast<size_t>(brick.yarn)];
  c.yarnId = {brick.system, brick.index};
  c.yarn = brick.yarn;
  c.end = met.cell.x;
  c.pick = met.cell.y;
  fibres.put(lane, inWorld(cloth_.volume->components()[met.component].decode(), meeting.found->drape),
             c.optics.fibreRadius_mm);
}

/// What becomes of a meeting with a fibre of that tangent; `inwards`: to its axis, from the light.
void LoomlightMeetings::tell(const Meeting& meeting, size_t lane, const Vectors& tangent, float offset,
                             const Vectors& inwards) const {
  const FoundFibres& found = *meeting.found;
  const auto vectorOf = [lane](const Vectors& v) { return glm::vec3(v.x[lane], v.y[lane], v.z[lane]); };
  Collision& c = **meeting.met;
  c.place = {lightOf(meeting), found.tet};
  c.distance_mm = found.t_mm;
  c.incoming = meeting.direction;
  c.tangent = vectorOf(tangent);
  c.offset = offset;
  c.normal = found.drape.normal();
  c.axis = c.place.world + vectorOf(inwards);
  c.radius_mm = c.optics.fibreRadius_mm;
  c.material = drawMaterial(c.optics, *meeting.random);
  LoomlightMedium::HowMet& how = meeting.memory->howMet;
  how.amongAll = amongAll_[lane] != 0;
  how.points[0] = vectorOf(points_[0]);
  how.points[1] = vectorOf(points_[1]);
  const glm::vec3 size = cloth_.volume->grid().size_mm, voxel(found.voxel);
  how.lower_mm = (voxel + common_[lane].lower) * size - found.inCell_mm;
  how.upper_mm = (voxel + common_[lane].upper) * size - found.inCell_mm;
  how.ahead_mm = found.ahead_mm;
}

}  // namespace loomlight
