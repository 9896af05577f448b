#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/task.h"
#include "core/fabric/model/fabric.h"
#include "render/film/image.h"

namespace loomlight {

/// How well one way finds the length of fibre per volume in the voxels of a crossing. Fibres have a section: where a
/// fibre lies half in a voxel, so does its length.
struct DensityError {
  std::string method;
  double length_percent = 0;  ///< of the whole crossing: found too much, or too little
  double voxel_percent = 0;   ///< RMS against the fibres that each voxel really holds, over their RMS
  double fine_percent = 0;    ///< the same, against cubes of a quarter of a voxel: what the voxels blur as well
  double astray_percent = 0;  ///< share of what was found that lies in voxels without fibres
};

/// Fig. 4 of the report: the length density of Eqs. 2 to 5 against fibre counting (Moon et al. 2008, as section 6 of
/// the report has it).
struct DensityStudy {
  std::vector<DensityError> errors;  ///< ours, then counting in spheres of three sizes
  /// Across a warp yarn, from one voxel's face to another's.
  struct Sample {
    double x_um = 0;
    double exact = 0, ours = 0, counted = 0;  ///< 1/mm2; `exact` in slices of a quarter of a voxel
  };
  std::vector<Sample> line;
  Pixels8 section;  ///< across the same yarn: exact, ours, counted; the darker, the more fibres
};

/// Of a crossing in the middle of the cloth, away from its rim, where fibres of one cell go on in the next. Counting
/// takes each voxel's density from the number n of fibres that a sphere of radius R about its middle cuts, n / (pi R^2)
/// in length per volume: the mean chord of a sphere is 4 R / 3 (Eq. 4). The spheres are those within the voxel, those
/// about it, and those of twice its size; `counted` are those about it. nullopt when stopped.
std::optional<DensityStudy> studyDensity(const Fabric& fabric, int resolution, const Task& task);

}  // namespace loomlight
