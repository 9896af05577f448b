// How it works. This is the walk of walk_lanes.h. Each ray goes from voxel to voxel: where it crosses the next face is
// computed anew in each voxel, from where it starts, so that no error adds up (Amanatides and Woo 1987). In a voxel
// with content the axes of the fibres lie ahead of the light by half their mean chord, so what the light goes along
// there is shifted, and cut by the ends of the segment (LoomlightMedium says why). Each component of the voxel has a
// stretch of the way, where it goes through the box that the component's fibres lie in; there light uses up optical
// depth, until none is left.
//
// This file is compiled once for each instruction set, and which one runs is found out as the program runs. All lanes
// compute all branches that any of them takes; what a lane does not want is masked out.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/walk/walk_kernel.cpp"
#include <hwy/foreach_target.h>

#include "render/walk/known_lanes-inl.h"
#include "render/walk/stretch_lanes-inl.h"
#include "render/walk/walk_lanes.h"
#include "render/walk/walk_target.h"

HWY_BEFORE_NAMESPACE();
namespace loomlight::HWY_NAMESPACE {

HWY_INLINE Whole code(WalkStop stop) {
  return Whole(static_cast<int32_t>(stop));
}

/// As many rays as a register holds, on their way.
class Step {
 public:
  HWY_INLINE Step(const WalkField& field, WalkLanes& lanes, size_t lane)
      : field_(field),
        lanes_(lanes),
        lane_(lane),
        goes_(Whole::of(&lanes.stop[lane]) == code(WalkStop::none)),
        size_{Real(field.size_mm[0]), Real(field.size_mm[1]), Real(field.size_mm[2])},
        voxel_{Whole::of(&lanes.voxel[0][lane]), Whole::of(&lanes.voxel[1][lane]), Whole::of(&lanes.voxel[2][lane])},
        enter_(Real::of(&lanes.t[lane])),
        voxelLanes_(field, lanes.cell, lane) {}

  HWY_INLINE bool anyGoes() const { return any(goes_); }

  /// Beyond the next voxel with content, or as far as a ray stops; whether any does. Most voxels are empty, and cost
  /// much less: so rays cross a few of them before those that wait at one with content are served together.
  HWY_INLINE bool go() {
    Whole stop = Whole::of(&lanes_.stop[lane_]);
    for (int empty = 0;; ++empty) {
      findFace();
      occupied_ = voxelLanes_.open(voxel_, goes_ & (enter_ < leave_));
      const Mask passes = goes_ & ~occupied_;
      if (empty == kMostEmpty || !any(passes)) break;
      leaveVoxel(passes, stop);
    }
    sumFibres();
    useUpDepth();
    stop = choose(met_, code(WalkStop::met), stop);
    leaveVoxel(goes_ & ~met_, stop);
    for (int axis = 0; axis < 3; ++axis) voxel_[axis].to(&lanes_.voxel[axis][lane_]);
    enter_.to(&lanes_.t[lane_]);
    const Mask went = Whole::of(&lanes_.stop[lane_]) == code(WalkStop::none);
    stop.to(&lanes_.stop[lane_]);
    return any(went & ~(stop == code(WalkStop::none)));
  }

 private:
  static constexpr int kMostEmpty = 2;  // voxels that are crossed while others wait

  HWY_INLINE void findFace() {
    Real face[3];
    const Real sizes[3] = {size_.x, size_.y, size_.z};
    for (int axis = 0; axis < 3; ++axis) {
      const Whole ahead = voxel_[axis] + Whole::of(&lanes_.upwards[axis][lane_]);
      face[axis] = (toReal(ahead) * sizes[axis] - Real::of(&lanes_.start_mm[axis][lane_])) *
                   Real::of(&lanes_.inverse[axis][lane_]);
    }
    const Mask x = (face[0] <= face[1]) & (face[0] <= face[2]), y = (face[1] <= face[2]) & ~x;
    through_[0] = x;
    through_[1] = y;
    through_[2] = ~(x | y);
    faceAt_ = choose(x, face[0], choose(y, face[1], face[2]));
    leave_ = least(faceAt_, Real::of(&lanes_.tEnd[lane_]));
  }

  /// Over all components of the voxel.
  HWY_INLINE void sumFibres() {
    solid_ = Real(0.0f);
    found_ = Contents();
    stretches_.clear(enter_, leave_);
    middle_ = Real(0.5f) * (enter_ + leave_);
    const auto add = [this](Mask holds, Whole component, const VoxelLanes::Taken& taken)
                         HWY_ATTR { addFibres(holds, component, taken); };
    voxelLanes_.forEachComponent(add);
  }

  HWY_INLINE void addFibres(Mask holds, Whole component, const VoxelLanes::Taken& taken) {
    const FibreLanes fibres = fibresOf(field_, lanes_, lane_, holds, component);
    Real extinction = extinctionOf(field_, holds, fibres, vectorOf(lanes_.direction, lane_), taken.radius);
    const Real section = Real(static_cast<float>(kPi)) * taken.radius * taken.radius;
    Real solid = orZero(holds, section * fibres.lengthDensity);
    Real from = choose(holds, enter_, leave_), to = choose(holds, leave_, enter_);
    const BoxLanes box(field_.boxes ? holds : holds & ~holds, fibres.box);
    if (any(box.boxed)) {
      clip(box, from, to);
      extinction = extinction * box.crowding();
      solid = solid * box.crowding();
    }
    found_.add(holds, component, taken.slot, extinction);
    solid_ = solid_ + solid;
    const Real counts = field_.hotSpot ? orZero(holds, extinction * shareLeft(holds, fibres, taken)) : extinction;
    stretches_.add(from, to, counts, solid * taken.separation, box.boxed);
  }

