#pragma once

#include <algorithm>
#include <optional>

#include "render/media/lane_walker.h"
#include "render/media/voxel_extinction.h"

namespace loomlight::test {

// The walk of LaneWalker for one ray alone, in plain numbers and doubles: what the lanes are held against.

/// The share of extinction that is left of fibres near earlier flights, and beside the fibre that the last flight came
/// from: that one is met for itself, so a voxel must not count it again.
class CorrelationState {
 public:
  CorrelationState(const KnownFibres& memory, const ShellSegment& s, const VoxelGrid& grid, glm::mat3 toCloth)
      : memory_(memory),
        grid_(grid),
        before_(s.clothOrigin + toCloth * (memory.before.axis - s.origin),
                glm::normalize(toCloth * memory.before.tangent), memory.before.radius_mm, grid_) {}

  float share(const FibreDistribution& fibres, float radius_mm, bool packed, YarnId yarnId, glm::vec3 point,
              glm::ivec3 voxel) const {
    float absent = 0;
    for (const RaySegment& past : memory_.pastSegments)
      if (past.length_mm > 0)
        absent = std::max(absent, knownAbsent(past, point, fibres.direction, fibres.spread, radius_mm));
    float before = 0;
    if (memory_.before.radius_mm > 0 && yarnId == memory_.before.yarnId && packed)
      before = std::min(1.0f, before_.lengthDensity(grid_.lower_mm(voxel)) / fibres.lengthDensity);
    return (1 - absent) * (1 - before);
  }

 private:
  const KnownFibres& memory_;
  const VoxelGrid& grid_;
  FibreInVoxels before_;
};

/// The share that a voxel's components have left, seen from its middle on the ray.
struct CorrelatedShare {
  const CorrelationState* unknown;  ///< null: all of it
  glm::vec3 middle;
  glm::ivec3 voxel;

  float operator()(const FibreDistribution& fibres, const YarnOptics& optics,
                   const VoxelContent::YarnSpan& span) const {
    if (!unknown) return 1;
    return unknown->share(fibres, optics.fibreRadius_mm, optics.packed, {span.system, span.index}, middle, voxel);
  }
};

/// A ray on its way through the stretches along which light can meet fibres whose axes lie in one voxel, in order.
class RayIntervals {
 public:
  RayIntervals(const TraceData& cloth, const LaneWalker::Rules& rules, const DepthRay& ray)
      : cloth_(cloth),
        rules_(rules),
        known_(*ray.known),
        direction_(ray.direction),
        shell_(cloth, ray.from, ray.direction, ray.tMax_mm) {}

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
    return {rules_.hotSpot ? &*unknown_ : nullptr, middle, content().voxel};
  }

 private:
  bool enterSegment() {
    if (!shell_.next()) return false;
    const ShellSegment& s = segment();
    unknown_.emplace(known_, s, cloth_.volume->grid(),
                     cloth_.shell->isFlat() ? glm::mat3(1.0f) : cloth_.shell->tets()[s.tet].toCloth);
    last_ = -1;
    filled_ = 0;
    march_.emplace(*cloth_.volume, s.clothOrigin, s.clothDirection, s.tEnter, s.tLeave + rules_.farthest_mm);
    return true;
  }

  /// The axes lie ahead of the light: u is where they are, t where the light is. False where none is in the voxel while
  /// the light is in the segment.
  bool enterVoxel() {
    constexpr float kFullest = 0.9f;  // of space; no gap is so narrow that light could not be in it
    const ShellSegment& s = segment();
    float uEnter = march_->enter(), uLeave = march_->leave();
    const VoxelBox box = boxOf(content());
    clip(box, uEnter, uLeave);
    if (!(uEnter < uLeave)) return false;
    const float filledBefore = uEnter - last_ < 1e-5f ? filled_ : 0.0f;
    extinction = sumExtinction(cloth_.yarns, content(), s.drape, direction_, share());
    for (float* sum : {&extinction.total, &extinction.whole, &extinction.solid, &extinction.kept})
      *sum *= box.crowding();
    last_ = uLeave;
    filled_ = rules_.packing ? std::min(extinction.kept, kFullest) : 0.0f;
    ahead = std::min(0.5f * extinction.solid / extinction.whole, rules_.farthest_mm);
    const float start = std::max(uEnter, s.tEnter + ahead), stop = std::min(uLeave, s.tLeave + ahead);
    if (!(start < stop)) return false;
    t = s.passed + start - ahead;
    length = stop - start;
    near = std::clamp(uEnter + ahead - start, 0.0f, length);
    sigmaNear = extinction.total / (1 - filledBefore);
    sigma = extinction.total / (1 - filled_);
    return true;
  }

  /// To what of its way through the voxel goes through a box there.
  void clip(VoxelBox box, float& uEnter, float& uLeave) const {
    double enter = uEnter, leave = uLeave;
    for (int axis = 0; axis < 3; ++axis) {
      const double size = cloth_.volume->grid().size_mm[axis], way = segment().clothDirection[axis];
      if (way == 0) continue;
      const double corner = cloth_.volume->lower_mm()[axis] + content().voxel[axis] * size;
      const double a = (corner + box.lowerCorner()[axis] * size - segment().clothOrigin[axis]) / way;
      const double b = (corner + box.upperCorner()[axis] * size - segment().clothOrigin[axis]) / way;
      enter = std::max(enter, std::min(a, b));
      leave = std::min(leave, std::max(a, b));
    }
    uEnter = static_cast<float>(enter);
    uLeave = static_cast<float>(leave);
  }

  const TraceData& cloth_;
  LaneWalker::Rules rules_;
  const KnownFibres& known_;
  glm::vec3 direction_;
  ShellWalk shell_;
  std::optional<CorrelationState> unknown_;  ///< of the segment
  std::optional<ClothVolume::March> march_;
  float last_ = -1, filled_ = 0;  ///< where the voxel before ended, and how much of it is fibre
};

/// How a ray ends.
struct WalkEnd {
  bool met = false;
  float t_mm = 0;   ///< where it meets fibres
  float depth = 0;  ///< what is left of its depth where it meets none
  glm::ivec3 voxel{0};
};

inline WalkEnd loneWalk(const TraceData& cloth, const LaneWalker::Rules& rules, const DepthRay& ray) {
  WalkEnd end;
  end.depth = ray.depth;
  for (RayIntervals interval(cloth, rules, ray); interval.next();) {
    const float depth = interval.depth();
    if (end.depth >= depth) {
      end.depth -= depth;
      continue;
    }
    const float beyondNear = end.depth - interval.depthNear();
    end.met = true;
    end.t_mm =
        interval.t + (beyondNear < 0 ? end.depth / interval.sigmaNear : interval.near + beyondNear / interval.sigma);
    end.voxel = interval.content().voxel;
    end.depth = 0;
    return end;
  }
  return end;
}

}  // namespace loomlight::test
