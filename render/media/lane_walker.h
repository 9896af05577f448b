#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>

#include "core/volume/traverse/recent_cells.h"
#include "render/media/cloth_walk.h"
#include "render/media/known_fibre.h"
#include "render/walk/walk_lanes.h"

namespace loomlight {

/// What a path knows of the fibres around it.
struct KnownFibres {
  KnownFibre leaving, before;                ///< the last fibre that it met, and the one before
  std::array<RaySegment, 2> pastSegments{};  ///< to both, the newest first
};

/// A ray that is to walk through draped cloth until it has used up an optical depth.
struct DepthRay {
  ScenePoint from;
  glm::vec3 direction{0, 0, -1};       ///< unit
  float tMax_mm = 0;                   ///< no farther than this
  float depth = 0;                     ///< optical depth that it may use up before it stops
  const KnownFibres* known = nullptr;  ///< of its path
};

/// The bricks of cells that were asked for of late. For one thread.
class CellCache {
 public:
  explicit CellCache(const ClothVolume& volume) : volume_(volume) {}
  const ClothVolume::CellBricks& bricksIn(glm::ivec3 cell) {
    return cells_.at(cell, [&](ClothVolume::CellBricks& bricks) { bricks = volume_.bricksIn(cell); });
  }
  /// What the voxel around a point of cloth space holds; nothing outside of the piece.
  void contentAt(glm::vec3 cloth_mm, VoxelContent& content);

 private:
  const ClothVolume& volume_;
  RecentCells<ClothVolume::CellBricks> cells_;
};

/// Where a ray has used up its depth: it meets a fibre whose axis is in this voxel.
struct FoundFibres {
  const ShellSegment& segment;
  const VoxelContent& content;
  float t_mm;        ///< where the light is, from where the ray began
  float ahead_mm;    ///< distance by which the axes of fibres lie ahead of the light: c of LoomlightMedium
  float whole;       ///< extinction of the voxel, 1/mm
  glm::vec3 middle;  ///< of the ray in the voxel, world
  CellCache& cells;  ///< to look around in
};

/// Hears how rays end, by their numbers.
class DepthRayEnds {
 public:
  virtual ~DepthRayEnds() = default;
  virtual void found(size_t ray, const FoundFibres& fibres) = 0;
  /// So much is left of its depth where it leaves the cloth, or comes to tMax; `tet`: where that was.
  virtual void left(size_t ray, float depth, int tet) = 0;
};

/// Lets many rays walk through the cloth side by side (walk_lanes.h). A lane whose ray has ended takes the next, so all
/// are busy while there are rays. What this does for itself is what happens once in a while: a ray comes into another
/// cell of the weave, or another tetrahedron of the shell. For one thread; the cloth must outlive it.
class LaneWalker {
 public:
  struct Rules {
    float farthest_mm = 0;  ///< no axis is looked for farther ahead of the light
    bool packing = true;    ///< light keeps to the gaps between fibres that do not overlap
    bool hotSpot = true;    ///< what is known of fibres counts
  };
  LaneWalker(const TraceData& cloth, const Rules& rules);

  /// All of them to their ends, in any order. Returns how many stretches of voxels with content they went along.
  uint64_t walk(std::span<const DepthRay> rays, DepthRayEnds& ends);

 private:
  /// What a lane's ray is, beside its columns.
  struct Ray {
    size_t number = 0;
    int tet = -1;
    std::optional<ShellWalk> shell;
    std::optional<ClothVolume::CellMarch> march;
    glm::dvec3 before_mm{0};        ///< axis of the fibre before, cloth space
    glm::ivec3 slotsOf{-1};         ///< the cell whose bricks its columns have
    bool pastSegmentsTold = false;  ///< its columns have the flights before
  };
  bool take(size_t lane, std::span<const DepthRay> rays, DepthRayEnds& ends);
  bool enterSegment(size_t lane, const DepthRay& ray);
  void enterCell(size_t lane);
  bool leaveCell(size_t lane);
  void setPastSegments(size_t lane, const DepthRay& ray);
  void setBefore(size_t lane, const DepthRay& ray);
  void tellFound(size_t lane, const DepthRay& ray, DepthRayEnds& ends);

  const TraceData& cloth_;
  WalkField field_;
  std::unique_ptr<WalkLanes> lanes_;
  std::array<Ray, kWalkLanes> rays_;
  CellCache cells_;
  size_t next_ = 0;  ///< the first ray that no lane has taken yet
};

}  // namespace loomlight
