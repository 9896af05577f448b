#pragma once

#include <array>
#include <vector>

#include "core/volume/build/fibre_moments.h"

namespace loomlight {

/// Makes components of the fibres of many voxels, so that their lengths add up to that of the fibres: what rounding a
/// length density takes from some is given to others, a few parts in a thousand of them at most. What is left is the
/// rounding of the shortest. The order of add() is part of the result.
class ComponentEncoder {
 public:
  ComponentEncoder();

  /// Of fibres whose length is > 0, and which lie in this part of a voxel of that volume.
  void add(const FibreMoments& moments, double volume_mm3, VoxelBox box);
  size_t count() const { return encoded_.size() + static_cast<size_t>(inBatch_); }  ///< added since the last take()
  /// One component for each add(), in that order; those too thin for a length density have 0. Starts anew.
  std::vector<Component> take();

 private:
  struct Encoded {
    Component component;
    double volume_mm3;
    double lost_mm;  ///< length of the fibres less that of the component
    int next;        ///< of the same class; -1 is none
  };
  /// Components by powers of two of their length.
  static constexpr int kClasses = 64;

  void encodeBatch();
  void giveBack();
  template <class MayTake>
  void give(double maxSteps, const MayTake& mayTake);

  FitBatch batch_;
  std::array<double, kFitBatch> volumes_mm3_;
  std::array<VoxelBox, kFitBatch> boxes_;
  int inBatch_ = 0;
  std::vector<Encoded> encoded_;
  std::array<int, kClasses> first_;  ///< of each class
  double lost_mm_ = 0;               ///< of all components
};

inline void ComponentEncoder::add(const FibreMoments& moments, double volume_mm3, VoxelBox box) {
  batch_[inBatch_] = moments;
  volumes_mm3_[inBatch_] = volume_mm3;
  boxes_[inBatch_] = box;
  if (++inBatch_ == kFitBatch) encodeBatch();
}

}  // namespace loomlight
