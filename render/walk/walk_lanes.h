#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/volume/pool/brick.h"
#include "core/volume/pool/tangent_spread.h"

namespace loomlight {

/// So many rays walk side by side, whatever the machine's registers hold: it goes through them in as many steps as it
/// takes, and the results are the same to the bit.
inline constexpr size_t kWalkLanes = 16;

/// One number of each ray.
using LaneFloats = std::array<float, kWalkLanes>;
using LaneInts = std::array<int32_t, kWalkLanes>;

/// TangentSpread's table in the form that lanes read fastest: two neighbours along a row, of 16 bits each, at once.
/// Within 1e-5 of it.
struct SpreadPairs {
  static constexpr float kUnit = 1.0f / 40000;  ///< what a 1 stands for
  static const SpreadPairs& table();
  int32_t ratios, spreads;
  std::vector<int32_t> pairs;  ///< [spreads][ratios]; the low half is the entry's own

 private:
  explicit SpreadPairs(const TangentSpread& table);
};

/// The rules of a walk, as LoomlightMedium has them.
struct WalkRules {
  float farthest_mm = 0;   ///< no axis is looked for farther ahead of the light
  bool packing = true;     ///< light keeps to the gaps between fibres of packed yarns
  bool hotSpot = true;     ///< fibres near the flights before are known to be absent
  bool boxes = true;       ///< fibres are in the boxes of their voxels alone; else spread over the voxels
  bool byDensity = false;  ///< which component is met hangs on density alone (EventLaw::report)
};

/// What all rays of a walk have in common: its rules, and the volume.
struct WalkField : WalkRules {
  const BrickBlock* blocks = nullptr;
  const Component* components = nullptr;
  const SpreadPairs& spreads = SpreadPairs::table();
  float size_mm[3] = {1, 1, 1};  ///< of a voxel
  int32_t perCell[3] = {1, 1, 1};
  bool flat = true;  ///< cloth space is the world, but for a translation
};

/// Why a ray stopped.
enum class WalkStop : int32_t {
  none,         ///< it goes on; lanes without a ray have any other
  met,          ///< its optical depth is used up: tMet, ahead, middle and found say where and what
  leftCell,     ///< it stands at a voxel beyond its cell
  leftSegment,  ///< it came to the end of its segment
};

/// The bricks that reach into the cell of each ray.
struct CellLanes {
  static constexpr int kSlots = 6;
  LaneInts count;
  struct Slot {
    LaneInts shift[3];  ///< from blocks of the cell to those of the brick
    LaneInts size[3];   ///< of the brick, in blocks
    LaneInts firstBlock;
    LaneInts yarn;          ///< which end or pick: 2 index + system
    LaneFloats radius_mm;   ///< of its fibres
    LaneFloats packed;      ///< 1: YarnOptics::packed; else 0
    LaneFloats separation;  ///< YarnOptics::separation
  } slots[kSlots];
};

/// Which fibres a voxel of each ray holds, or a place in it.
struct FoundLanes {
  LaneFloats whole;    ///< extinction of all, 1/mm; each component in its box, where WalkRules::boxes holds
  LaneInts component;  ///< the number of the component, if there is one alone; kNone or kSeveral if not
  LaneInts slot;       ///< whose brick that component is in
  static constexpr int32_t kNone = -1, kSeveral = -2;
};

/// What the path of each ray knows of the fibres around it (KnownFibre, RaySegment).
struct KnownLanes {
  struct PastSegment {
    LaneFloats offset_mm[3];  ///< from its end to the ray at t = 0, world
    LaneFloats direction[3];
    LaneFloats length_mm;  ///< 0: none
  } pastSegments[2];
  struct Before {
    LaneFloats axis_mm[3];  ///< cloth space, from the corner of the cell
    LaneFloats tangent[3];  ///< cloth space, unit
    LaneFloats radius_mm;   ///< 0: none
    LaneInts yarn;          ///< as CellLanes::Slot::yarn
  } before;
};

/// Up to kWalkLanes rays, each in a segment of the cloth in which cloth space is an affine image of the world (a
/// tetrahedron of the shell, or all of a flat piece), as columns of numbers. Distances t are in mm along the ray from
/// where it begins. Positions in cloth space are counted from the lower corner of the ray's cell, so that floats are as
/// exact on a wide cloth as on a small one.
struct alignas(64) WalkLanes {
  alignas(64) LaneInts stop;  ///< WalkStop

