#pragma once

#include <vector>

#include "render/scene/colouring.h"
#include "render/walk/walk_lanes.h"

namespace loomlight {

/// Up to kWalkLanes lights of one kind that paths have met (path_light.h), as columns of numbers. Lanes without a light
/// hold any numbers that are finite and not negative.
struct alignas(64) LightLanes {
  static constexpr int kNoFibre = -1;
  /// One number of each light, aligned as registers are loaded; so are the arrays below, which therefore come first.
  struct alignas(64) Column {
    LaneFloats lanes{};
  };

  LaneFloats radiance[3]{};
  LaneFloats modes[4]{};
  LaneFloats traverse_mm{}, inside{};
  LaneFloats colour[3]{};  ///< what they bring to the eye: colourLights() sets it

  std::vector<Column> lengths_mm;  ///< of each material
  int material = kNoFibre;         ///< of the fibres that sent them
  bool isWithin = false;           ///< whether any has gone through fibres; if not, lengths_mm is not read
};

/// Of each light what colourOf() says of it, to the bit, whatever instruction set the processor has. Some material is
/// known in bands.
void colourLights(LightLanes& lights, const Colouring& colouring);

}  // namespace loomlight
