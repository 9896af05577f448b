#pragma once

#include <optional>
#include <vector>

#include "app/export/handover/side_maps.h"
#include "app/export/handover/surface_fit.h"
#include "app/export/handover/surface_samples.h"

namespace loomlight {

/// What cameras on half-domes see of a flat patch of the cloth in parallel light (render/transport/half_dome.h).
struct MeasuredSide {
  std::vector<Observation> reflected;    ///< light from this side: 0, 30 and 60 degrees from its normal, four azimuths
  std::vector<Observation> transmitted;  ///< from the other side: 0 and 45 degrees
};
struct MeasuredSurface {
  MeasuredSide front, back;
};

/// `samples`: paths for each of the 128 cameras in each light. Nothing when stopped. Throws InputError.
std::optional<MeasuredSurface> measuredSurface(const Fabric& fabric, int samples, double limit_bytes, const Task& task);

/// The share of light along the normal that was seen in all directions together, from `seen`'s light along it: an
/// albedo, holes counted as black.
Rgb albedoAlongNormal(const std::vector<Observation>& seen);

/// Multiplied so that this albedo becomes `albedo`: cameras see a piece of some crossings, whose colours need not be
/// those of the whole tile. Black stays.
void scaleTo(const Rgb& albedo, std::vector<Observation>& seen);

/// Both sides, to the mean colours of their maps.
void scaleToMaps(const MeanColours& front, const MeanColours& back, MeasuredSurface& measured);

}  // namespace loomlight