  // The ray:
  LaneFloats start_mm[3];           ///< at t = 0, in cloth space, from the corner of the cell
  LaneFloats inverse[3];            ///< 1 / its direction in cloth space; huge where it does not move
  LaneInts upwards[3];              ///< 1 where it moves to greater coordinates, else 0
  LaneInts voxel[3];                ///< that it is in, counted from the corner of the cell
  LaneFloats direction[3];          ///< unit, of the world
  LaneFloats t;                     ///< where the axes are that it has come to
  LaneFloats tEnd;                  ///< no axes are looked for beyond
  LaneFloats lightStart, lightEnd;  ///< where the light is in the segment
  LaneFloats depth;                 ///< optical depth that is left
  LaneFloats lastEnd;               ///< where the fibres of the voxel before ended
  LaneFloats lastFilled;            ///< how much of the space was fibre there, 0..1
  LaneInts steps;                   ///< voxels with content in which it has used up depth

  // The cloth there:
  LaneFloats frame[3][3];   ///< [column][row] of d world / d cloth
  LaneFloats densityScale;  ///< 1 / its determinant

  KnownLanes known;
  CellLanes cell;  ///< that it is in

  // Of a ray that has met a fibre:
  LaneFloats tMet;    ///< where the light is
  LaneFloats ahead;   ///< of the light, the axes: c, mm
  LaneFloats middle;  ///< of the ray in the voxel
  FoundLanes found;   ///< in the voxel
};

/// Lets all rays with WalkStop::none go on until at least one of them stops, or there are none. The walk is that of
/// LoomlightMedium. Cost: about one step of all lanes for each voxel that the longest of them crosses; a step reads one
/// block for each brick in reach, and where it holds anything the component and four numbers of the table I(alpha, s).
void walk(const WalkField& field, WalkLanes& lanes);

/// Places at which rays may meet fibres, each in a voxel.
struct alignas(64) VoxelPlaceLanes {
  alignas(64) LaneInts wanted;  ///< 1 where a ray has one; else 0
  LaneFloats direction[3];      ///< of the ray, unit, of the world
  LaneInts voxel[3];            ///< counted from the corner of the cell
  LaneFloats inVoxel[3];        ///< in widths of the voxel from the corner of that
  LaneFloats frame[3][3];       ///< as WalkLanes'
  LaneFloats densityScale;      ///< as WalkLanes'
  CellLanes cell;
};

/// Looks for fibres at places.
struct LookLanes : VoxelPlaceLanes {
  FoundLanes found;  ///< what is there, all of it: whatever the ray knows of fibres
};

/// Fills in what was found. Cost: about one step of walk().
void look(const WalkField& field, LookLanes& lanes);

/// Chooses the component that each ray meets, among those at its place.
struct ChoiceLanes : VoxelPlaceLanes {
  LaneFloats u;              ///< in [0, 1)
  KnownLanes known;          ///< with t = 0 at the light
  LaneFloats middle_mm;      ///< along the ray, from the light to the middle of its way through the voxel
  LaneInts component, slot;  ///< as FoundLanes'; kNone where the voxel is empty
};

/// In proportion to their extinction at the place (WalkRules::boxes), with hotSpot only as much of it as `known`
/// leaves; with byDensity to their density alone. Where nothing counts, it is one of them all the same. Cost: about one
/// step of walk().
void chooseComponents(const WalkField& field, ChoiceLanes& lanes);

}  // namespace loomlight
