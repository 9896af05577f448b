#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>

#include "render/media/loomlight_medium.h"

namespace loomlight {

/// Makes collisions of what rays have found in the voxels of LoomlightMedium, eight rays side by side: where the axis
/// of the fibre lies, of which component it is, and its tangent. For one thread; the medium and the walker must outlive
/// it.
class LoomlightMeetings {
 public:
  static constexpr size_t kMost = 8;
  /// A ray of a path that has found fibres.
  struct Meeting {
    const FoundFibres* found = nullptr;
    const ScenePoint* from = nullptr;  ///< where the ray began
    glm::vec3 direction{0, 0, -1};
    Random* random = nullptr;
    LoomlightMedium::Memory* memory = nullptr;  ///< of the path; how the fibre was met is kept in it
    std::optional<Collision>* met = nullptr;    ///< takes the collision
  };

  LoomlightMeetings(const LoomlightMedium& medium, LaneWalker& walker);

  /// At most kMost. What becomes of one does not depend on the others.
  void meet(std::span<const Meeting> meetings);

 private:
  using Lanes = Float32x8;
  using Mask = MaskOf<Lanes>;
  using Vectors = Vec3Of<Lanes>;
  /// Which fibres each meeting is with.
  struct Fibres;
  void lookForAxes(std::span<const Meeting> meetings, const Vectors& direction, RandomLanes<Lanes>& random);
  /// Of a voxel, in widths of it; empty where an edge of `upper` is not beyond that of `lower`.
  struct VoxelPart {
    glm::vec3 lower{0}, upper{1};
  };
  VoxelPart commonPart(const Meeting& meeting);
  Vectors axisAfter(std::span<const Meeting> meetings, const Vectors& shift) const;
  Mask lookThere(std::span<const Meeting> meetings, size_t point, const Vectors& axis);
  void wantLook(const Meeting& meeting, size_t lane, glm::vec3 axis_mm);
  ClothVolume::PlaceInVoxel placeOfAxis(const Meeting& meeting, size_t lane) const;
  void chooseFibres(std::span<const Meeting> meetings);
  void wantChoice(const Meeting& meeting, size_t lane, const ClothVolume::PlaceInVoxel& place);
  void fill(VoxelPlaceLanes& lanes, size_t lane, const ClothVolume::PlaceInVoxel& place, const Meeting& meeting);
  void take(const Meeting& meeting, size_t lane, Fibres& fibres);
  void tell(const Meeting& meeting, size_t lane, const Vectors& tangent, float offset, const Vectors& inwards) const;

  const LoomlightMedium& medium_;
  const TraceData& cloth_;
  LaneWalker& walker_;
  std::unique_ptr<LookLanes> looks_;  ///< of each meeting one from its first point, then one from its second
  std::array<ClothVolume::PlaceInVoxel, kWalkLanes> lookPlaces_{};
  std::unique_ptr<ChoiceLanes> choices_;  ///< one of each meeting
  // Of one call:
  static constexpr int kAmongAll = -1;  ///< without a look: the axis is where all the components are that were found
  static constexpr int kNone = -2;      ///< neither point led to any fibres: the axis is as far ahead as in the mean
  /// The component that a meeting is with, and the brick of a cell in which that is.
  struct Met {
    glm::ivec3 cell{0};
    int component = 0, slot = 0;
  };
  std::array<Met, kMost> met_{};
  std::array<VoxelPart, kMost> common_{};  ///< where in the voxels that were found all their components are
  std::array<Vectors, 2> points_{};        ///< the two that axes were looked for by, the one that was taken first
  Lanes takenLook_{};                      ///< the look that found the axis, or kAmongAll, or kNone
  Mask amongAll_{};                        ///< both points led to where all the components are that were found
};

}  // namespace loomlight
