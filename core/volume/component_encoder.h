#pragma once

#include <vector>

#include "core/volume/fibre_moments.h"

namespace loomlight {

/// Makes components of the fibres of many voxels so that their lengths add up to that of the fibres:
/// what rounding a length density takes from some is given to others, a few parts in a thousand of them at most. What
/// is left is the rounding of the shortest. The order of add() is part of the result.
class ComponentEncoder {
 public:
  /// length > 0.
  void add(const FibreMoments& moments, double volume_mm3, int material);
  /// One component for each add(), in that order; those too thin for a length density have 0.
  std::vector<Component> take();

 private:
  void encodeBatch();
  void giveBack();

  FitBatch batch_;
  std::array<double, kFitBatch> batchVolumes_mm3_;
  std::array<int, kFitBatch> batchMaterials_;
  int inBatch_ = 0;
  std::vector<Component> components_;
  struct Rounded {
    double volume_mm3;
    double lost_mm;  ///< length of the fibres less that of their component
  };
  std::vector<Rounded> rounded_;  ///< of each component
};

}  // namespace loomlight
