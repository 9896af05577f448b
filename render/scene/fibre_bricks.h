#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/volume/traverse/cloth_volume.h"
#include "core/volume/traverse/recent_cells.h"
#include "render/scene/fibre_hit.h"

namespace loomlight {

class EmbreeDevice;

/// The fibres of a cloth's yarns, laid once for all cells of a key, as voxels are: a brick of fibres is the strands of
/// a yarn in a cell, as round curves. So there are explicit fibres in cloth of any size and on every drape, for
/// the memory of the bricks that rays have come to. A brick is made when the first ray comes to it, which shows in
/// nothing but time. Serves every cloth of these yarns (YarnTable::sameShapes()), whatever its weave. Safe to ask from
/// many threads, each with a Reader of its own.
class FibreBricks {
 public:
  /// What a segment takes: measured 26 where strands are long, 31 where they are short.
  static constexpr size_t kBytesPerSegment = 31;
  /// What the bricks of a cloth may hold in all, were every one made: 1.9 GB.
  static constexpr size_t kMostSegments = 60'000'000;

  /// Why there are none of a volume: where all of its bricks would be more than kMostSegments. A sentence for who looks
  /// closely, empty where there are.
  static std::string whyNone(const VolumeCounts& counts);
  /// Null where there are none.
  static std::shared_ptr<const FibreBricks> of(const ClothVolume& volume,
                                               std::shared_ptr<const ClothGeometry> geometry);
  ~FibreBricks();
  FibreBricks(const FibreBricks&) = delete;
  FibreBricks& operator=(const FibreBricks&) = delete;

  size_t made() const;                                ///< bricks so far
  size_t bytes() const;                               ///< that they take
  float thinnest_mm() const { return thinnest_mm_; }  ///< diameter of the thinnest fibres

  class Reader;

 private:
  struct Brick;
  /// A brick, or where it will be.
  struct Slot;
  explicit FibreBricks(std::shared_ptr<const ClothGeometry> geometry);
  const Brick& brick(const YarnCellKey& key) const;
  std::unique_ptr<const Brick> make(const YarnCellKey& key) const;

  const std::shared_ptr<const ClothGeometry> geometry_;
  const float thinnest_mm_;
  mutable std::atomic<size_t> bytesOfCurves_{0};
  mutable std::once_flag started_;
  mutable std::unique_ptr<const EmbreeDevice> device_;  ///< from the first brick on
  mutable std::mutex mutex_;                            ///< over the map; what is in it stays
  mutable std::unordered_map<YarnCellKey, std::unique_ptr<Slot>, YarnCellKeyHash> bricks_;
};

/// A ray in cloth space, of any length of direction, which does not see the fibre that it leaves up to a parameter.
struct ClothRay {
  glm::vec3 origin{0}, direction{0, 0, -1};
  float t0 = 0, t1 = 0;   ///< the part of it that counts
  uint64_t ownFibre = 0;  ///< FibreHit::fibre; 0: none
  float ownUntil = 0;     ///< t
};

/// Asks for fibres; keeps in mind the cells that it was in of late. For one thread.
class FibreBricks::Reader {
 public:
  /// `volume`: of cloth whose yarns are those that the bricks are of, in any weave.
  Reader(const FibreBricks& bricks, const ClothVolume& volume) : bricks_(bricks), volume_(volume) {}

  /// The first fibre along it; the hit is in cloth space, and its distance is t. Surfaces are met from outside only.
  /// Cost: a ray into the tree of every brick that reaches into a cell on the way.
  std::optional<FibreHit> meet(const ClothRay& ray);
  /// Whether there is none.
  bool isFree(const ClothRay& ray);

 private:
  friend FibreBricks;
  struct Query;
  struct Cell {
    glm::ivec3 cell{-1};
    int count = 0;
    struct Reaching {
      const Brick* brick;
      glm::vec3 centre_mm;  ///< of its own cell, from the corner of this one
      System system;
      int end, pick;
    };
    std::array<Reaching, VoxelContent::kMaxSpans> bricks;
  };
  const Cell& at(glm::ivec3 cell);
  void gather(glm::ivec3 cell, Cell& reaching) const;
  /// visit(Cell, where the ray comes into it, counted from its corner, and t there and where it leaves) in each cell of
  /// the ray in turn, until that returns true.
  template <class Visit>
  void forEachCell(const ClothRay& ray, const Visit& visit);

  const FibreBricks& bricks_;
  const ClothVolume& volume_;
  RecentCells<Cell> cells_;
};

}  // namespace loomlight
