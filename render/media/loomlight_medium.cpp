#include "render/media/loomlight_medium.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "render/media/across_fibre.h"
#include "render/media/antithetic_points.h"
#include "render/media/fibre_exit.h"
#include "render/optics/fibre_frame.h"

// How it works. The header says what the law is. LaneWalker finds the voxel in which a ray meets fibres, and
// LoomlightMeetings draws which of them; here is what a path knows of them afterwards: the fibre before, met as the
// cylinder that it is, and where else across a fibre the ray may as well have met it.
namespace loomlight {
namespace {

Vec3Of<float> numbersOf(glm::vec3 v) {
  return {v.x, v.y, v.z};
}

bool isWithin(glm::vec3 place, glm::vec3 lower, glm::vec3 upper) {
  return place.x >= lower.x && place.y >= lower.y && place.z >= lower.z && place.x < upper.x && place.y < upper.y &&
         place.z < upper.z;
}

}  // namespace

LoomlightMedium::LoomlightMedium(std::shared_ptr<const TraceData> cloth, Ingredients ingredients)
    : cloth_(std::move(cloth)), ingredients_(ingredients) {
  assert((ingredients.boxes && ingredients.law == EventLaw::projected) ||
         !(ingredients.finiteRadius || ingredients.packing || ingredients.hotSpot));
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

Collision LoomlightMedium::meetBefore(const ScenePoint& place, glm::vec3 direction, float distance_mm,
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
  c.material = fibre.material;
  memory.howMet.amongAll = false;
  return c;
}

void LoomlightMedium::remember(const Collision& met, Memory& memory) const {
  if (!ingredients_.hotSpot) return;
  KnownFibres& known = memory.known;
  known.before = known.leaving;
  known.leaving = {met.axis, met.tangent, met.radius_mm, met.yarnId, met.yarn, met.end, met.pick, met.material};
  known.pastSegments = {RaySegment{met.place.world, met.incoming, met.distance_mm}, known.pastSegments[0]};
}

/// What a meeting is with hangs on which components are where the axis lies, and on nothing else of the two antithetic
/// points. So where both lay where all components of one voxel are, all other pairs of points that do belong to the
/// same component and tangent.
size_t LoomlightMedium::offsetsAcross(const Collision& met, const Memory& memory, std::span<float> offsets,
                                      Random& random) const {
  offsets[0] = met.offset;
  const HowMet& meeting = memory.howMet;
  if (!meeting.amongAll) return 1;
  if (!ingredients_.finiteRadius) return evenOffsets(met.offset, offsets);
  const OffsetAcross<float> offset(numbersOf(met.incoming), numbersOf(met.tangent));
  RandomLanes<float> numbers(random);
  const FibreFrame frame(met.incoming);
  const glm::mat3 toCloth = toClothOf(met.place.tet);
  const auto isAmongAll = [&](const Vec3Of<float>& w) {
    const glm::vec3 shift = radius_mm_ * (w.x * frame.y + w.y * frame.z) + 2 * meeting.ahead_mm * w.z * met.incoming;
    return isWithin(toCloth * shift, meeting.lower_mm, meeting.upper_mm);
  };
  size_t count = 1;
  offsets[count++] = offset(numbersOf(meeting.points[1]));
  for (size_t tried = 2; tried + 1 < offsets.size(); tried += 2) {
    const AntitheticPoints<float> w(numbers);
    if (!isAmongAll(w.first) || !isAmongAll(w.second)) continue;
    offsets[count++] = offset(w.first);
    offsets[count++] = offset(w.second);
  }
  return count;
}

glm::vec3 LoomlightMedium::exit(const Collision& met, glm::vec3 wi, float length_radii) const {
  return ingredients_.packing && met.optics.packed ? fibreExit(*cloth_, met, wi, length_radii) : met.place.world;
}

}  // namespace loomlight
