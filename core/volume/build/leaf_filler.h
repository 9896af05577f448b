#pragma once

#include <array>
#include <vector>

#include "core/volume/build/moment_level.h"
#include "core/volume/build/voxel_frame.h"

namespace loomlight {

/// Follows the fibres of a yarn through the voxels of its brick, and leaves in each the moments of what lies there.
///
/// Where a strand crosses faces is found axis by axis, then the three lists are merged, and what lies between two
/// crossings is the difference of two sums along the strand. So there are hardly any branches but those of long loops:
/// how many voxels a segment crosses is what a processor cannot predict. Keeps its memory from brick to brick.
class LeafFiller {
 public:
  void fill(const CellStrands& strands, System system, const VoxelGrid& grid, MomentLevel& leaves);

 private:
  /// What is found at a point of a strand.
  struct Point {
    Float32x4 at;         ///< in the frame of voxels
    Float32x4 firstFace;  ///< where the segment to it first meets a face across an axis, 0..1
    Int32x4 voxel;
  };
  /// A strand comes to another voxel.
  struct Crossing {
    uint64_t when;   ///< number of the next point, and bits of how far to it, 0..1: in order along the strand
    int32_t offset;  ///< in this axis, of the voxel it comes to: MomentLevel::offsets
  };

  void reset(const CellStrands& strands, System system, const VoxelFrame& frame, const VoxelGrid& grid,
             MomentLevel& leaves);
  /// What both lines of a strand add up to.
  void sumUp(const CellStrands& strands, const CellStrands::Strand& strand, System system);
  /// One of two lines on opposite sides of a strand, with half its length each.
  void measure(const CellStrands& strands, const CellStrands::Strand& strand, float side, System system,
               VoxelFrame frame);
  /// Offsets are those of MomentLevel.
  void findCrossings(int axis, const int32_t* offsets);
  void follow(const CellStrands::Strand& strand, MomentLevel& leaves) const;

  // Of one strand:
  std::vector<Point> points_;
  std::vector<FibreMoments> sums_;  ///< up to each point
  Int32x4 crossingCounts_{};        ///< by axis
  std::array<std::vector<Crossing>, 3> crossings_;
};

}  // namespace loomlight
