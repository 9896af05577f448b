// The voxels that several rays are in, side by side: which bricks hold anything there, and their components one after
// the other. Compiled once for each instruction set, as lanes-inl.h is.
#if defined(LOOMLIGHT_VOXEL_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LOOMLIGHT_VOXEL_LANES_INL_H_
#undef LOOMLIGHT_VOXEL_LANES_INL_H_
#else
#define LOOMLIGHT_VOXEL_LANES_INL_H_
#endif

#include "render/walk/fibre_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace loomlight::HWY_NAMESPACE {

/// As many voxels as a register holds, one of each ray.
class VoxelLanes {
 public:
  /// Of each ray, the brick whose fibres are looked at.
  struct Taken {
    Whole byte;          ///< of the block that the voxel is in
    Whole occupiedWord;  ///< BrickBlock::occupied, the half with the voxel's bit
    Whole slot, yarn;
    Real radius, packed, separation;
  };

  HWY_INLINE VoxelLanes(const WalkField& field, const CellLanes& cell, size_t lane)
      : field_(field), cell_(cell), lane_(lane) {}

  /// Goes to these voxels, counted from the corners of the cells, of the rays of `wanted`; which of them hold anything.
  HWY_INLINE Mask open(const Whole (&voxel)[3], Mask wanted) {
    Mask occupied = Whole(0) == Whole(1);
    const Whole count = Whole::of(&cell_.count[lane_]);
    number_ = (voxel[0] & Whole(3)) | shiftedLeft<2>(voxel[1] & Whole(3)) | shiftedLeft<4>(voxel[2] & Whole(3));
    const Whole bit = bitNumber(number_ & Whole(31)), word = wordOf(number_);
    const Whole own[3] = {shiftedRightSigned<2>(voxel[0]), shiftedRightSigned<2>(voxel[1]),
                          shiftedRightSigned<2>(voxel[2])};
    for (slots_ = 0; slots_ < CellLanes::kSlots; ++slots_) {
      const Mask there = wanted & (Whole(slots_) < count);
      if (!any(there)) break;
      const CellLanes::Slot& brick = cell_.slots[slots_];
      Whole block[3], size[3];
      Mask inside = there;
      for (int axis = 0; axis < 3; ++axis) {
        block[axis] = own[axis] + Whole::of(&brick.shift[axis][lane_]);
        size[axis] = Whole::of(&brick.size[axis][lane_]);
        inside = inside & (Whole(-1) < block[axis]) & (block[axis] < size[axis]);
      }
      const Whole at = Whole::of(&brick.firstBlock[lane_]) + (block[2] * size[1] + block[1]) * size[0] + block[0];
      byte_[slots_] = choose(inside, at, Whole(0)) * Whole(static_cast<int32_t>(sizeof(BrickBlock)));
      occupiedWord_[slots_] = gatherBytes(field_.blocks, byte_[slots_] + word);
      holds_[slots_] = inside & ~((occupiedWord_[slots_] & bit) == Whole(0));
      occupied = occupied | holds_[slots_];
    }
    return occupied;
  }

  /// Calls visit(which rays, numbers of their components, Taken) until all components of the open voxels have been.
  /// Which of its bricks a ray has anything of differs from ray to ray, and most have of one alone: so each ray takes
  /// the first of its own, then those that have more the next.
  template <class Visit>
  HWY_INLINE void forEachComponent(Visit& visit) {
    const Whole bit = bitNumber(number_ & Whole(31)), below = bit - Whole(1), word = wordOf(number_);
    const Mask upper = Whole(31) < number_;
    Taken taken;
    for (Mask holds = takeBrick(taken); any(holds); holds = takeBrick(taken)) {
      const Whole second = gatherBytes(field_.blocks, taken.byte + word + Whole(8));
      Whole before = setBits(taken.occupiedWord & below) + setBits(second & below);
      if (any(holds & upper)) {
        const Whole low = gatherBytes(field_.blocks, taken.byte);
        const Whole secondLow = gatherBytes(field_.blocks, taken.byte + Whole(8));
        before = choose(upper, before + (setBits(low) + setBits(secondLow)), before);
      }
      const Whole component = gatherBytes(field_.blocks, taken.byte + Whole(16)) + before;
      visit(holds, component, taken);
      const Mask twice = holds & ~((second & bit) == Whole(0));
      if (any(twice)) visit(twice, component + Whole(1), taken);
    }
  }

