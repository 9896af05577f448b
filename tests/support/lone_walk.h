#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "render/media/lane_walker.h"
#include "tests/support/voxel_extinction.h"
#include "tests/support/voxel_march.h"

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

  float share(const VoxelFibres& component, glm::vec3 point, glm::ivec3 voxel) const {
    const FibreDistribution& fibres = component.fibres;
    const float radius_mm = component.optics->fibreRadius_mm;
    float absent = 0;
    for (const RaySegment& past : memory_.pastSegments)
      if (past.length_mm > 0)
        absent = std::max(absent, knownAbsent(past, point, fibres.direction, fibres.spread, radius_mm));
    float before = 0;
    if (memory_.before.radius_mm > 0 && component.yarnId() == memory_.before.yarnId && component.optics->packed)
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

  float operator()(const VoxelFibres& component) const {
    return unknown ? unknown->share(component, middle, voxel) : 1.0f;
  }
};

/// A ray on its way through voxels with content, in order. In each it has a stretch for each component: where the axes
/// are that it goes by.
class VoxelsOnRay {
 public:
  VoxelsOnRay(const TraceData& cloth, const WalkRules& rules, const DepthRay& ray)
      : cloth_(cloth),
        rules_(rules),
        known_(*ray.known),
        clear_mm_(ray.clear_mm),
        direction_(ray.direction),
        shell_(cloth, ray.from, ray.direction, ray.tMax_mm) {}

  /// False where nothing is left.
  bool next() {
    while (!march_ || !march_->next())
      if (!enterSegment()) return false;
    enterVoxel();
    return true;
  }

  // Of the voxel where it stands, until it goes on:
  double ahead = 0;  ///< of the light, the axes: c
  const VoxelContent& content() const { return march_->content(); }
  const ShellSegment& segment() const { return shell_.segment(); }

  /// The depth that light has used up in the voxel when the axes that it goes by are at u.
  double depthTo(double u) const {
    double depth = 0;
    for (const Stretch& s : stretches_) {
      const double start = std::max(s.enter, lightStart_ + ahead);
      const double stop = std::min({s.leave, segment().tLeave + ahead, u});
      // Until the light is in the stretch itself, gaps are as wide as in the voxel before.
      const double turn = std::clamp(s.enter + ahead, start, std::max(start, stop));
      depth += s.sigma / (1 - s.filledBefore) * (turn - start) + s.sigma / (1 - s.filled) * std::max(0.0, stop - turn);
    }
    return depth;
  }
  double enter() const { return march_->enter(); }
  double leave() const { return march_->leave(); }

 private:
  struct Stretch {
    double enter, leave, sigma, kept, filled = 0, filledBefore = 0;
  };

  bool enterSegment() {
    if (!shell_.next()) return false;
    const ShellSegment& s = segment();
    lightStart_ = std::max(s.tEnter, clear_mm_ - s.passed);
    unknown_.emplace(known_, s, cloth_.volume->grid(),
                     cloth_.shell->isFlat() ? glm::mat3(1.0f) : cloth_.shell->tets()[s.tet].toCloth);
    last_ = -1;
    filled_ = 0;
    march_.emplace(*cloth_.volume, s.clothOrigin, s.clothDirection, lightStart_, s.tLeave + rules_.farthest_mm);
    return true;
  }

  void enterVoxel() {
    constexpr double kFullest = 0.9;  // of space; no gap is so narrow that light could not be in it
    const glm::vec3 middle = segment().origin + 0.5f * (march_->enter() + march_->leave()) * direction_;
    const CorrelatedShare share{rules_.hotSpot ? &*unknown_ : nullptr, middle, content().voxel};
    stretches_.clear();
    double whole = 0, solid = 0, kept = 0, first = leave(), last = enter();
    forEachComponent(cloth_.yarns, content(), segment().drape, [&](const VoxelFibres& component) {
      const VoxelBox box = rules_.boxes ? component.box : VoxelBox();
      const double r = component.optics->fibreRadius_mm, crowding = box.crowding();
      const double inside = kPi * r * r * component.fibres.lengthDensity * crowding;
      const double sigma = extinction(component.fibres, *component.optics, direction_) * crowding;
      whole += sigma;
      solid += inside;
      Stretch stretch{enter(), leave(), sigma * share(component), inside * component.optics->separation};
      if (!clip(box, stretch)) return;
      kept += stretch.kept * (stretch.leave - stretch.enter);
      first = std::min(first, stretch.enter);
      last = std::max(last, stretch.leave);
      stretches_.push_back(stretch);
    });
    ahead = std::min(0.5 * solid / whole, static_cast<double>(rules_.farthest_mm));
    if (stretches_.empty()) return;
    double filledAtEnd = 0;
    for (Stretch& s : stretches_) {
      if (rules_.packing) s.filled = std::min(std::max(s.kept, kept / (last - first)), kFullest);
      if (s.enter - last_ < 1e-5) s.filledBefore = filled_;
      if (rules_.packing && last - s.leave < 1e-5) filledAtEnd += s.kept;
    }
    last_ = last;
    filled_ = std::min(filledAtEnd, kFullest);
  }

  /// To what of its way through the voxel goes through a box there; false where nothing does.
  bool clip(VoxelBox box, Stretch& stretch) const {
    if (box == VoxelBox()) return stretch.enter < stretch.leave;
    for (int axis = 0; axis < 3; ++axis) {
      const double size = cloth_.volume->grid().size_mm[axis], way = segment().clothDirection[axis];
      if (way == 0) continue;
      const double corner = cloth_.volume->lower_mm()[axis] + content().voxel[axis] * size;
      const double a = (corner + box.lowerCorner()[axis] * size - segment().clothOrigin[axis]) / way;
      const double b = (corner + box.upperCorner()[axis] * size - segment().clothOrigin[axis]) / way;
      stretch.enter = std::max(stretch.enter, std::min(a, b));
      stretch.leave = std::min(stretch.leave, std::max(a, b));
    }
    return stretch.enter < stretch.leave;
  }

  const TraceData& cloth_;
  WalkRules rules_;
  const KnownFibres& known_;
  float clear_mm_;
  float lightStart_ = 0;  ///< where the light is in the segment, from the segment's origin
  glm::vec3 direction_;
  ShellWalk shell_;
  std::optional<CorrelationState> unknown_;  ///< of the segment
  std::optional<ClothVolume::March> march_;
  std::vector<Stretch> stretches_;
  double last_ = -1, filled_ = 0;  ///< where the fibres before ended, and how much of the space there is fibre
};

/// How a ray ends.
struct WalkEnd {
  bool met = false;
  float t_mm = 0;   ///< where it meets fibres
  float depth = 0;  ///< what is left of its depth where it meets none
  glm::ivec3 voxel{0};
};

inline WalkEnd loneWalk(const TraceData& cloth, const WalkRules& rules, const DepthRay& ray) {
  WalkEnd end;
  double left = ray.depth;
  for (VoxelsOnRay voxel(cloth, rules, ray); voxel.next();) {
    double low = voxel.enter(), high = voxel.leave();
    const double depth = voxel.depthTo(high);
    if (left >= depth) {
      left -= depth;
      continue;
    }
    for (int i = 0; i < 60; ++i) {  // halves the way down to a rounding
      const double middle = 0.5 * (low + high);
      (voxel.depthTo(middle) <= left ? low : high) = middle;
    }
    end.met = true;
    end.t_mm = static_cast<float>(voxel.segment().passed + low - voxel.ahead);
    end.voxel = voxel.content().voxel;
    return end;
  }
  end.depth = static_cast<float>(left);
  return end;
}

}  // namespace loomlight::test
