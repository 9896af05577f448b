#pragma once

#include <cmath>
#include <limits>
#include <memory>
#include <unordered_map>
#include <vector>

#include "core/base/task.h"
#include "core/geometry/cloth_geometry.h"
#include "core/volume/brick.h"

namespace loomlight {

/// The voxel grid all bricks of a cloth share. Voxels need not be exact cubes: a cell holds a whole number of them.
struct VoxelGrid {
  glm::ivec3 cell{1};       ///< leaf voxels of one cell in x (across ends), y (across picks), z
  glm::vec3 size_mm{1.0f};  ///< of a leaf voxel
  float zLower_mm = 0;      ///< bottom of voxel layer 0
  int levels = 1;
  bool operator==(const VoxelGrid&) const = default;
};

/// `resolution` leaf voxels per (smallest) yarn diameter; the slab |z| <= halfThickness is covered.
VoxelGrid makeGrid(const ClothGeometry& geometry, int resolution);

/// Voxelises the fibres of one key; a pure function of its arguments.
Brick voxelise(const CellStrands& strands, System system, const VoxelGrid& grid, const ClothGeometry& geometry);

struct VolumeCounts {
  size_t bricks = 0;       ///< distinct ones stored
  size_t voxels = 0;       ///< occupied leaves in distinct bricks
  size_t components = 0;
  size_t bytes = 0;        ///< bricks, tile map and tables: all that the volume keeps
  size_t segments = 0;     ///< fibre segments that were voxelised, once per distinct brick
  double segmentsRepresented = 0;  ///< by the whole piece of cloth
};

/// A voxel that a ray crosses, as the traversal shows it to its visitor: up to six spans, of different yarns.
struct VoxelContent {
  struct Part {
    std::span<const Component> components;
    System system;
    int index;             ///< which end (warp) or pick (weft), absolute
  };
  glm::ivec3 voxel;        ///< leaf (or level) coordinates in the whole cloth; x and y may not be negative
  int pick = 0, end = 0;   ///< the crossing cell
  int count = 0;
  Part parts[6];
};

/// A flat piece of cloth as a volume: a map from cells to shared, immutable bricks, one of the warp and one of the weft
/// in each cell. Cloth coordinates in mm as in ClothGeometry. Copying shares everything; memory is bounded by the
/// distinct bricks, never by the size of the cloth.
class ClothVolume {
 public:
  /// Distinct bricks by key. Shared between volumes: an edit reuses what its keys already have.
  struct KeyHash {
    size_t operator()(const CellKey& key) const { return hash(key); }
  };
  using BrickMap = std::unordered_map<CellKey, std::shared_ptr<const Brick>, KeyHash>;

  /// Builds the volume, reusing the bricks of `previous` (may be null) where grid, yarns and keys agree. Returns null
  /// when stopped.
  static std::shared_ptr<const ClothVolume> build(std::shared_ptr<const ClothGeometry> geometry, int resolution,
                                                  const Task& task, const ClothVolume* previous = nullptr);

  const ClothGeometry& geometry() const { return *geometry_; }
  const VoxelGrid& grid() const { return grid_; }
  VolumeCounts counts() const;
  glm::vec3 lower_mm() const;  ///< bounds of the whole piece
  glm::vec3 upper_mm() const;

  const Brick& brick(System system, int pick, int end) const;

  /// Walks the voxels that the ray origin + t direction (cloth space, direction of any length) crosses for t in
  /// [t0, t1], in order. visit(const VoxelContent&, float tEnter, float tLeave) is called for voxels with content only
  /// and returns false to stop. True if the walk reached t1. `level` > 0 walks a coarser level of the octree.
  /// Cost per step: one table read per yarn in reach of the cell, paid on entering a cell; one block read per yarn.
  template <class Visit>
  bool march(glm::vec3 origin, glm::vec3 direction, float t0, float t1, Visit&& visit, int level = 0) const;

 private:
  ClothVolume() = default;
  // ... the shape of the tile map belongs to the implementation
  std::shared_ptr<const ClothGeometry> geometry_;
  VoxelGrid grid_;
};

}  // namespace loomlight
