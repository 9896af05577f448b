// How it works. This is look() and chooseComponents() of walk_lanes.h: what a voxel holds at one place in it, summed up
// component by component, or one component of all, in a single pass. Of the components so far one is held with the
// chance that is due to it (Chao 1982, a reservoir of one); the next takes its place with its own share of the sum, and
// what decides that, stretched over [0, 1) again, decides the next.
//
// Compiled once for each instruction set, as walk_kernel.cpp is.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/walk/place_kernel.cpp"
#include <hwy/foreach_target.h>

#include "render/walk/known_lanes-inl.h"
#include "render/walk/walk_lanes.h"

HWY_BEFORE_NAMESPACE();
namespace loomlight::HWY_NAMESPACE {

using Taken = VoxelLanes::Taken;

/// As many places as a register holds.
class Places {
 public:
  HWY_INLINE Places(const WalkField& field, const VoxelPlaceLanes& lanes, size_t lane)
      : field_(field),
        lanes_(lanes),
        lane_(lane),
        wanted_(Whole::of(&lanes.wanted[lane]) == Whole(1)),
        voxel_{Whole::of(&lanes.voxel[0][lane]), Whole::of(&lanes.voxel[1][lane]), Whole::of(&lanes.voxel[2][lane])} {}

  HWY_INLINE bool anyWanted() const { return any(wanted_); }
  HWY_INLINE Vector direction() const { return vectorOf(lanes_.direction, lane_); }
  const Whole (&voxel() const)[3] { return voxel_; }

  /// Calls visit(which places, numbers of their components, FibreLanes, Taken) for all that the voxels hold.
  template <class Visit>
  HWY_INLINE void forEachComponent(const Visit& visit) const {
    const auto decoded = [&](Mask holds, Whole component, const Taken& taken) HWY_ATTR {
      visit(holds, component, fibresOf(field_, lanes_, lane_, holds, component), taken);
    };
    VoxelLanes voxels(field_, lanes_.cell, lane_);
    voxels.open(voxel_, wanted_);
    voxels.forEachComponent(decoded);
  }
  /// How many times as dense such fibres are there as spread over the voxel; 0 where they are not.
  HWY_INLINE Real crowding(Mask holds, const FibreLanes& fibres) const {
    return BoxLanes(holds, fibres.box).crowdingAt(vectorOf(lanes_.inVoxel, lane_));
  }

 private:
  const WalkField& field_;
  const VoxelPlaceLanes& lanes_;
  size_t lane_;  ///< the first of them
  Mask wanted_;
  Whole voxel_[3];
};

void lookLanes(const WalkField& field, LookLanes& lanes) {
  for (size_t lane = 0; lane < kWalkLanes; lane += hn::Lanes(RealTag())) {
    const Places places(field, lanes, lane);
    if (!places.anyWanted()) continue;
    const Vector direction = places.direction();
    Contents found;
    const auto add = [&](Mask holds, Whole component, const FibreLanes& fibres, const Taken& taken) HWY_ATTR {
      const Real crowding = places.crowding(holds, fibres);
      const Mask there = holds & (Real(0.0f) < crowding);
      found.add(there, component, taken.slot, crowding * extinctionOf(field, there, fibres, direction, taken.radius));
    };
    places.forEachComponent(add);
    found.to(lanes.found, lane);
  }
}

/// Of each ray, the component that is held, of those so far.
class Choice {
 public:
  HWY_INLINE explicit Choice(Real u) : u_(u), sum_(0.0f), component_(FoundLanes::kNone), slot_(0) {}

  HWY_INLINE void add(Mask holds, Whole component, Whole slot, Real weightOfAny) {
    const Real weight = orZero(holds, weightOfAny);
    sum_ = sum_ + weight;
    const Real at = u_ * sum_;
    const Mask takes = holds & ((at < weight) | (component_ == Whole(FoundLanes::kNone)));
    const Real begins = choose(takes, Real(0.0f), weight), extent = choose(takes, weight, sum_ - weight);
    const Mask some = holds & (Real(0.0f) < extent);  // a ray without such a component keeps its number to the bit
    u_ = choose(some, (at - begins) / choose(some, extent, Real(1.0f)), u_);
    component_ = choose(takes, component, component_);
    slot_ = choose(takes, slot, slot_);
  }
  HWY_INLINE void to(ChoiceLanes& lanes, size_t lane) const {
    component_.to(&lanes.component[lane]);
    slot_.to(&lanes.slot[lane]);
  }

 private:
  Real u_, sum_;
  Whole component_, slot_;
};

/// What of a component counts when one is chosen.
HWY_INLINE Real weightOf(const WalkField& field, const Places& places, const KnownInVoxels& known, Mask holds,
                         const FibreLanes& fibres, const Taken& taken) {
  // More than nothing, because one is chosen even where flights before have seen that none of them is there.
  const Real leastShare(1e-6f);
  if (field.byDensity) return fibres.lengthDensity;
  Real weight = extinctionOf(field, holds, fibres, places.direction(), taken.radius);
  if (field.boxes) weight = weight * places.crowding(holds, fibres);
  if (field.hotSpot) weight = weight * most(leastShare, known.shareLeft(holds, fibres, taken));
  return weight;
}

void chooseLanes(const WalkField& field, ChoiceLanes& lanes) {
  const Vector size{Real(field.size_mm[0]), Real(field.size_mm[1]), Real(field.size_mm[2])};
  for (size_t lane = 0; lane < kWalkLanes; lane += hn::Lanes(RealTag())) {
    const Places places(field, lanes, lane);
    if (!places.anyWanted()) continue;
    const Vector onRay = places.direction() * Real::of(&lanes.middle_mm[lane]);
    const KnownInVoxels known{lanes.known, lane, onRay, places.voxel(), size};
    Choice choice(Real::of(&lanes.u[lane]));
    const auto add = [&](Mask holds, Whole component, const FibreLanes& fibres, const Taken& taken) HWY_ATTR {
      const Real weight = weightOf(field, places, known, holds, fibres, taken);
      choice.add(holds, component, taken.slot, weight);
    };
    places.forEachComponent(add);
    choice.to(lanes, lane);
  }
}

}  // namespace loomlight::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace loomlight {

HWY_EXPORT(lookLanes);
HWY_EXPORT(chooseLanes);

void look(const WalkField& field, LookLanes& lanes) {
  HWY_DYNAMIC_DISPATCH(lookLanes)(field, lanes);
}

void chooseComponents(const WalkField& field, ChoiceLanes& lanes) {
  HWY_DYNAMIC_DISPATCH(chooseLanes)(field, lanes);
}

}  // namespace loomlight
#endif
