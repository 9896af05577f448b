#include "render/media/lane_walker.h"

#include <algorithm>

#include "render/media/known_lanes.h"

// How it works. Each lane of the kernel (render/walk) holds one ray, and the kernel returns as soon as any of them
// needs more than voxels. Here such a ray is served: at the end of a cell it gets the next one with the bricks that
// reach into it, at the end of a tetrahedron of the shell the next segment with its frame, and when it has met a
// fibre or left, what it found is told and the lane takes the next ray of the batch. Lanes without a ray stay masked
// until the batch is over.

namespace loomlight {
namespace {

static_assert(CellLanes::kSlots == VoxelContent::kMaxSpans, "a lane has a place for every brick of a cell");

}  // namespace

void CellCache::find(glm::ivec3 cell, Known& known) const {
  known.bricks = cloth_.volume->bricksIn(cell);
  for (int i = 0; i < known.bricks.count; ++i) {
    const ClothVolume::CellBricks::Brick& brick = known.bricks.bricks[i];
    const YarnOptics& optics = cloth_.yarns[static_cast<int>(brick.system)][brick.yarn];
    known.yarns[i] = {numberOf({brick.system, brick.index}), optics.fibreRadius_mm, optics.packed ? 1.0f : 0.0f,
                      optics.separation};
  }
}

void CellCache::fill(glm::ivec3 cell, CellLanes& lanes, size_t lane) {
  const Known& known = at(cell);
  lanes.count[lane] = known.bricks.count;
  for (int i = 0; i < known.bricks.count; ++i) {
    const ClothVolume::CellBricks::Brick& brick = known.bricks.bricks[i];
    CellLanes::Slot& slot = lanes.slots[i];
    put(slot.shift, lane, brick.shift);
    put(slot.size, lane, brick.box.size);
    slot.firstBlock[lane] = static_cast<int32_t>(brick.firstBlock);
    slot.yarn[lane] = known.yarns[i].number;
    slot.radius_mm[lane] = known.yarns[i].radius_mm;
    slot.packed[lane] = known.yarns[i].packed;
    slot.separation[lane] = known.yarns[i].separation;
  }
}

LaneWalker::LaneWalker(const TraceData& cloth, const WalkRules& rules)
    : cloth_(cloth), field_{rules}, lanes_(std::make_unique<WalkLanes>()), cells_(cloth) {
  const ClothVolume& volume = *cloth.volume;
  field_.blocks = volume.blocks();
  field_.components = volume.components();
  for (int axis = 0; axis < 3; ++axis) {
    field_.size_mm[axis] = volume.grid().size_mm[axis];
    field_.perCell[axis] = volume.grid().cell[axis];
  }
  field_.flat = cloth.shell->isFlat();
  *lanes_ = {};
  lanes_->stop.fill(static_cast<int32_t>(WalkStop::leftSegment));
}

uint64_t LaneWalker::walk(std::span<const DepthRay> rays, DepthRayEnds& ends) {
  next_ = 0;
  uint64_t steps = 0;
  size_t busy = 0;
  for (size_t lane = 0; lane < kWalkLanes; ++lane) busy += take(lane, rays, ends) ? 1 : 0;
  while (busy > 0) {
    loomlight::walk(field_, *lanes_);
    for (size_t lane = 0; lane < kWalkLanes; ++lane) {
      const auto stop = static_cast<WalkStop>(lanes_->stop[lane]);
      Ray& own = rays_[lane];
      if (stop == WalkStop::none || !own.march) continue;
      const DepthRay& ray = rays[own.number];
      bool goesOn = false;
      if (stop == WalkStop::met)
        tellFound(lane, ends);
      else
        goesOn = (stop == WalkStop::leftCell && leaveCell(lane)) || enterSegment(lane, ray);
      if (goesOn) continue;
      if (stop != WalkStop::met) ends.left(own.number, lanes_->depth[lane], own.tet);
      steps += static_cast<uint64_t>(lanes_->steps[lane]);
      if (!take(lane, rays, ends)) --busy;
    }
  }
  return steps;
}

/// Gives the lane the next ray that comes into the cloth; false where there is none.
bool LaneWalker::take(size_t lane, std::span<const DepthRay> rays, DepthRayEnds& ends) {
  Ray& own = rays_[lane];
  for (; next_ < rays.size(); ++next_) {
    const DepthRay& ray = rays[next_];
    own.number = next_;
    own.tet = ray.from.tet;
    own.shell.emplace(cloth_, ray.from, ray.direction, ray.tMax_mm);
    put(lanes_->direction, lane, ray.direction);
    lanes_->depth[lane] = ray.depth;
    lanes_->steps[lane] = 0;
    own.pastSegmentsTold = false;
    if (enterSegment(lane, ray)) {
      ++next_;
      return true;
    }
    ends.left(own.number, ray.depth, own.tet);
  }
  own.march.reset();
  lanes_->stop[lane] = static_cast<int32_t>(WalkStop::leftSegment);
  return false;
}

/// Goes to the ray's next segment beyond its clear way in which there is any of the piece; false where there is none.
bool LaneWalker::enterSegment(size_t lane, const DepthRay& ray) {
  Ray& own = rays_[lane];
  WalkLanes& l = *lanes_;
  while (own.shell->next()) {
    const ShellSegment& s = own.shell->segment();
    own.tet = s.tet;
    const float clear = ray.clear_mm - s.passed, tEnter = std::max(s.tEnter, clear);
    if (clear > s.tLeave) continue;
    own.march.emplace(*cloth_.volume, s.clothOrigin, s.clothDirection, tEnter, s.tLeave + field_.farthest_mm);
    if (!own.march->inPiece()) continue;
    l.stop[lane] = static_cast<int32_t>(WalkStop::none);
    l.t[lane] = own.march->enter();
    l.tEnd[lane] = own.march->leave();
    l.lightStart[lane] = tEnter;
    l.lightEnd[lane] = s.tLeave;
    l.lastEnd[lane] = -1;
    l.lastFilled[lane] = 0;
    put(l.inverse, lane, own.march->inverse());
    put(l.upwards, lane, own.march->upwards());
    put(l.voxel, lane, own.march->voxel());
    if (!field_.flat) {
      for (int column = 0; column < 3; ++column) put(l.frame[column], lane, s.drape.frame[column]);
      l.densityScale[lane] = s.drape.densityScale;
    }
    if (field_.hotSpot) {
      if (!own.pastSegmentsTold) putPastSegments(l.known, lane, *ray.known, s.origin);
      own.pastSegmentsTold = true;
      const KnownFibre& before = ray.known->before;
      l.known.before.radius_mm[lane] = before.radius_mm;
      if (before.radius_mm > 0) {
        const FibreInCloth inCloth(before, s.origin, *cloth_.shell, s.tet);
        own.toBefore_mm = inCloth.toAxis_mm;
        putBefore(l.known.before, lane, before, inCloth);
      }
    }
    enterCell(lane);
    return true;
  }
  own.march.reset();
  return false;
}

/// Fills in what is counted from the corner of the cell, and the bricks that reach into it.
void LaneWalker::enterCell(size_t lane) {
  Ray& own = rays_[lane];
  WalkLanes& l = *lanes_;
  put(l.start_mm, lane, own.march->start_mm());
  if (field_.hotSpot && l.known.before.radius_mm[lane] > 0)
    put(l.known.before.axis_mm, lane, own.march->start_mm() + own.toBefore_mm);
  if (own.march->cell() == own.slotsOf) return;
  own.slotsOf = own.march->cell();
  cells_.fill(own.slotsOf, l.cell, lane);
}

/// Goes to the cell that the ray's voxel is in; false where that is beyond the piece.
bool LaneWalker::leaveCell(size_t lane) {
  WalkLanes& l = *lanes_;
  for (int axis = 0; axis < 3; ++axis) {
    int32_t& voxel = l.voxel[axis][lane];
    if (voxel >= 0 && voxel < field_.perCell[axis]) continue;
    if (!rays_[lane].march->leaveCell(axis)) return false;
    voxel = voxel < 0 ? field_.perCell[axis] - 1 : 0;
  }
  l.stop[lane] = static_cast<int32_t>(WalkStop::none);
  enterCell(lane);
  return true;
}

void LaneWalker::tellFound(size_t lane, DepthRayEnds& ends) {
  const Ray& own = rays_[lane];
  const WalkLanes& l = *lanes_;
  const ShellSegment& s = own.shell->segment();
  FoundFibres& found = ends.found(own.number);
  found.ray = own.number;
  found.t_mm = s.passed + l.tMet[lane];
  found.tet = s.tet;
  found.drape = s.drape;
  found.cell = own.march->cell();
  found.ahead_mm = l.ahead[lane];
  found.toMiddle_mm = l.middle[lane] - l.tMet[lane];
  found.whole = l.found.whole[lane];
  found.component = l.found.component[lane];
  found.slot = l.found.slot[lane];
  for (int axis = 0; axis < 3; ++axis) {
    found.voxel[axis] = l.voxel[axis][lane];
    found.inCell_mm[axis] = l.start_mm[axis][lane] + l.tMet[lane] * s.clothDirection[axis];
  }
}

}  // namespace loomlight
