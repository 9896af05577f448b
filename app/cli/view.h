#pragma once

#include <optional>
#include <string>

#include "core/fabric/model/fabric.h"
#include "core/shell/drape_mesh.h"

namespace loomlight {

/// A way to look at a piece of cloth, whatever its size and drape.
struct ViewChoice {
  double azimuth_deg = -90;
  double elevation_deg = 50;
  std::optional<double> distance_mm;  ///< from the middle of the piece; not given: as far as seeing all of it takes
  std::optional<double> seenPitches;  ///< a close-up: how many crossings fill the height of the picture
};

/// front, top, side, close or macro; nullopt for other names.
std::optional<ViewChoice> viewPreset(const std::string& name);
/// The names, for messages.
std::string viewPresetNames();

/// The camera that shows the fabric's cloth, lying on `drape`, as the view says, in pictures of the fabric's size.
/// Keeps the field of view.
Camera cameraOf(const ViewChoice& view, const Fabric& fabric, const DrapeMesh& drape);

}  // namespace loomlight
