#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/base/task.h"
#include "core/volume/build/voxel_grid.h"
#include "core/volume/build/voxelise.h"
#include "core/volume/tiles/tile_map.h"
#include "core/volume/traverse/preview_sink.h"

namespace loomlight {

struct VolumeCounts {
  size_t bricks = 0;               ///< distinct ones stored
  size_t voxels = 0;               ///< occupied leaves in distinct bricks
  size_t components = 0;           ///< in those
  size_t bytes = 0;                ///< bricks, tile map and tables: all that the volume keeps
  size_t segments = 0;             ///< fibre segments that were voxelised, once per distinct brick
  double segmentsRepresented = 0;  ///< by the whole piece of cloth, whose uneven yarns have an average of all stretches
};

/// A voxel that a ray crosses, as the traversal shows it to its visitor: up to six spans, of different yarns.
struct VoxelContent {
  static constexpr int kMaxSpans = 6;  ///< warp and weft of the cell itself, and their neighbours on either side
  struct YarnSpan {
    std::span<const Component> components;
    System system;
    int index;  ///< which end (warp) or pick (weft), absolute
    int yarn;   ///< index into Fabric::yarns
  };
  glm::ivec3 voxel;       ///< coordinates in the whole cloth, in voxels of the volume's grid
  int pick = 0, end = 0;  ///< the crossing cell
  int count = 0;
  YarnSpan spans[kMaxSpans];
};

/// A flat piece of cloth as a volume: a map from cells to shared, immutable bricks, one of the warp and one of the weft
/// in each cell. Cloth coordinates in mm as in ClothGeometry. Memory is bounded by one repeat and its distinct bricks,
/// never by the size of the cloth.
class ClothVolume {
 public:
  /// Builds the volume, reusing the bricks of `previous` (may be null) where grid, yarns and keys agree, and what its
  /// tile maps have in common with the new ones. The same, brick for brick, as without. Returns null when
  /// stopped. Throws InputError where the distinct bricks would take more than kMaxBytes. `look` (may be null) is shown
  /// a first volume when every cell in view has a brick of its shape in any phase and stretch, and a second when every
  /// cell in view has its own, as far as it wants them; cells out of view come last. The volume is the same without.
  static std::shared_ptr<const ClothVolume> build(std::shared_ptr<const ClothGeometry> geometry, int resolution,
                                                  const Task& task, const ClothVolume* previous = nullptr,
                                                  const PreviewSink* look = nullptr);
  /// A volume for a first look at these crossings of the piece, of the fewest bricks: all cells have one, those that
  /// are seen one of their shape, though it may be of another phase or stretch. It cannot be a `previous`. Null when
  /// stopped.
  static std::shared_ptr<const ClothVolume> sketch(std::shared_ptr<const ClothGeometry> geometry, int resolution,
                                                   const CellRect& inView, const Task& task,
                                                   const ClothVolume* previous = nullptr);
  static constexpr size_t kMaxBytes = size_t{4} << 30;
  /// The same cloth in voxels 2^level leaves wide, each the sum of what its leaves hold: the mixtures of the report's
  /// octree, made when asked for. Null when stopped.
  std::shared_ptr<const ClothVolume> atLevel(int level, const Task& task) const;

  ClothVolume(const ClothVolume&) = delete;
  ClothVolume& operator=(const ClothVolume&) = delete;

  const ClothGeometry& geometry() const { return *geometry_; }
  const VoxelGrid& grid() const { return grid_; }
  VolumeCounts counts() const;
  /// Bytes that this volume takes where `other` is there anyway: what they share is free. What lies elsewhere in the
  /// other's tile map may count though it is shared.
  size_t bytesBeside(const ClothVolume& other) const;
  /// Of the whole piece. Costs what there are shapes of cells.
  ClothMeasures measure() const { return geometry_->measure({tiles_[0].cellCounts(), tiles_[1].cellCounts()}); }
  size_t bricksVoxelised() const { return bricksVoxelised_; }           ///< to make it; the others were there before
  glm::vec3 lower_mm() const { return {0.0f, 0.0f, grid_.zLower_mm}; }  ///< bounds of the whole piece
  glm::vec3 upper_mm() const;

  /// The brick of a yarn in a cell of the piece: 0 <= pick < picks, 0 <= end < ends. Cells of equal keys have the very
  /// same one, and volumes that share it too.
  BrickView brick(System system, int pick, int end) const;