 private:
  /// Byte of the half of a block's 64 bits in which that of a voxel is.
  HWY_INLINE static Whole wordOf(Whole number) { return shiftedRight<3>(number & Whole(32)); }

  /// The next brick of each ray with anything in the voxel; which rays have one.
  HWY_INLINE Mask takeBrick(Taken& taken) {
    Mask has = Whole(0) == Whole(1);
    taken.byte = taken.occupiedWord = taken.slot = taken.yarn = Whole(0);
    taken.radius = taken.packed = taken.separation = Real(0.0f);
    for (int slot = 0; slot < slots_; ++slot) {
      const Mask takes = holds_[slot] & ~has;
      const CellLanes::Slot& brick = cell_.slots[slot];
      taken.byte = choose(takes, byte_[slot], taken.byte);
      taken.occupiedWord = choose(takes, occupiedWord_[slot], taken.occupiedWord);
      taken.slot = choose(takes, Whole(slot), taken.slot);
      taken.yarn = choose(takes, Whole::of(&brick.yarn[lane_]), taken.yarn);
      taken.radius = choose(takes, Real::of(&brick.radius_mm[lane_]), taken.radius);
      taken.packed = choose(takes, Real::of(&brick.packed[lane_]), taken.packed);
      taken.separation = choose(takes, Real::of(&brick.separation[lane_]), taken.separation);
      has = has | takes;
      holds_[slot] = holds_[slot] & ~takes;
    }
    return has;
  }

  const WalkField& field_;
  const CellLanes& cell_;
  size_t lane_;    ///< the first of them
  Whole number_;   ///< of the voxel in its block
  int slots_ = 0;  ///< so many bricks reach into the cell of any ray
  Whole byte_[CellLanes::kSlots];
  Whole occupiedWord_[CellLanes::kSlots];
  Mask holds_[CellLanes::kSlots];
};

/// What the voxels of several rays come to, as their components are added one after the other.
struct Contents {
  Real whole;
  Whole component, slot;

  HWY_INLINE Contents() : whole(0.0f), component(FoundLanes::kNone), slot(0) {}

  /// Some rays' components, and their extinction there.
  HWY_INLINE void add(Mask holds, Whole number, Whole slotOf, Real extinction) {
    whole = whole + extinction;
    const Mask first = holds & (component == Whole(FoundLanes::kNone));
    component = choose(holds, choose(first, number, Whole(FoundLanes::kSeveral)), component);
    slot = choose(first, slotOf, slot);
  }
  HWY_INLINE void to(FoundLanes& lanes, size_t lane) const {
    whole.to(&lanes.whole[lane]);
    component.to(&lanes.component[lane]);
    slot.to(&lanes.slot[lane]);
  }
};

/// The fibres of some components, as they lie in the world; `Lanes` has `frame` and `densityScale` of each ray.
template <class Lanes>
HWY_INLINE FibreLanes fibresOf(const WalkField& field, const Lanes& lanes, size_t lane, Mask holds, Whole component) {
  const FibreLanes fibres = decode(field.components, choose(holds, component, Whole(0)));
  if (field.flat) return fibres;
  const Vector frame[3] = {vectorOf(lanes.frame[0], lane), vectorOf(lanes.frame[1], lane),
                           vectorOf(lanes.frame[2], lane)};
  return inWorld(fibres, frame, Real::of(&lanes.densityScale[lane]));
}

/// What rays in direction d meet of such fibres, 1/mm: sigma_i(d) = 2 r lambda_i I(angle(d, m_i), s_i) (Eqs. 6-9 of the
/// report).
HWY_INLINE Real extinctionOf(const WalkField& field, Mask holds, const FibreLanes& fibres, const Vector& direction,
                             Real radius) {
  const Real cosine = dot(direction, fibres.direction);
  const Real sineSquare = most(Real(0.0f), Real(1.0f) - cosine * cosine);
  return orZero(holds,
                Real(2.0f) * radius * fibres.lengthDensity * projectedLength(field.spreads, sineSquare, fibres.spread));
}

}  // namespace loomlight::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