  /// Of some rays, their way through the voxel to what of it goes through a box.
  HWY_INLINE void clip(const BoxLanes& box, Real& from, Real& to) const {
    Real enter = from, leave = to;
    const Real sizes[3] = {size_.x, size_.y, size_.z};
    for (int axis = 0; axis < 3; ++axis) {
      const Real voxel = toReal(voxel_[axis]), start = Real::of(&lanes_.start_mm[axis][lane_]),
                 inverse = Real::of(&lanes_.inverse[axis][lane_]);
      const Real a = ((voxel + box.lower[axis]) * sizes[axis] - start) * inverse;
      const Real b = ((voxel + box.upper[axis]) * sizes[axis] - start) * inverse;
      enter = most(enter, least(a, b));
      leave = least(leave, most(a, b));
    }
    const Mask passes = enter < leave;  // a ray that misses the box has no stretch
    from = choose(box.boxed, choose(passes, enter, leave_), from);
    to = choose(box.boxed, choose(passes, leave, enter_), to);
  }

  HWY_INLINE Real shareLeft(Mask holds, const FibreLanes& fibres, const VoxelLanes::Taken& taken) const {
    const Vector onRay = vectorOf(lanes_.direction, lane_) * middle_;
    return KnownInVoxels{lanes_.known, lane_, onRay, voxel_, size_}.shareLeft(holds, fibres, taken);
  }

  /// Where the light goes along these fibres, and whether it meets one of them.
  HWY_INLINE void useUpDepth() {
    met_ = goes_ & ~goes_;
    if (!any(occupied_)) return;
    LightLanes light;
    light.start = Real::of(&lanes_.lightStart[lane_]);
    light.end = Real::of(&lanes_.lightEnd[lane_]);
    light.lastEnd = Real::of(&lanes_.lastEnd[lane_]);
    light.filledBefore = Real::of(&lanes_.lastFilled[lane_]);
    const Mask some = occupied_ & (Real(0.0f) < found_.whole);
    light.ahead = least(Real(0.5f) * solid_ / choose(some, found_.whole, Real(1.0f)), Real(field_.farthest_mm));
    const Real depth = stretches_.spend(light, field_.packing);

    const Real last = stretches_.last();
    const Mask passed = occupied_ & (stretches_.first() < last);
    choose(passed, last, light.lastEnd).to(&lanes_.lastEnd[lane_]);
    const Real filled = field_.packing ? stretches_.filledAtLast() : Real(0.0f);
    choose(passed, filled, light.filledBefore).to(&lanes_.lastFilled[lane_]);

    const Mask along = some & (Real(0.0f) < depth);
    const Real left = Real::of(&lanes_.depth[lane_]);
    met_ = along & (left < depth);
    choose(along & ~met_, left - depth, left).to(&lanes_.depth[lane_]);
    choose(along, Whole::of(&lanes_.steps[lane_]) + Whole(1), Whole::of(&lanes_.steps[lane_])).to(&lanes_.steps[lane_]);
    if (!any(met_)) return;
    const Mask several = met_ & (found_.component == Whole(FoundLanes::kSeveral));
    (stretches_.placeOf(left, several) - light.ahead).to(&lanes_.tMet[lane_]);
    light.ahead.to(&lanes_.ahead[lane_]);
    found_.to(lanes_.found, lane_);
    middle_.to(&lanes_.middle[lane_]);
  }

  /// These rays go to the next voxel, or stop.
  HWY_INLINE void leaveVoxel(Mask moves, Whole& stop) {
    enter_ = choose(moves, most(enter_, leave_), enter_);
    const Mask over = moves & ~(faceAt_ < Real::of(&lanes_.tEnd[lane_]));
    Mask out = goes_ & ~goes_;
    for (int axis = 0; axis < 3; ++axis) {
      const Mask steps = moves & through_[axis] & ~over;
      const Whole next = voxel_[axis] + shiftedLeft<1>(Whole::of(&lanes_.upwards[axis][lane_])) - Whole(1);
      out = out | (steps & ((next < Whole(0)) | ~(next < Whole(field_.perCell[axis]))));
      voxel_[axis] = choose(steps, next, voxel_[axis]);
    }
    stop = choose(over, code(WalkStop::leftSegment), choose(out, code(WalkStop::leftCell), stop));
    goes_ = goes_ & ~(over | out);
  }

  const WalkField& field_;
  WalkLanes& lanes_;
  size_t lane_;  ///< the first of them
  Mask goes_;
  Vector size_;
  Whole voxel_[3];
  Real enter_;
  VoxelLanes voxelLanes_;
  // As it finds out:
  Mask through_[3];  ///< the face that it leaves by
  Real faceAt_, leave_, middle_;
  Real solid_;              ///< how much of the boxes is fibre, over all components
  StretchLanes stretches_;  ///< one of each component
  Contents found_;
  Mask occupied_, met_;
};

void walkLanes(const WalkField& field, WalkLanes& lanes) {
  bool stopped = false, going = true;
  while (!stopped && going) {
    going = false;
    for (size_t lane = 0; lane < kWalkLanes; lane += hn::Lanes(RealTag())) {
      Step step(field, lanes, lane);
      if (!step.anyGoes()) continue;
      going = true;
      stopped |= step.go();
    }
  }
}

const char* targetName() {
  return hwy::TargetName(HWY_TARGET);
}

}  // namespace loomlight::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace loomlight {

HWY_EXPORT(walkLanes);
HWY_EXPORT(targetName);

void walk(const WalkField& field, WalkLanes& lanes) {
  HWY_DYNAMIC_DISPATCH(walkLanes)(field, lanes);
}

const char* walkTarget() {
  return HWY_DYNAMIC_DISPATCH(targetName)();
}

}  // namespace loomlight
#endif