  /// The part of a ray that lies in the piece.
  class RayInPiece;
  /// The voxels with content that a ray crosses, in order. Only tests define it: pictures are walked in lanes.
  class March;
  // For those who let many rays march side by side (render/walk), in plain numbers:
  /// A ray that comes into the piece and goes from cell to cell.
  class CellMarch;
  /// The bricks that reach into a cell.
  struct CellBricks;
  CellBricks bricksIn(glm::ivec3 cell) const;
  /// A point of the piece.
  struct PlaceInVoxel {
    glm::ivec3 cell;
    glm::ivec3 voxel;   ///< counted from the corner of the cell
    glm::vec3 inVoxel;  ///< in widths of the voxel, from the corner of that
  };
  /// The point that is so far from the corner of a cell; nullopt outside the piece.
  std::optional<PlaceInVoxel> locate(glm::ivec3 cell, glm::vec3 inCell_mm) const;
  const BrickBlock* blocks() const { return blocks_; }
  const Component* components() const { return components_; }

  /// What the voxel around a point holds; nothing (count 0) outside the piece.
  void contentAt(glm::vec3 cloth_mm, VoxelContent& content) const;

 private:
  /// A brick that reaches into the current cell.
  struct Reach {
    const BrickPool::Entry* brick;
    const BrickBlock* block;  ///< of the current 4 x 4 x 4 voxels; null where the brick has none
    glm::ivec3 shift;         ///< from blocks of the cell to those of the brick
    System system;
    int index, yarn;
  };
  struct Reaches {
    int count = 0;
    Reach entries[VoxelContent::kMaxSpans];
  };
  /// A brick that is missing.
  struct MissingBrick {
    TileMap* tiles;
    TileMap::Kind kind;
  };
  /// All that are missing, in the order in which a first look wants them: as TileMap::Wanted.
  struct Wanted {
    std::vector<MissingBrick> bricks;
    size_t sketch = 0, seen = 0;
  };
  ClothVolume(std::shared_ptr<const ClothGeometry> geometry, VoxelGrid grid, std::shared_ptr<BrickPool> pool);
  /// Has its maps, and the bricks of `previous` (may be null) that serve; null when stopped.
  static std::shared_ptr<ClothVolume> begin(std::shared_ptr<const ClothGeometry> geometry, int resolution,
                                            const Task& task, const ClothVolume* previous);
  /// A copy that is complete, with bricks that stand in for those that are missing.
  std::shared_ptr<const ClothVolume> completed() const;
  /// Makes the maps out of those of `previous`, where that costs less than to read them; false where it does not.
  bool editTiles(const ClothVolume& previous, const Task& task);
  /// Reads the maps; shares with those of `previous` (may be null) what is the same.
  void readTiles(const ClothVolume* previous, const Task& task);
  /// Takes the bricks of `previous` that are those of this volume too.
  void reuseBricks(const ClothVolume& previous);
  Wanted wanted(const CellRect& inView);
  /// False when stopped. `done` of `all` have been made before.
  bool makeBricks(std::span<const MissingBrick> bricks, size_t done, size_t all, const Task& task);
  /// visit(const BrickPool::Entry&, how many cells of the piece have it).
  template <class Visit>
  void forEachBrick(const Visit& visit) const;
  size_t brickBytes() const;

  /// All bricks with voxels in a cell of the piece.
  void gather(int pick, int end, Reaches& reaches) const;
  void gather(System system, int across, int along, Reaches& reaches) const;
  /// Goes to a block of the cell; which of its voxels hold anything.
  uint64_t openBlock(Reaches& reaches, glm::ivec3 block) const;
  /// Fills in count and spans: a voxel of the open block.
  void look(const Reaches& reaches, int voxel, VoxelContent& content) const;
  static int numberInBlock(glm::ivec3 v) { return (v.x & 3) | (v.y & 3) << 2 | (v.z & 3) << 4; }

  std::shared_ptr<const ClothGeometry> geometry_;
  VoxelGrid grid_;
  std::shared_ptr<BrickPool> pool_;
  const BrickBlock* blocks_ = nullptr;     ///< the pool's
  const Component* components_ = nullptr;  ///< the pool's
  glm::ivec3 blocksPerCell_{1};
  glm::dvec3 cell_mm_{1};                ///< pitches, and the thickness of all layers
  glm::dvec3 perCell_{1}, perVoxel_{1};  ///< 1 / cell_mm_, 1 / voxel_mm_
  glm::dvec3 voxel_mm_{1};  ///< grid().size_mm unrounded: cells of a wide cloth must not drift against the geometry's
  glm::ivec3 cells_{1};     ///< ends, picks, 1
  std::array<TileMap, 2> tiles_;
  size_t bricksVoxelised_ = 0;
};

}  // namespace loomlight

#include "core/volume/traverse/cloth_volume_cells.h"
#include "core/volume/traverse/cloth_volume_rays.h"
