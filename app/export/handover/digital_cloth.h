#pragma once

#include <optional>

#include "app/export/handover/side_maps.h"
#include "app/export/handover/surface_fit.h"
#include "core/base/units.h"

namespace loomlight {

/// One side of a cloth as other programs are told of it.
struct DigitalSide {
  SideMaps maps;
  SurfaceFit fit;
  std::vector<float> roughnessScales;  ///< of each yarn (surface_samples.h)
  Rgb tileOverMeasured{1};             ///< mean colour of the tile over that of the piece that was measured
};

/// A cloth for hand-over: both sides of its tile, and the surfaces that were fitted to them.
struct DigitalCloth {
  Fabric fabric;
  TileExtent extent;
  ClothMeasures measures;
  DigitalSide front, back;

  const DigitalSide& of(ClothSide side) const { return side == ClothSide::front ? front : back; }
  double width_mm() const { return extent.ends * fabric.warpPitch_mm(); }
  double height_mm() const { return extent.picks * fabric.weftPitch_mm(); }
  double dpiX() const { return kMmPerInch * front.maps.tile.width / width_mm(); }
  double dpiY() const { return kMmPerInch * front.maps.tile.height / height_mm(); }
};

struct DigitalClothOrder {
  int longestSide = 0;  ///< pixels; 0: usualTileSide()
  bool joinTwist = true;
  int measuringSamples = 512;  ///< paths for each camera of the half-domes
  int fitSamples = 64;         ///< pixels that stand for all in the fit
};

/// Traces, measures and fits. Nothing when stopped. `limit_bytes`: of explicit fibres, and of the pictures. Throws
/// InputError; where they take more memory, before the long work.
std::optional<DigitalCloth> makeDigitalCloth(const Fabric& fabric, const DigitalClothOrder& order, double limit_bytes,
                                             const Task& task);

}  // namespace loomlight
