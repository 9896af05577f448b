#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>

#include "core/volume/traverse/recent_cells.h"
#include "render/media/known_fibre.h"
#include "render/media/shell_walk.h"
#include "render/walk/walk_lanes.h"

namespace loomlight {

/// A ray that is to walk through draped cloth until it has used up an optical depth.
struct DepthRay {
  ScenePoint from;
  glm::vec3 direction{0, 0, -1};       ///< unit
  float tMax_mm = 0;                   ///< no farther than this
  float depth = 0;                     ///< optical depth that it may use up before it stops
  const KnownFibres* known = nullptr;  ///< of its path
  float clear_mm = 0;                  ///< so much of its way counts as empty
};

/// The bricks of cells that were asked for of late. For one thread.
class CellCache {
 public:
  explicit CellCache(const TraceData& cloth) : cloth_(cloth) {}
  const ClothVolume::CellBricks& bricksIn(glm::ivec3 cell) { return at(cell).bricks; }
  /// Fills in the bricks of a cell as a lane has them.
  void fill(glm::ivec3 cell, CellLanes& lanes, size_t lane);

 private:
  /// What CellLanes has of a brick beside those of ClothVolume::CellBricks.
  struct Yarn {
    int32_t number;
    float radius_mm, packed, separation;
  };
  struct Known {
    glm::ivec3 cell{-1};
    ClothVolume::CellBricks bricks;
    std::array<Yarn, CellLanes::kSlots> yarns;
  };
  const Known& at(glm::ivec3 cell) {
    return cells_.at(cell, [&](Known& known) { find(cell, known); });
  }
  void find(glm::ivec3 cell, Known& known) const;

  const TraceData& cloth_;
  RecentCells<Known> cells_;
};

/// Where a ray has used up its depth: it meets a fibre whose axis is in this voxel.
struct FoundFibres {
  size_t ray = 0;          ///< the number of the ray
  float t_mm = 0;          ///< where the light is, from where the ray began
  int tet = -1;            ///< of the shell, there
  LocalDrape drape;        ///< there
  glm::ivec3 cell{0};      ///< of the weave
  glm::ivec3 voxel{0};     ///< counted from the corner of the cell
  glm::vec3 inCell_mm{0};  ///< where the light is, cloth space, from that corner
  float ahead_mm = 0;      ///< distance by which the axes of fibres lie ahead of the light: c of LoomlightMedium
  float toMiddle_mm = 0;   ///< along the ray, from the light to the middle of its way through the voxel
  float whole = 0;         ///< extinction of all, as FoundLanes has it, 1/mm
  int component = 0;       ///< of the voxel, as FoundLanes has it
  int slot = 0;            ///< the brick of the cell in which that is
};

/// Hears how rays end, by their numbers.
class DepthRayEnds {
 public:
  virtual ~DepthRayEnds() = default;
  /// Where to put what a ray has found; it is filled in by the time that the walk is over.
  virtual FoundFibres& found(size_t ray) = 0;
  /// So much is left of its depth where it leaves the cloth, or comes to tMax; `tet`: where that was.
  virtual void left(size_t ray, float depth, int tet) = 0;
};

/// Lets many rays walk through the cloth side by side (walk_lanes.h). A lane whose ray has ended takes the next, so all
/// are busy while there are rays. What this does for itself is what happens once in a while: a ray comes into another
/// cell of the weave, or another tetrahedron of the shell. For one thread; the cloth must outlive it.
class LaneWalker {
 public:
  LaneWalker(const TraceData& cloth, const WalkRules& rules);

  /// All of them to their ends, in any order. Returns in how many voxels with content they used up depth.
  uint64_t walk(std::span<const DepthRay> rays, DepthRayEnds& ends);

  const WalkField& field() const { return field_; }
  CellCache& cells() { return cells_; }

 private:
  /// What a lane's ray is, beside its columns.
  struct Ray {
    size_t number = 0;
    int tet = -1;
    std::optional<ShellWalk> shell;
    std::optional<ClothVolume::CellMarch> march;
    glm::vec3 toBefore_mm{0};       ///< from its origin to the axis of the fibre before, cloth space
    glm::ivec3 slotsOf{-1};         ///< the cell whose bricks its columns have
    bool pastSegmentsTold = false;  ///< its columns have the flights before
  };
  bool take(size_t lane, std::span<const DepthRay> rays, DepthRayEnds& ends);
  bool enterSegment(size_t lane, const DepthRay& ray);
  void enterCell(size_t lane);
  bool leaveCell(size_t lane);
  void tellFound(size_t lane, DepthRayEnds& ends);

  const TraceData& cloth_;
  WalkField field_;
  std::unique_ptr<WalkLanes> lanes_;
  std::array<Ray, kWalkLanes> rays_;
  CellCache cells_;
  size_t next_ = 0;  ///< the first ray that no lane has taken yet
};

}  // namespace loomlight
